// What a disc sees from an arc that it turns around, or a point: the arcs that it can go on to.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/disc/disc_space.h"
#include "core/disc/tangent.h"
#include "core/disc/tangent_scan.h"
#include "core/grid/grid_view.h"

namespace lasius::disc {

/// Where a view is taken from: an arc and the normal that the disc comes to it by, or a point. As
/// an arc of radius 0 a point has neither type nor ends.
struct Root {
  double x, y;    ///< centre
  double offset;  ///< see heading_of
  Heading heading;
  Normal from, to;  ///< the first and last ray
  std::uint32_t arc;

  static constexpr std::uint32_t kPoint = ~std::uint32_t{0};

  /// Rays onward from `from` to the arc's end.
  static Root on(const DiscSpace& space, std::uint32_t arc, bool rising, Normal from) noexcept {
    const Arc& a = space.arcs()[arc];
    return {static_cast<double>(a.x),
            static_cast<double>(a.y),
            rising ? -space.radius() : space.radius(),
            heading_of(a, rising),
            from,
            normal_at(rising ? a.high : a.low),
            arc};
  }
  /// All rays into one quadrant. A point that lies beside a grid line by rounding looks from the
  /// line: the row beside may hold no other point that is free.
  static Root at(Point p, Heading heading) noexcept {
    const auto on_line = [](double v) {
      const double line = std::round(v);
      return std::abs(v - line) <= kSlack ? line : v;
    };
    return {on_line(p.x), on_line(p.y), 0, heading, {1, 0}, {0, 1}, kPoint};
  }
  Point leaves(Normal n) const noexcept {
    return {x + heading.right * (offset * n.a), y - heading.down * (offset * n.b)};
  }
};

/// An arc that is perhaps in sight, and the line to it.
struct Seen {
  std::uint32_t arc;
  bool rising;    ///< how its fraction changes along a path that turns around it
  Normal normal;  ///< where the line leaves and where it arrives, in either quadrant
  double length;
  Point leaves, arrives;
};

/// What a view keeps from time to time.
class ViewMemory {
 public:
  std::int64_t bytes() const noexcept { return held_bytes(marks_, tangents_, stack_, shadows_); }

 private:
  template <class Sink>
  friend class View;

  struct Mark {
    std::uint32_t scan;
    std::uint32_t tangent;
  };
  struct Waiting {
    Tangent tangent;
    double offset;
    double along;          // of its ray: a column = along + b line
    double column, slope;  // the same: column + slope * line
    double u, v;           // centre
    int row;               // in which it touches
    bool wanted;
  };
  std::vector<Mark> marks_;  // by arc
  std::vector<Waiting> tangents_;
  std::vector<Gap> stack_;
  std::vector<Shadow> shadows_;
  std::uint32_t scan_ = 0;
};

/// A Sink has
///   void take(const Seen&)
///   template <int S> kernels::ConeLimits limits(int down, int line0)
///   bool go_on(std::int64_t words)
///   bool beyond(Point)  where looking along a wall is not worth while any more; only
///       look_along_wall() asks.
template <class Sink>
class View {
 public:
  View(const DiscSpace& space, ViewMemory& memory, Sink& sink) noexcept
      : space_(space), memory_(memory), sink_(sink) {
    memory_.marks_.resize(space.arcs().size());
  }

  /// Returns whether rays were cut off at the limits.
  bool look(const Root& root) { return root.heading.right > 0 ? scan<1>(root) : scan<-1>(root); }

  /// Along the wall that an arc ends at, if it does: to what lies on the last ray alone.
  bool look_along_wall(const Root& root) {
    const Arc& arc = space_.arcs()[root.arc];
    const bool rising = root.offset < 0;
    if (rising ? arc.high < 1 - kSlack : arc.low > kSlack) return false;
    if (!rising) return run_upright(root);
    return root.heading.right > 0 ? run_level<1>(root) : run_level<-1>(root);
  }

 private:
  template <int S>
  struct Visitor {
    View& view;
    const Root& root;
    const Sweep& sweep;
    int down, line0;

    void meet(int u, const Gap& gap, const Gap& ahead) {
      const int x = S > 0 ? u : -u - 1;
      const int y = down > 0 ? line0 + gap.line : line0 - gap.line - 1;
      for (const std::uint32_t arc : view.space_.arcs_at(x, y)) view.meet(*this, arc, gap, ahead);
    }
    kernels::ConeLimits limits() { return view.sink_.template limits<S>(down, line0); }
    bool go_on(std::int64_t words) { return view.sink_.go_on(words); }
  };

  template <int S>
  bool scan(const Root& root) {
    const int down = root.heading.down;
    const Point start = root.leaves(root.from);
    const int row = static_cast<int>(start.y);
    const int line0 = down < 0 && row < start.y ? row + 1 : row;
    const std::uint32_t type = type_passed(root.heading, false);
    const Sweep sweep{S * root.x, down * (root.y - line0), root.offset, root.from, root.to};
    const ScanFrame frame{view_of(space_.blocked_cells()), view_of(space_.arc_cells(type)),
                          view_of(space_.crowded()), down, line0};
    Visitor<S> visitor{*this, root, sweep, down, line0};
    begin();
    return TangentScan<S, Visitor<S>>(frame, sweep, memory_.stack_, memory_.shadows_, visitor)
        .run();
  }

