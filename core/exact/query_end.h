// Where a search begins or ends, and what is seen from there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/poller.h"
#include "core/exact/box_view.h"
#include "core/exact/quadrant.h"
#include "kernels/sight/sight.h"
#include "lasius/grid/geometry.h"

namespace lasius::exact {

/// A point of the map, most often the centre of a cell: then all that is done with it is done in
/// half cells, as with corners.
class QueryEnd {
 public:
  QueryEnd() = default;
  explicit QueryEnd(Point p) noexcept
      : x(2 * p.x),
        y(2 * p.y),
        at_{static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y))},
        fine_(kernels::fine(p.x, p.y)),
        half_(kernels::fine(at_) == fine_) {}

  double x = 0, y = 0;  ///< in half cells

  bool is_centre() const noexcept { return half_ && (at_.x & at_.y & 1) != 0; }
  /// The nearest point in half cells; of a centre the point itself.
  kernels::HalfPoint near() const noexcept { return at_; }
  /// How far that is away, in cells.
  double off() const noexcept {
    return half_ ? 0 : 0.5 * std::sqrt((x - at_.x) * (x - at_.x) + (y - at_.y) * (y - at_.y));
  }
  kernels::FinePoint fine() const noexcept { return fine_; }
  Point point() const noexcept { return {0.5 * x, 0.5 * y}; }

  bool sees(const kernels::BitmapView& map, kernels::HalfPoint p) const noexcept {
    return half_ ? kernels::sees(map, at_, p) : kernels::sees_fine(map, fine_, kernels::fine(p));
  }
  bool sees(const kernels::BitmapView& map, const QueryEnd& other) const noexcept {
    return half_ && other.half_ ? kernels::sees(map, at_, other.at_)
                                : kernels::sees_fine(map, fine_, other.fine_);
  }

 private:
  kernels::HalfPoint at_{};
  kernels::FinePoint fine_{};
  bool half_ = true;
};

/// A corner that an end sees, and the side on which a taut path from there leaves it.
struct SeenCorner {
  int x, y;              ///< of the lattice
  int block_x, block_y;  ///< as GraphCorner has them
  Side side;
};

/// What an end sees that is no centre of a cell: scans, whose arithmetic is about centres and
/// corners, find what may be seen from around it, and each corner of that is looked at.
class EndView {
 public:
  EndView(const kernels::BitmapView& map, const QueryEnd& end, Poller& poller) noexcept
      : map_(map), end_(end), poller_(poller) {}

  /// Calls found(SeenCorner) for each corner in sight at which a taut path that begins or ends at
  /// the end may turn and which is `worth(x, y)` a look, by rows; for not all when stopped.
  template <class Worth, class Found>
  void run(const Worth& worth, const Found& found) {
    // A cell larger than what holds the end: see BoxView.
    const Point p = end_.point();
    const LatticeBox box{std::max(0, static_cast<int>(std::floor(p.x)) - 1),
                         std::max(0, static_cast<int>(std::floor(p.y)) - 1),
                         std::min(map_.width, static_cast<int>(std::ceil(p.x)) + 1),
                         std::min(map_.height, static_cast<int>(std::ceil(p.y)) + 1)};
    for (int y = box.y0; y <= box.y1; ++y)
      for (int x = box.x0; x <= box.x1; ++x) corner(x, y);
    view_from_box(map_, box, *this);
    std::ranges::sort(maybe_);
    maybe_.erase(std::unique(maybe_.begin(), maybe_.end()), maybe_.end());
    for (const auto& [y, x] : maybe_) {
      SeenCorner seen{.x = x, .y = y, .block_x = 0, .block_y = 0, .side = kColumn};
      if (poller_.stop_after(1)) return;
      if (!worth(x, y) || !may_turn(seen)) continue;
      poller_.stop_after(std::abs(y - static_cast<int>(p.y)));
      if (end_.sees(map_, {2 * x, 2 * y})) found(seen);
    }
  }

  // What a view calls.
  void corner(int x, int y) { maybe_.emplace_back(y, x); }
  bool go_on(std::int64_t words) { return !poller_.stop_after(words); }

 private:
  // Finds block and side; false where no taut path turns, or the point is no corner.
  bool may_turn(SeenCorner& seen) const noexcept {
    int blocked = 0;
    for (const int by : {-1, 1})
      for (const int bx : {-1, 1})
        if (map_.blocked(bx < 0 ? seen.x - 1 : seen.x, by < 0 ? seen.y - 1 : seen.y)) {
          ++blocked;
          seen.block_x = bx;
          seen.block_y = by;
        }
    const kernels::FinePoint at = kernels::fine({2 * seen.x, 2 * seen.y});
    const std::int64_t along = seen.block_x * (end_.fine().x - at.x);
    const std::int64_t away = seen.block_y * (end_.fine().y - at.y);
    seen.side = away > along ? kLine : kColumn;
    const bool across = (along > 0 && away > 0) || (along < 0 && away < 0);
    return blocked == 1 && !across && (along != 0 || away != 0);
  }

  const kernels::BitmapView& map_;
  const QueryEnd& end_;
  Poller& poller_;
  std::vector<std::pair<int, int>> maybe_;  ///< y, x
};

}  // namespace lasius::exact
