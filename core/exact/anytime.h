// A path soon under a deadline: a bounding search in turns with the exact one.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/exact/exact.h"
#include "core/exact/exact_answer.h"

namespace lasius::exact {

/// Runs beside one exact search, plain or prepared, that can be stopped or is looked at. Both keep
/// to themselves, so that a search which is not cut ends with the same path, bit for bit, as
/// without; one that is cut has the shorter path and the higher bound of the two. A search that
/// ends within a tenth of a millisecond never gets here.
class Anytime {
 public:
  /// What a workspace keeps from search to search.
  struct Memory {
    ExactSearch search;
    // The best path of both searches. Kept, since the one that a search would trace later may be
    // longer: its corners get other parents.
    std::vector<Point> path, traced;
    std::int64_t bytes() const noexcept { return search.bytes() + held_bytes(path, traced); }
  };

  /// Keeps references to `memory`, the map and the condition, and `options.improved`, which is told
  /// of each shorter path of either search.
  Anytime(Memory& memory, const Grid& grid, Point start, Point goal, const ExactOptions& options,
          const StopCondition& stop);
  Anytime(const Anytime&) = delete;
  Anytime& operator=(const Anytime&) = delete;

  /// What the exact search is to run with.
  const ExactOptions& options() const noexcept { return options_; }
  /// Puts what the bounding search has into the answer of an exact one that was cut.
  void merge(ExactAnswer& answer) const;

  /// The turn of the bounding search, between two steps of the exact one, whose work `poller`
  /// counts and which may be told to stop.
  void take_turn(Poller& poller) {
    const std::int64_t work = poller.take_work();
    if (work > 0 && !poller.stopped()) poller.stop(turn(work));
  }
  /// The same after so much work; returns what asks to stop.
  StopCondition::Cause turn(std::int64_t work);

 private:
  bool tell(const std::vector<Point>& path, double length, double bound);

  Memory& memory_;
  const Grid& grid_;
  Point start_, goal_;
  const StopCondition& stop_;
  const OnImproved* told_;
  OnImproved tell_;
  ExactOptions options_;
  double share_ = 0;  // of the exact search's work that the bounding one does beside it
  double owed_ = 0;
  double work_ = 0;
  bool begun_ = false, resting_ = false;
  double traced_ = kInfinity;  // upper bound when last traced
  // Of the best path of both.
  double length_ = kInfinity;
  double bound_ = 0;
};

}  // namespace lasius::exact
