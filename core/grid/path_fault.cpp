#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>

#include "core/base/number_text.h"
#include "core/grid/grid_view.h"
#include "kernels/sight/sight.h"
#include "lasius/path/path.h"

namespace lasius {
namespace {

using kernels::BitmapView;
using kernels::HalfPoint;

std::string text(Cell c) { return pair_text(c.x, c.y); }

int sign(int v) noexcept { return v > 0 ? 1 : -1; }

// Cells that the open interval (a, b) of half cells meets, in the order of travel from a to b.
struct Span {
  int first;
  int last;
  int step;
};
Span span_of(int a, int b) noexcept {
  return a < b ? Span{a >> 1, ((b + 1) >> 1) - 1, 1} : Span{((a + 1) >> 1) - 1, b >> 1, -1};
}

// A segment on a grid line: level, or upright.
std::string line_fault(const BitmapView& map, HalfPoint a, HalfPoint b, bool squeezes) {
  const bool level = a.y == b.y;
  const int line = (level ? a.y : a.x) >> 1;
  const auto beside = [&](int i, int side) {
    return level ? Cell{i, line + side} : Cell{line + side, i};
  };
  const auto blocked = [&](Cell c) { return map.blocked(c.x, c.y); };
  const Span span = level ? span_of(a.x, b.x) : span_of(a.y, b.y);
  for (int i = span.first;; i += span.step) {
    const std::array<Cell, 2> here{beside(i, -1), beside(i, 0)};
    if (blocked(here[0]) && blocked(here[1]))
      return "runs between the blocked cells " + text(here[0]) + " and " + text(here[1]);
    if (i == span.last) return {};
    for (int side = 0; squeezes && side < 2; ++side) {
      const Cell across = beside(i + span.step, -side);
      if (blocked(here[side]) && blocked(across))
        return "squeezes between the blocked cells " + text(here[side]) + " and " + text(across);
    }
  }
}

// Any other segment: row by row in the order of travel, the cells it enters.
std::string cells_fault(const BitmapView& map, HalfPoint a, HalfPoint b, bool squeezes) {
  const std::int64_t dx = b.x - a.x;
  const std::int64_t dy = b.y - a.y;
  const Span rows = a.y == b.y ? Span{a.y >> 1, a.y >> 1, 1} : span_of(a.y, b.y);
  const int step_x = dx < 0 ? -1 : 1;
  // Column of the first cell entered after (ahead), or the last before (behind), the height y.
  const auto column = [&](int y, bool ahead) {
    if (dy == 0) return ahead ? span_of(a.x, b.x).first : span_of(a.x, b.x).last;
    const std::int64_t n = (a.x * dy + dx * (y - a.y)) * sign(static_cast<int>(dy));
    const std::int64_t d = 2 * std::abs(dy);
    const bool right = ahead == (step_x > 0);                      // of where it crosses the height
    return static_cast<int>(right ? n / d : (n + d - 1) / d - 1);  // n is never below 0
  };
  const auto ahead = [&](int y) { return column(y, true); };
  const auto behind = [&](int y) { return column(y, false); };
  for (int row = rows.first;; row += rows.step) {
    const int enter = row == rows.first ? a.y : 2 * row + (rows.step > 0 ? 0 : 2);
    const int leave = row == rows.last ? b.y : 2 * row + (rows.step > 0 ? 2 : 0);
    const int first = ahead(enter);
    const int last = dx == 0 ? first : behind(leave);
    if (squeezes && row != rows.first && first != behind(enter) && dx != 0) {
      const Cell one{first, row - rows.step};
      const Cell two{first - step_x, row};
      if (map.blocked(one.x, one.y) && map.blocked(two.x, two.y))
        return "squeezes between the blocked cells " + text(one) + " and " + text(two);
    }
    for (int x = first;; x += step_x) {
      if (map.blocked(x, row)) return "enters the blocked cell " + text(Cell{x, row});
      if (x == last) break;
    }
    if (row == rows.last) return {};
  }
}

// What keeps a from seeing b; empty where it is a squeeze that is allowed.
std::string segment_fault(const BitmapView& map, HalfPoint a, HalfPoint b, bool squeezes) {
  const bool on_line = (a.y == b.y && a.y % 2 == 0) || (a.x == b.x && a.x % 2 == 0);
  return on_line ? line_fault(map, a, b, squeezes) : cells_fault(map, a, b, squeezes);
}

// Of a coordinate on a map.
bool half_integer(double v) noexcept { return 2 * v == static_cast<int>(2 * v); }

HalfPoint half_point(Point p) noexcept {
  return {static_cast<int>(2 * p.x), static_cast<int>(2 * p.y)};
}
bool is_half(Point p) noexcept { return half_integer(p.x) && half_integer(p.y); }

std::string text(Point p) { return pair_text(p.x, p.y); }

// The same of a segment that begins or ends anywhere.
std::string fine_fault(const BitmapView& map, Point a, Point b) {
  if (kernels::sees_fine(map, kernels::fine(a.x, a.y), kernels::fine(b.x, b.y))) return {};
  return "meets a blocked cell or runs or squeezes between two";
}

// A half point in the direction of another point, as seen from a lattice point v.
HalfPoint towards(HalfPoint v, Point p) noexcept {
  const auto step = [](int from, double to) { return from + (2 * to > from) - (2 * to < from); };
  return {step(v.x, p.x), step(v.y, p.y)};
}

}  // namespace

std::optional<std::string> path_fault(const Grid& grid, std::span<const Point> path,
                                      Corners corners) {
  const BitmapView map = view_of(grid);
  const bool squeezes = corners != Corners::allow;
  if (path.empty()) return "the path is empty";
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Point p = path[i];
    const auto vertex = [&] { return "vertex " + std::to_string(i) + ' ' + text(p) + " is "; };
    if (!(p.x >= 0 && p.x <= grid.width() && p.y >= 0 && p.y <= grid.height()))
      return vertex() + "outside the map";
    if (i > 0 && i + 1 < path.size() && !is_half(p)) return vertex() + "not at multiples of 0.5";
  }
  Point a = path[0];
  std::optional<Point> before;  // the vertex before a; repeated ones count once
  for (const Point b : path) {
    if (b == a) continue;
    const bool half = is_half(a) && is_half(b);
    if (!half || !kernels::sees(map, half_point(a), half_point(b))) {
      const std::string fault =
          half ? segment_fault(map, half_point(a), half_point(b), squeezes) : fine_fault(map, a, b);
      if (!fault.empty()) return "segment " + text(a) + " - " + text(b) + ' ' + fault;
    }
    if (squeezes && before && is_half(a)) {
      const HalfPoint v = half_point(a);
      if (v.x % 2 == 0 && v.y % 2 == 0 &&
          kernels::squeezes(map, towards(v, *before), v, towards(v, b))) {
        return "the path squeezes between blocked cells at " + text(a);
      }
    }
    before = std::exchange(a, b);
  }
  const kernels::FinePoint at = kernels::fine(a.x, a.y);
  if (!before && !kernels::sees_fine(map, at, at))
    return "the only vertex " + text(a) + " touches no free cell";
  return std::nullopt;
}

}  // namespace lasius
