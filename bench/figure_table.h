// Text for people on standard output and in a file; figures beside their aims.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lasius::bench {

/// Standard output, line by line as figures come, and a file unless its name is empty.
class Output {
 public:
  explicit Output(std::string file) : file_(std::move(file)) {}
  void write(const std::string& text);

 private:
  std::string file_, text_;
};

/// One line of the table: what, how much, and what it should be.
struct Figure {
  std::string what, value, aim;
};

/// A table in Markdown, as the README has them.
class FigureTable {
 public:
  /// The machine and `heading` stand above it.
  FigureTable(const std::string& heading, const std::string& file);

  void add(const std::vector<Figure>& figures);

 private:
  Output output_;
};

}  // namespace lasius::bench
