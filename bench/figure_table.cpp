#include "bench/figure_table.h"

#include <iostream>

#include "bench/report.h"

namespace lasius::bench {

FigureTable::FigureTable(const std::string& heading, const std::string& file) : file_(file) {
  write(machine_line() + ". " + heading + "\n");
  write("| what | figure | aim |\n|---|--:|--:|");
}

void FigureTable::add(const std::vector<Figure>& figures) {
  for (const Figure& f : figures) write("| " + f.what + " | " + f.value + " | " + f.aim + " |");
}

void FigureTable::write(const std::string& line) {
  std::cout << line << std::endl;
  file_ << line << std::endl;
}

}  // namespace lasius::bench
