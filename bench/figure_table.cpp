#include "bench/figure_table.h"

#include <iostream>

#include "bench/report.h"

namespace lasius::bench {

Output::Output(const std::string& file) {
  if (!file.empty()) file_.open(file);
}

void Output::write(const std::string& text) {
  std::cout << text << std::flush;
  file_ << text << std::flush;
}

FigureTable::FigureTable(const std::string& heading, const std::string& file) : output_(file) {
  output_.write(machine_line() + ". " + heading + "\n\n| what | figure | aim |\n|---|--:|--:|\n");
}

void FigureTable::add(const std::vector<Figure>& figures) {
  for (const Figure& f : figures)
    output_.write("| " + f.what + " | " + f.value + " | " + f.aim + " |\n");
}

}  // namespace lasius::bench
