// Some path soon and shorter ones after it: weighted A* whose weight falls.
#include <algorithm>

#include "core/base/special_values.h"
#include "core/exact/exact.h"

namespace lasius {

using exact::Corner;
using exact::CornerTable;
using exact::kBucketWidth;
using exact::kTrailBuckets;

namespace {

// The weight at first; afterwards the excess over 1 is this share of the certified gap, and at most
// that of what it was. Below the least weight the exact search is about as fast.
constexpr double kFirstWeight = 2;
constexpr double kNextShareOfGap = 0.5;
constexpr double kLeastFall = 0.9;
constexpr double kLeastWeight = 1.01;

}  // namespace

void ExactSearch::begin_improving(const Grid& grid, Point start, Point goal) {
  begin(grid, start, goal, Mode::improving);
  weight_ = kFirstWeight;
  corners_[CornerTable::kStart].weighed = false;
  weighted_frontier_.reset(lower_, std::max(kBucketWidth, lower_ / kTrailBuckets));
  weighted_frontier_.push(CornerTable::kStart, weight_ * lower_);
}

// False if it is low enough. What was expanded stays so: only a corner that was reached by a
// shorter way since waits again.
bool ExactSearch::lower_weight() {
  if (weight_ <= kLeastWeight) return false;
  weight_ = 1 + std::min(kLeastFall * (weight_ - 1), kNextShareOfGap * (upper_ / lower_ - 1));
  weighted_frontier_.reset(lower_, std::max(kBucketWidth, lower_ * (weight_ - 1) / kTrailBuckets));
  for (std::uint32_t i = 0; i < corners_.size() && !poller_->stop_after(1); ++i) {
    const Corner& corner = corners_[i];
    if (corner.weighed || corner.length + corner.to_goal >= upper_) continue;
    weighted_frontier_.push(i, corner.length + weight_ * corner.to_goal);
  }
  return true;
}

// The least key divided by the weight is a lower bound, as in the bounding search, at any weight:
// of a shortest path some corner waits at its least length.
bool ExactSearch::improve(std::int64_t work, Poller& poller) {
  poller_ = &poller;
  const std::int64_t end = work_done() + work;
  // Where it was stopped before, what was left out might come first.
  bool more = lower_ < upper_ && cause_ == StopCondition::Cause::none;
  while (more && !poller.stopped() && work_done() < end) {
    const double before = upper_;
    const double least =
        weighted_frontier_.advance(poller) ? weighted_frontier_.floor() : kInfinity;
    lower_ = std::max(lower_, std::min(least / weight_, upper_));
    if (least < upper_) {
      const std::uint32_t index = weighted_frontier_.pop();
      Corner& corner = corners_[index];
      if (!corner.weighed && corner.length + corner.to_goal < upper_) {
        corner.weighed = true;
        expand(index);
      }
      poller.stop_after(exact::kWordsPerExpansion);
    }
    const bool on = least < upper_ && upper_ == before;
    more = lower_ < upper_ && (on || lower_weight());
  }
  poller_ = nullptr;
  cause_ = poller.cause();
  return more && !poller.stopped();
}

}  // namespace lasius
