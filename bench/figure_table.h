// Figures beside their aims, as the README states them.
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace lasius::bench {

/// One line of the table: what, how much, and what it should be.
struct Figure {
  std::string what, value, aim;
};

/// A table in Markdown on standard output, line by line as figures come.
class FigureTable {
 public:
  /// The machine and `heading` stand above it. All goes to `file` too, unless that is empty.
  FigureTable(const std::string& heading, const std::string& file);

  void add(const std::vector<Figure>& figures);

 private:
  void write(const std::string& line);

  std::ofstream file_;
};

}  // namespace lasius::bench
