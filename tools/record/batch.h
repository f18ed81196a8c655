// `batch`, whatever the world: a line a query as answers come, a row a query, a picture of all
// paths.
#pragma once

#include <functional>
#include <optional>
#include <span>
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
  /// Answers `count` queries from `first` on with each seed, in order, each taken in its turn.
  std::function<void(std::size_t first, std::size_t count, const BatchOptions&, const Take&)>
      answer;
  /// Draws all paths into a file.
  std::function<void(const std::string& file, const std::vector<std::vector<Point>>& paths)> draw;
};

/// Answers all queries, prints the answers as they come, and writes the files that are asked for.
/// The program's exit code.
int run_batch(const Batch& batch, const SignalWatcher& signals);

/// The length of each query's shortest path, where `exact` proves one in time.
template <class Planner, class Request, class Params>
std::vector<std::optional<double>> optima(const Planner& planner, std::span<const Request> queries,
                                          const Params& exact, BatchOptions how) {
  how.seeds = 1;
  std::vector<Request> requests(queries.begin(), queries.end());
  for (Request& request : requests) request.target_gap = 0;
  std::vector<std::optional<double>> found(queries.size());
  plan_batch(planner, requests, exact, how, [&](const auto& answer) {
    if (answer.result.optimal) found[answer.index] = answer.result.length;
  });
  return found;
}

}  // namespace lasius::tool
