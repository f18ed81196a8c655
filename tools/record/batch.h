// `batch`, whatever the kind of problem: a line a query as answers come, a row a query, a picture
// of all paths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/plan/batch_options.h"
#include "tools/console/signals.h"
#include "tools/record/outputs.h"
#include "tools/record/record.h"

namespace lasius::tool {

/// What a kind plugs into run_batch.
struct Batch {
  /// Takes an answer: start and goal as texts, and its path as pictures have it.
  using Take = std::function<void(Record&&, const std::vector<std::string>& ends,
                                  const std::vector<Point>& path)>;

  const SearchOptions& options;
  std::string unit;  ///< of lengths; columns in it end in its name
  std::size_t queries = 0;
  bool poses = false;    ///< starts and goals have a yaw
  bool costs = false;    ///< answers are over costs: another column
  bool is_plan = false;  ///< one query of `plan`, whose exit code says what came of it
  /// Queries, each with BatchOptions::seeds from this one on.
  struct Part {
    std::size_t first = 0, count = 0;
    std::uint64_t seed = 0;
  };
  /// Answers a part with each seed, in order, each taken in its turn.
  std::function<void(const Part&, const BatchOptions&, const Take&)> answer;
  using Paths = std::vector<std::vector<Point>>;
  /// Draws all paths into a file; the caption counts them, and the answers by their status.
  std::function<void(const std::string& file, const Paths&, const std::string& caption)> draw;
};

/// Answers all queries, prints the answers as they come, and writes the files that are asked for.
/// With a crew chunks of queries, or of one's seeds, are shared, and its leader keeps a journal of
/// those that are done in the working folder until all are. The program's exit code.
int run_batch(const Batch& batch, const SignalWatcher& signals, Delivery& delivery);

/// Tells a command and its input from all others, but not on how many threads it runs. @throws
/// Error for an input that is read once: it cannot be shared, nor gone on with.
std::string shared_key(const SearchOptions& options, const std::string& more);

}  // namespace lasius::tool
