// The rule of the plane, written twice, with nothing in common with the library's code: exactly, by
// cutting a segment at every grid line, and in floating point with a tolerance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::rule {

using Quad = std::array<bool, 4>;  // around a lattice point: NW, NE, SE, SW

inline Quad free_around(const Grid& grid, int x, int y) {
  return {grid.free({x - 1, y - 1}), grid.free({x, y - 1}), grid.free({x, y}),
          grid.free({x - 1, y})};
}

inline Quad quadrants_towards(double dx, double dy) {
  return {dx <= 0 && dy <= 0, dx >= 0 && dy <= 0, dx >= 0 && dy >= 0, dx <= 0 && dy >= 0};
}

/// At lattice point (x, y): coming from direction (ax, ay), going to (bx, by).
inline bool squeezes(const Grid& grid, int x, int y, double ax, double ay, double bx, double by) {
  const Quad free = free_around(grid, x, y);
  const Quad from = quadrants_towards(ax, ay);
  const Quad to = quadrants_towards(bx, by);
  for (int i = 0; i < 4; ++i) {
    if (!free[i] || !from[i]) continue;
    for (const int turn : {1, 3}) {
      for (int j = i, n = 0; n < 4 && free[j]; j = (j + turn) % 4, ++n) {
        if (to[j]) return false;
      }
    }
  }
  return !(free[0] && free[1] && free[2] && free[3]);
}

/// Half-cell coordinates.
struct HalfSegment {
  std::int64_t ax, ay, bx, by;
};

/// True when the segment obeys the rule. Exact: the segment is cut at every grid line, and each
/// cut and the middle between two cuts is looked at in rational numbers.
inline bool segment_obeys(const Grid& grid, HalfSegment s) {
  const std::int64_t dx = s.bx - s.ax;
  const std::int64_t dy = s.by - s.ay;
  // Cuts as t = n / (|dx| |dy|), the factor of a zero difference left out.
  const std::int64_t ux = dx == 0 ? 1 : std::abs(dx);
  const std::int64_t uy = dy == 0 ? 1 : std::abs(dy);
  const std::int64_t whole = ux * uy;
  std::vector<std::int64_t> cuts{0, whole};
  const auto cut = [&](std::int64_t from, std::int64_t d, std::int64_t other) {
    for (std::int64_t line = 0; d != 0 && line <= 2 * Grid::kMaxSide; line += 2) {
      const std::int64_t steps = d > 0 ? line - from : from - line;
      if (steps > 0 && steps < std::abs(d)) cuts.push_back(steps * other);
      if (line > std::max(from, from + d)) break;
    }
  };
  cut(s.ax, dx, uy);
  cut(s.ay, dy, ux);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  // Coordinates times 2 `whole`, so that middles are integers too.
  const std::int64_t scale = 2 * whole;
  const auto floor_div = [](std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
  };
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const std::int64_t middle = cuts[i - 1] + cuts[i];
    const std::int64_t x = s.ax * scale + dx * middle;
    const std::int64_t y = s.ay * scale + dy * middle;
    const int c = static_cast<int>(floor_div(x, 2 * scale));
    const int r = static_cast<int>(floor_div(y, 2 * scale));
    const bool on_column_line = x % (2 * scale) == 0;
    const bool on_row_line = y % (2 * scale) == 0;
    bool open = grid.free({c, r});
    if (on_column_line) open = open || grid.free({c - 1, r});
    if (on_row_line) open = open || grid.free({c, r - 1});
    if (!open) return false;
  }
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i) {
    const std::int64_t x = s.ax * whole + dx * cuts[i];
    const std::int64_t y = s.ay * whole + dy * cuts[i];
    if (x % (2 * whole) != 0 || y % (2 * whole) != 0) continue;
    if (squeezes(grid, static_cast<int>(x / (2 * whole)), static_cast<int>(y / (2 * whole)),
                 static_cast<double>(-dx), static_cast<double>(-dy), static_cast<double>(dx),
                 static_cast<double>(dy))) {
      return false;
    }
  }
  return true;
}

/// True when a path obeys the rule, its vertices being centres and corners of cells; exact.
inline bool path_obeys(const Grid& grid, std::span<const Point> path) {
  std::vector<HalfSegment> segments;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point a = path[i - 1], b = path[i];
    for (const double v : {a.x, a.y, b.x, b.y}) {
      if (2 * v != std::floor(2 * v)) return false;
    }
    const auto half = [](double v) { return static_cast<std::int64_t>(2 * v); };
    if (a != b) segments.push_back({half(a.x), half(a.y), half(b.x), half(b.y)});
  }
  if (segments.empty()) {
    return !path.empty() && grid.free({static_cast<int>(std::floor(path[0].x)),
                                       static_cast<int>(std::floor(path[0].y))});
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const HalfSegment& s = segments[i];
    if (!segment_obeys(grid, s)) return false;
    if (i == 0 || s.ax % 2 != 0 || s.ay % 2 != 0) continue;
    const HalfSegment& before = segments[i - 1];
    if (squeezes(grid, static_cast<int>(s.ax / 2), static_cast<int>(s.ay / 2),
                 static_cast<double>(before.ax - s.ax), static_cast<double>(before.ay - s.ay),
                 static_cast<double>(s.bx - s.ax), static_cast<double>(s.by - s.ay))) {
      return false;
    }
  }
  return true;
}