  void begin() {
    if (++memory_.scan_ == 0) {  // all numbers were used
      std::ranges::fill(memory_.marks_, ViewMemory::Mark{});
      memory_.scan_ = 1;
    }
    memory_.tangents_.clear();
  }

  template <int S>
  void meet(const Visitor<S>& visitor, std::uint32_t number, const Gap& gap, const Gap& ahead) {
    ViewMemory::Mark& mark = memory_.marks_[number];
    if (mark.scan != memory_.scan_) {
      mark.scan = memory_.scan_;
      mark.tangent = find(visitor, number);
    }
    if (mark.tangent == kDone) return;
    ViewMemory::Waiting& waiting = memory_.tangents_[mark.tangent];
    if (gap.line < waiting.row) return;
    cast_shadow(waiting, ahead);
    if (!waiting.wanted || !in_gap(visitor.sweep, waiting, gap)) return;
    waiting.wanted = false;
    offer(visitor.root, number, waiting.offset < 0, waiting.tangent);
  }

  // The tangent to an arc, if there is one in the quadrant; kDone for none.
  template <int S>
  std::uint32_t find(const Visitor<S>& visitor, std::uint32_t number) {
    const Arc& arc = space_.arcs()[number];
    const Sweep& sweep = visitor.sweep;
    const bool rising = arc.type == type_passed(visitor.root.heading, true);
    const double offset = rising ? -space_.radius() : space_.radius();
    if (number == visitor.root.arc ||
        (!rising && arc.type != type_passed(visitor.root.heading, false)))
      return kDone;
    const double u = S * arc.x, v = visitor.down * (arc.y - visitor.line0);
    const Tangent line = tangent(u - sweep.u, v - sweep.v, sweep.offset - offset);
    const Normal n = line.normal;
    if (line.length < 0 || n.a < -kSlack || n.b < -kSlack) return kDone;
    const bool wanted = on_arc(arc, n) && between(sweep, n);
    if (!wanted && n.a < kLevel) return kDone;
    const double per_a = 1 / std::max(n.a, kLevel);
    const double along = n.a * sweep.u - n.b * sweep.v + sweep.offset;
    memory_.tangents_.push_back({line, offset, along, along * per_a, n.b * per_a, u, v,
                                 static_cast<int>(v - offset * n.b - kRowSlack), wanted});
    return static_cast<std::uint32_t>(memory_.tangents_.size() - 1);
  }

  // Rays that meet the circle end there, be the arc that the tangent touches free or not. In the
  // row where the tangent to its left side touches, all others have met it; where that to its right
  // side does, those that are in the circle on the next line.
  void cast_shadow(const ViewMemory::Waiting& waiting, const Gap& ahead) {
    if (waiting.tangent.normal.a < kLevel) return;
    const bool right = waiting.offset < 0;
    const Fixed ray = column_of(waiting.column + waiting.slope * ahead.line);
    if (right ? ray >= ahead.right : ray <= ahead.left) return;
    const double depth = ahead.line - waiting.v;
    const double square = space_.radius() * space_.radius() - depth * depth;
    const double half = square > 0 ? std::sqrt(square) : 0;
    const Fixed end = column_of(right ? waiting.u + half : waiting.u - half);
    const Fixed slope = static_cast<Fixed>(waiting.slope * static_cast<double>(kOne));
    if (right) {
      if (end > std::max(ray, ahead.left))
        memory_.shadows_.push_back({.left = ray, .right = end, .left_slope = slope});
    } else if (end < std::min(ray, ahead.right)) {
      memory_.shadows_.push_back({.left = end, .right = ray, .right_slope = slope});
    }
  }
  static Fixed column_of(double column) noexcept {
    constexpr double kMost = kernels::kAllColumns;
    return static_cast<Fixed>(std::clamp(column, -kMost, kMost) * static_cast<double>(kOne));
  }

  static double turned(Normal from, Normal to) noexcept { return from.a * to.b - from.b * to.a; }
  static bool between(const Sweep& sweep, Normal n) noexcept {
    const double sign = sweep.offset > 0 ? -1 : 1;
    return n.a >= -kSlack && n.b >= -kSlack && sign * turned(sweep.from, n) >= -kSlack &&
           sign * turned(n, sweep.to) >= -kSlack;
  }
  // Is the ray between the sides of a gap, or has it not left the circle before this row?
  static bool in_gap(const Sweep& sweep, const ViewMemory::Waiting& waiting,
                     const Gap& gap) noexcept {
    const Normal n = waiting.tangent.normal;
    const double leaves = sweep.v - sweep.offset * n.b;
    if (leaves > gap.line - kRowSlack && (gap.grows || gap.line == 0)) return true;
    constexpr double kColumn = 1.0 / static_cast<double>(kOne);
    const double along = waiting.along + n.b * gap.line;
    return n.a * (static_cast<double>(gap.left) * kColumn) <= along + kRaySlack &&
           n.a * (static_cast<double>(gap.right) * kColumn) >= along - kRaySlack;
  }

