#include "bench/figure_table.h"

#include <iostream>

#include "bench/report.h"
#include "core/base/output.h"

namespace lasius::bench {

void Output::write(const std::string& text) {
  std::cout << text << std::flush;
  text_ += text;
  if (!file_.empty()) write_file(file_, [&](std::ostream& out) { out << text_; });
}

FigureTable::FigureTable(const std::string& heading, const std::string& file) : output_(file) {
  output_.write(machine_line() + ". " + heading + "\n\n| what | figure | aim |\n|---|--:|--:|\n");
}

void FigureTable::add(const std::vector<Figure>& figures) {
  for (const Figure& f : figures)
    output_.write("| " + f.what + " | " + f.value + " | " + f.aim + " |\n");
}

}  // namespace lasius::bench
