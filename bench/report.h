// Text for people on standard output and in a file; tables, and comparisons, in Markdown.
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/comparison.h"

namespace lasius::bench {

/// CPU, compiler and version: what figures mean nothing without.
std::string machine_line();

/// A number with three significant digits, for tables.
std::string short_number(double value);

/// "| a | b |" and a line break.
std::string table_line(const std::vector<std::string>& cells);
/// "| name | 1.23 | 45.6 |" and a line break: figures as short_number() has them.
std::string table_line(const std::string& name, const std::vector<double>& figures);

/// Standard output, as text comes, and a file unless its name is empty.
class Output {
 public:
  explicit Output(std::string file = "") : file_(std::move(file)) {}
  void write(const std::string& text);

 private:
  std::string file_, text_;
};

/// One line of a table: what, how much, and what it should be.
struct Figure {
  std::string what, value, aim;
};

/// A table, row by row as figures come, and text around it.
class Table {
 public:
  enum class Align { left, right };
  struct Column {
    // Implicit: most columns are a name alone.
    Column(std::string title, Align side = Align::right) : name(std::move(title)), align(side) {}
    Column(const char* title, Align side = Align::right) : name(title), align(side) {}
    std::string name;
    Align align;
  };

  /// The machine and `heading` stand above the table, whose first column is aligned on the left.
  Table(const std::string& heading, const std::vector<Column>& columns, std::string file = "");
  static Table of_figures(const std::string& heading, std::string file = "") {
    return {heading, {"what", "figure", "aim"}, std::move(file)};
  }

  void row(const std::vector<std::string>& cells) { output_.write(table_line(cells)); }
  void row(const std::string& name, const std::vector<double>& figures) {
    output_.write(table_line(name, figures));
  }
  void add(const std::vector<Figure>& figures);
  /// Ends the table with `text`, below which another one begins.
  void next(const std::string& text, const std::vector<Column>& columns);
  /// Ends the table with `text`.
  void close(const std::string& text) { output_.write("\n" + text + "\n"); }

 private:
  void begin(const std::vector<Column>& columns);

  Output output_;
};

/// Mean microseconds a query for each map, geometric means over the maps, ratios to `subject` (the
/// index of a planner: above 1 that one is faster), medians, gaps, preparation, faults.
void write_markdown(std::ostream& out, std::span<const MapComparison> maps,
                    std::span<const peers::Peer> planners, std::size_t subject,
                    const ComparisonOptions& options, const std::string& seeds);

/// Number of measurements with a fault.
std::size_t count_faults(std::span<const MapComparison> maps);

}  // namespace lasius::bench