/// In floating point with a tolerance, the path as a whole.
class Checker {
 public:
  explicit Checker(const Grid& grid) : grid_(grid) {}

  bool obeys(std::span<const Point> path) const {
    std::vector<Point> points;
    for (const Point p : path) {
      if (points.empty() || std::hypot(p.x - points.back().x, p.y - points.back().y) > kEps) {
        points.push_back(p);
      }
    }
    if (points.empty()) return false;
    if (points.size() == 1) return grid_.free(cell_at(points[0].x, points[0].y));
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (!segment(points[i - 1], points[i])) return false;
    }
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Point v = points[i];
      if (whole(v.x) && whole(v.y) && squeezed(points[i - 1], v, points[i + 1])) return false;
    }
    return true;
  }

 private:
  static constexpr double kEps = 1e-6;
  static bool whole(double v) { return std::abs(v - std::round(v)) < kEps; }
  static Cell cell_at(double x, double y) {
    return {static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
  }

  bool squeezed(Point a, Point v, Point b) const {
    return squeezes(grid_, static_cast<int>(std::lround(v.x)), static_cast<int>(std::lround(v.y)),
                    a.x - v.x, a.y - v.y, b.x - v.x, b.y - v.y);
  }

  bool segment(Point p, Point q) const {
    if (p.x > q.x) std::swap(p, q);
    const double slope = q.x - p.x < kEps ? 0 : (q.y - p.y) / (q.x - p.x);
    const int first = static_cast<int>(std::floor(p.x - kEps));
    const int last = static_cast<int>(std::floor(q.x + kEps));
    for (int c = first; c <= last; ++c) {
      const double a = std::max(p.x, c + kEps);
      const double b = std::min(q.x, c + 1 - kEps);
      if (a > b) continue;
      double ya = p.y + slope * (a - p.x);
      double yb = p.y + slope * (b - p.x);
      if (q.x - p.x < kEps) {
        ya = p.y;
        yb = q.y;
      }
      if (ya > yb) std::swap(ya, yb);
      for (int r = static_cast<int>(std::floor(ya)); r <= static_cast<int>(std::floor(yb)); ++r) {
        if (yb > r + kEps && ya < r + 1 - kEps && grid_.blocked({c, r})) return false;
      }
    }
    return !between_blocks(p, q) && !squeezed_inside(p, q);
  }

  bool between_blocks(Point p, Point q) const {
    const bool upright = std::abs(p.x - q.x) < kEps && whole(p.x);
    const bool level = std::abs(p.y - q.y) < kEps && whole(p.y);
    if (!upright && !level) return false;
    const double lo = upright ? std::min(p.y, q.y) : p.x;
    const double hi = upright ? std::max(p.y, q.y) : q.x;
    const int line = static_cast<int>(std::lround(upright ? p.x : p.y));
    for (int i = static_cast<int>(std::floor(lo + kEps)); i < std::ceil(hi - kEps); ++i) {
      const Cell one = upright ? Cell{line - 1, i} : Cell{i, line - 1};
      const Cell two = upright ? Cell{line, i} : Cell{i, line};
      if (grid_.blocked(one) && grid_.blocked(two)) return true;
    }
    return false;
  }

  bool squeezed_inside(Point p, Point q) const {
    const bool flat = std::abs(q.x - p.x) >= std::abs(q.y - p.y);
    const double u0 = flat ? p.x : p.y;
    const double v0 = flat ? p.y : p.x;
    const double slope = flat ? (q.y - p.y) / (q.x - p.x) : (q.x - p.x) / (q.y - p.y);
    const double lo = std::min(u0, flat ? q.x : q.y);
    const double hi = std::max(u0, flat ? q.x : q.y);
    for (int u = static_cast<int>(std::ceil(lo + kEps)); u <= std::floor(hi - kEps); ++u) {
      const double v = v0 + slope * (u - u0);
      if (!whole(v)) continue;
      const Point at = flat ? Point{double(u), std::round(v)} : Point{std::round(v), double(u)};
      if (squeezed(p, at, q)) return true;
    }
    return false;
  }

  const Grid& grid_;
};

}  // namespace lasius::rule
