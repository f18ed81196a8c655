// What a batch prints and writes: a line a query, a row a query, a picture of all paths.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/console/progress.h"
#include "tools/record/outputs.h"
#include "tools/record/task.h"

namespace lasius::tool {

/// Prints answers as they come, and keeps what the files that are asked for need of them.
class BatchOutput {
 public:
  /// A task of the batch, which must outlive it, tells of its options and columns: those in metres
  /// end in _m. `total`: answers that will come.
  BatchOutput(const Task& task, std::int64_t total);

  /// Takes the answer of a task: start and goal as texts, and its path.
  void add(const Task& task, const std::vector<std::string>& ends, const std::vector<Point>& path);

  /// Draws all paths into a file.
  using Draw =
      std::function<void(const std::string& file, const std::vector<std::vector<Point>>& paths)>;
  void write_files(const Draw& draw);

 private:
  Delivery delivery_;
  ProgressLine bar_;
  std::int64_t done_ = 0;
  bool json_ = false, csv_ = false, paths_ = false;
  std::string lines_, rows_;
  std::vector<std::vector<Point>> kept_;
};

}  // namespace lasius::tool
