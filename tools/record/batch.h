// `batch`, whatever the world: a line a query as answers come, a row a query, a picture of all
// paths.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "lasius/batch_options.h"
#include "lasius/geometry.h"
#include "tools/console/signals.h"
#include "tools/record/task.h"

namespace lasius::tool {

/// What a world plugs into run_batch.
struct Batch {
  /// Takes the answer that the task holds now: start and goal as texts, and its path.
  using Take = std::function<void(const std::vector<std::string>&, const std::vector<Point>&)>;

  Task& task;  ///< tells of options and columns, too: those in metres end in _m
  std::size_t queries = 0;
  bool is_plan = false;  ///< one query of `plan`, whose exit code says what came of it
  /// Answers the queries with each seed, in order, each taken in its turn.
  std::function<void(const BatchOptions&, const Take&)> answer;
  using Paths = std::vector<std::vector<Point>>;
  /// Draws all paths into a file; the caption counts them, and the answers by their status.
  std::function<void(const std::string& file, const Paths&, const std::string& caption)> draw;
};

/// Answers all queries, prints the answers as they come, and writes the files that are asked for.
/// The program's exit code.
int run_batch(const Batch& batch, const SignalWatcher& signals);

}  // namespace lasius::tool
