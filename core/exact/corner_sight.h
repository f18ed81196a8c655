// The corners that one corner sees on one side, put in order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/exact/corner_view.h"
#include "core/exact/quadrant.h"

namespace lasius::exact {

class alignas(64) CornerSight {
 public:
  explicit CornerSight(const StopCondition& stop) : poller_(stop) {}

  /// Corners seen in the quadrant's cone, ordered by angle from the block's edge on; of two in one
  /// direction the nearer first. Valid until the next call; incomplete when stopped.
  std::span<const kernels::HalfPoint> from(const kernels::BitmapView& map, const Quadrant& quadrant,
                                           Side side, const QuadrantCone& cone = {}) {
    seen_.clear();
    quadrant_ = &quadrant;
    cone_ = &cone;
    if (quadrant.right > 0)
      view_quadrant<1>(map, quadrant, cone, side == kLine, stack_, *this);
    else
      view_quadrant<-1>(map, quadrant, cone, side == kLine, stack_, *this);
    const auto before = [&](kernels::HalfPoint a, kernels::HalfPoint b) {
      const std::int64_t ax = quadrant.along(a.x), ay = quadrant.away(a.y);
      const std::int64_t bx = quadrant.along(b.x), by = quadrant.away(b.y);
      const std::int64_t turn = side == kLine ? ay * bx - by * ax : ax * by - bx * ay;
      return turn != 0 ? turn < 0 : ax + ay < bx + by;
    };
    std::sort(seen_.begin(), seen_.end(), before);
    seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
    return seen_;
  }

  // What a view calls.
  void corner(int x, int y) {
    if (cone_->holds(quadrant_->along(x), quadrant_->away(y))) seen_.push_back({x, y});
  }
  bool go_on(std::int64_t words) { return !poller_.stop_after(words); }

 private:
  Poller poller_;
  const Quadrant* quadrant_ = nullptr;
  const QuadrantCone* cone_ = nullptr;
  std::vector<kernels::Interval> stack_;
  std::vector<kernels::HalfPoint> seen_;
};

}  // namespace lasius::exact
