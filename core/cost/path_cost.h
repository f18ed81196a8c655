// The cost of a straight piece of a path.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "core/base/special_values.h"
#include "core/cost/terrain.h"
#include "lasius/grid/geometry.h"

namespace lasius::cost {

/// Who does not ask which cells a path goes through.
inline constexpr auto no_pieces = [](Cell, Point) {};

/// Sums what segments cost, one beginning where the one before ended. `Weight` is called with
/// column and row, which may lie outside the map by one, and is infinite where nothing goes;
/// `OnPiece` with each cell that a segment goes through, and where that piece of it ends.
template <class Weight, class OnPiece = decltype(no_pieces)>
class PathCost {
 public:
  explicit PathCost(const Weight& weight, const OnPiece& on_piece = no_pieces)
      : weight_(weight), on_piece_(on_piece) {}

  /// False where the path is not allowed.
  bool add(Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0)) return true;
    double next_x = first_line(a.x, dx), next_y = first_line(a.y, dy);
    double t = 0;
    for (;;) {
      const double tx = dx == 0 ? kInfinity : (next_x - a.x) / dx;
      const double ty = dy == 0 ? kInfinity : (next_y - a.y) / dy;
      const double until = std::min({tx, ty, 1.0});
      if (!piece({a.x + dx * (t + until) / 2, a.y + dy * (t + until) / 2}, dx == 0, dy == 0,
                 (until - t) * length))
        return false;
      if ((until - t) * length > kNothing)
        on_piece_(Cell{x_, y_}, {a.x + dx * until, a.y + dy * until});
      if (until >= 1) return true;
      t = until;
      if (tx <= until) next_x += dx > 0 ? 1 : -1;
      if (ty <= until) next_y += dy > 0 ? 1 : -1;
    }
  }
  double sum() const noexcept { return sum_; }

 private:
  static constexpr double kNothing = 1e-9;  // cells: what is shorter is rounding

  static double first_line(double from, double step) noexcept {
    return step > 0 ? std::floor(from) + 1 : std::ceil(from) - 1;
  }

  bool piece(Point middle, bool upright, bool level, double length) {
    int x = static_cast<int>(std::floor(middle.x)), y = static_cast<int>(std::floor(middle.y));
    double weight = weight_(x, y);
    // Along a grid line the cheaper side.
    const bool on_x = upright && middle.x == x, on_y = level && middle.y == y;
    if ((on_x || on_y) && weight_(x - on_x, y - on_y) < weight) {
      x -= on_x;
      y -= on_y;
      weight = weight_(x, y);
    }
    if (length <= kNothing) {
      if (weight < kInfinity) sum_ += weight * length;
      return true;
    }
    if (!(weight < kInfinity)) return false;
    sum_ += weight * length;
    const bool free_before = x_ != kNone;
    const int from_x = x_, from_y = y_;
    x_ = x;
    y_ = y;
    if (!free_before || from_x == x || from_y == y) return true;
    return weight_(from_x, y) < kInfinity || weight_(x, from_y) < kInfinity;
  }

  static constexpr int kNone = -2;

  const Weight& weight_;
  const OnPiece& on_piece_;
  double sum_ = 0;
  int x_ = kNone, y_ = kNone;  // the cell of the piece before
};

/// Of a polyline over a terrain; infinite where none may go along it.
inline double cost_of(const Terrain& terrain, std::span<const Point> path) {
  const auto weight = [&](int x, int y) { return terrain.weight(x, y); };
  PathCost sum(weight);
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!sum.add(path[i - 1], path[i])) return kInfinity;
  return sum.sum();
}

}  // namespace lasius::cost
