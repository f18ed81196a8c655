// What a batch writes: a line a query, a row a query, a picture of all paths.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/record/task.h"

namespace lasius::tool {

/// What files need of a batch, kept only for the kinds that are asked for.
class BatchFiles {
 public:
  /// A task of the batch tells of its columns: those in metres end in _m.
  explicit BatchFiles(const Task& task);

  /// Adds an answer: its line of JSON, start and goal as texts, its path.
  void add(const Task& task, const std::string& json_line, const std::vector<std::string>& ends,
           const std::vector<Point>& path);

  using Draw = std::function<void(const std::vector<std::vector<Point>>& paths)>;
  void write(const std::string& file, const Draw& draw) const;

 private:
  bool json_ = false, csv_ = false, paths_ = false;
  std::string lines_, rows_;
  std::vector<std::vector<Point>> kept_;
};

}  // namespace lasius::tool
