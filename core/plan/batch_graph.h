// The visibility graph that a batch makes for itself once it pays.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <stop_token>

#include "core/plan/planner_impl.h"
#include "core/plan/workspace.h"
#include "lasius/planner.h"

namespace lasius {

/// What is internal of a Planner.
struct PlannerParts {
  static const Planner::Impl& of(const Planner& planner) noexcept { return *planner.impl_; }
};

/// Shared by the threads of a batch of `exact`. The first queries tell what one takes, in
/// expansions and rows; then one thread makes the graph, if that is a small part of what is left to
/// do. From there on queries are asked of the graph, where the shortest path is the only one; until
/// then, and where another one may be as short, the ordinary search answers: no answer depends on
/// whether there is a graph, nor when.
class BatchGraph {
 public:
  /// Batches of fewer plans do without.
  static constexpr std::int64_t kFewest = 256;

  BatchGraph(const Planner& planner, std::int64_t plans, const std::stop_token& token)
      : map_(PlannerParts::of(planner)), plans_(plans), token_(token) {}

  Result plan(const Request& request, const Params& params, Workspace& workspace) {
    PlanningMap map = map_.planning_map(request.stop);
    if (on_.load(std::memory_order_acquire)) {
      std::int64_t asked = 0, told = 0;
      map.sure = {graph_.get(), &asked, &told};
      Result result = answer(map, request, params, &workspace, {});
      count(asked, told);
      return result;
    }
    Result result = answer(map, request, params, &workspace, {});
    if (done_ >= kFirst) return result;
    const exact::Counters& counters = WorkspaceMemory::of(workspace).exact.counters();
    work_ += counters.expansions * exact::kWordsPerExpansion + counters.words;
    if (++done_ == kFirst) make();
    return result;
  }

 private:
  static constexpr std::int64_t kFirst = 64;
  // Of work: what is not worth a look around from start and goal, and what a byte of the graph
  // takes to make, times what the rest of the batch must take at least in place of it.
  static constexpr std::int64_t kLeastWork = 2000;
  static constexpr std::int64_t kWorkPerByte = 16;
  static constexpr std::int64_t kMostBytes = std::int64_t{128} << 20;

  void make() {
    const std::int64_t mean = work_ / kFirst;
    if (mean < kLeastWork) return;
    const PrepareOptions options{
        .threads = 1,
        .max_bytes = std::min(kMostBytes, mean * (plans_ - kFirst) / kWorkPerByte),
        .stop = {.token = token_}};
    if (exact::CornerGraph::expected_bytes(map_.grid, options) > options.max_bytes) return;
    Preparation report;
    graph_ = exact::CornerGraph::make(map_.grid, options, report);
    if (graph_ != nullptr) on_.store(true, std::memory_order_release);
  }

  // Where many paths are as short, as in warehouses and noise, the graph is in vain.
  void count(std::int64_t asked, std::int64_t told) {
    told_ += told;
    if ((asked_ += asked) >= kFirst && 8 * told_ < 7 * asked_) on_ = false;
  }

  const Planner::Impl& map_;
  const std::int64_t plans_;
  const std::stop_token token_;
  std::atomic<std::int64_t> done_ = 0, work_ = 0, asked_ = 0, told_ = 0;
  std::shared_ptr<const exact::CornerGraph> graph_;
  std::atomic<bool> on_ = false;
};

}  // namespace lasius