  void offer(const Root& root, std::uint32_t number, bool rising, const Tangent& line) {
    const Point leaves = root.leaves(line.normal);
    const double x = root.heading.right * (line.normal.b * line.length);
    const double y = root.heading.down * (line.normal.a * line.length);
    sink_.take({number, rising, line.normal, line.length, leaves, {leaves.x + x, leaves.y + y}});
  }

  // An arc that the last ray along a wall touches at its quadrant's edge; it is met with its
  // fraction at 0 where the ray is upright, 1 where it is level.
  void meet_on_ray(const Root& root, std::uint32_t number) {
    ViewMemory::Mark& mark = memory_.marks_[number];
    if (mark.scan == memory_.scan_ || number == root.arc) return;
    mark.scan = memory_.scan_;
    mark.tangent = kDone;
    const Arc& arc = space_.arcs()[number];
    const bool rising = root.offset > 0;  // what turns onward from the edge
    const Heading heading = root.heading;
    if (rising ? arc.down() != heading.down || arc.low > kSlack
               : arc.right() != heading.right || arc.high < 1 - kSlack)
      return;
    const Normal n = rising ? Normal{1, 0} : Normal{0, 1};
    const double radius = space_.radius();
    const double u = heading.right * (arc.x - root.x), v = heading.down * (arc.y - root.y);
    const double offset =
        rising ? heading.right * arc.right() * radius : -heading.down * arc.down() * radius;
    const double beside = n.a * u - n.b * v - (root.offset - offset);
    const double length = rising ? v : u;
    if (std::abs(beside) > kSlack || length < 0) return;
    offer(root, number, rising, {n, length});
  }

  void meet_cell(const Root& root, int x, int y) {
    for (const std::uint32_t number : space_.arcs_at(x, y)) meet_on_ray(root, number);
  }

  // The rows or columns of cells beside a ray that runs on a grid line or in a row or column.
  struct Lane {
    int first, second;
  };
  static Lane lane_at(double across) noexcept {
    return {static_cast<int>(across - kRowSlack), static_cast<int>(across + kRowSlack)};
  }

  // Both cells beside a ray that runs on a grid line; the ray ends where either is blocked. These
  // return whether it was cut off.
  template <int S>
  bool run_level(const Root& root) {
    using B = kernels::Bits<S>;
    begin();
    const Point start = root.leaves(root.to);
    const auto [y0, y1] = lane_at(start.y);
    const auto row = [](const Grid& grid, int y) { return kernels::bytes_of(grid.row(y)); };
    const char* blocked0 = row(space_.blocked_cells(), y0);
    const char* blocked1 = row(space_.blocked_cells(), y1);
    const char* band0 = row(space_.band_cells(), y0);
    const char* band1 = row(space_.band_cells(), y1);
    const int column = static_cast<int>(start.x);
    for (int c = S > 0 ? column : -column - 1;; c += B::kValid) {
      std::uint64_t valid = B::to(B::kValid - 1);
      const std::uint64_t wall = (B::window(blocked0, c) | B::window(blocked1, c)) & valid;
      if (wall != 0) valid = B::to(B::first(wall)) & ~B::only(B::first(wall));
      std::uint64_t cells = (B::window(band0, c) | B::window(band1, c)) & valid;
      for (; cells != 0; cells &= ~B::only(B::first(cells))) {
        const int u = c + B::first(cells);
        const int x = S > 0 ? u : -u - 1;
        if (space_.in_band({x, y0})) meet_cell(root, x, y0);
        if (y1 != y0 && space_.in_band({x, y1})) meet_cell(root, x, y1);
      }
      if (wall != 0) return false;
      if (!sink_.go_on(1) || sink_.beyond({1.0 * S * (c + B::kValid), start.y})) return true;
    }
  }
  bool run_upright(const Root& root) {
    begin();
    const Point start = root.leaves(root.to);
    const auto [x0, x1] = lane_at(start.x);
    const Grid& blocked = space_.blocked_cells();
    constexpr int kRowsAtOnce = 16;
    for (int y = static_cast<int>(start.y), rows = 1;; y += root.heading.down, ++rows) {
      if (blocked.blocked({x0, y}) || blocked.blocked({x1, y})) return false;
      if (space_.in_band({x0, y})) meet_cell(root, x0, y);
      if (x1 != x0 && space_.in_band({x1, y})) meet_cell(root, x1, y);
      if (rows % kRowsAtOnce == 0 &&
          (!sink_.go_on(kRowsAtOnce) || sink_.beyond({start.x, 1.0 * y})))
        return true;
    }
  }

  static constexpr std::uint32_t kDone = ~std::uint32_t{0};
  static constexpr double kRowSlack = 1e-7, kRaySlack = 1e-8;
  static constexpr double kLevel = 1e-4;  // rays that are less steep have no column of their own

  const DiscSpace& space_;
  ViewMemory& memory_;
  Sink& sink_;
};

}  // namespace lasius::disc
