// Hub labels that a batch makes for itself once they pay.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "core/plan/planner_impl.h"
#include "lasius/planner.h"
#include "lasius/stop.h"

namespace lasius {

/// What is internal of a Planner.
struct PlannerParts {
  static const Planner::Impl& of(const Planner& planner) noexcept { return *planner.impl_; }
};

/// Shared by the threads of a batch of `exact`. The first queries tell what one takes; then one
/// thread makes labels, for at most half of the time that the rest would take. Until they are
/// there, and where a path may not be the only one as short, queries are answered as without, so
/// that the clock decides over no answer.
class BatchLabels {
 public:
  BatchLabels(const Planner& planner, std::size_t queries, const std::stop_token& token)
      : map_(PlannerParts::of(planner)), left_(static_cast<std::int64_t>(queries)), token_(token) {}

  /// Answers by labels, where there are any, else by the planner's ordinary search.
  Result plan(const Request& request, const Params& params, Workspace* workspace) {
    if (ready_.load(std::memory_order_acquire)) return answered(request, params, workspace, true);
    const auto begin = Clock::now();
    Result result = answered(request, params, workspace, false);
    const std::int64_t left = --left_;
    spent_ += std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - begin).count();
    if (++done_ == kFirst) make(std::chrono::nanoseconds(spent_ / kFirst * left / 2));
    return result;
  }

  /// Batches of fewer do without.
  static constexpr std::size_t kFewest = 512;

 private:
  static constexpr std::int64_t kFirst = 64;

  Result answered(const Request& request, const Params& params, Workspace* workspace, bool labels) {
    PlanningMap map = map_.planning_map(request.stop);
    if (labels) {
      map.graph = graph_.get();
      map.labels = labels_.get();
      map.as_without = true;
    }
    return answer(map, request, params, workspace, {});
  }

  void make(std::chrono::nanoseconds most) {
    const PrepareOptions options{
        .threads = 1, .stop = {.token = token_, .deadline = Clock::now() + most}, .labels = true};
    Preparation report;
    graph_ = exact::CornerGraph::make(map_.grid, options, report);
    if (graph_ == nullptr) return;
    labels_ = exact::CornerLabels::make(map_.grid, *graph_, options, report.labels);
    if (labels_ != nullptr) ready_.store(true, std::memory_order_release);
  }

  const Planner::Impl& map_;
  std::atomic<std::int64_t> left_, done_ = 0, spent_ = 0;  // spent: nanoseconds
  const std::stop_token token_;
  std::shared_ptr<const exact::CornerGraph> graph_;
  std::shared_ptr<const exact::CornerLabels> labels_;
  std::atomic<bool> ready_ = false;
};

}  // namespace lasius
