#include "core/disc/sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/disc/bit_rows.h"

namespace lasius::disc {
namespace {

/// Are all cells of a row free that meet the open interval of columns?
bool is_free(const Grid& grid, int y, double left, double right) noexcept {
  const int first = std::max(-1, static_cast<int>(std::floor(left)));
  const int last = std::min(grid.width(), static_cast<int>(std::ceil(right)) - 1);
  const std::uint64_t* const row = grid.row(y);
  for (int x = first; x <= last; x += 64) {
    const std::uint64_t bits = bits_from(row, x);
    if (last - x >= 63 ? bits != 0 : (bits << (63 - (last - x))) != 0) return false;
  }
  return true;
}

/// One side of what a disc sweeps on its way down from a to b, seen from the way.
struct Side {
  Point a, b;
  double radius, sign;  // -1 left, 1 right
  double slope;         // columns a row
  double x, y;          // from the way to the side, where it is straight

  double at(double height) const noexcept {
    if (height <= a.y + y) return cap(a, height);
    if (height >= b.y + y) return cap(b, height);
    return a.x + x + slope * (height - a.y - y);
  }
  double cap(Point p, double height) const noexcept {
    const double off = height - p.y;
    return p.x + sign * std::sqrt(std::max(0.0, radius * radius - off * off));
  }
};

}  // namespace

bool sweeps_clear(const Grid& grid, Point a, Point b, double radius) noexcept {
  const bool up = a.y > b.y;
  if (up) std::swap(a, b);
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
  const double share = length > 0 ? radius / length : 0, slope = dy > 0 ? dx / dy : 0;
  const Side left{a, b, radius, -1, slope, -dy * share, dx * share};
  const Side right{a, b, radius, 1, slope, dy * share, -dx * share};
  const Point leftmost = dx < 0 ? b : a, rightmost = dx < 0 ? a : b;
  const double top = a.y - radius, bottom = b.y + radius;
  const int first = std::max(-1, static_cast<int>(std::floor(top)));
  const int last = std::min(grid.height(), static_cast<int>(std::ceil(bottom)) - 1);
  for (int row = first; row <= last; ++row) {
    const int y = up ? first + last - row : row;
    const double from = std::max(top, 1.0 * y), to = std::min(bottom, y + 1.0);
    const auto clamped = [&](Point p) { return std::min(std::max(p.y, from), to); };
    if (!is_free(grid, y, left.at(clamped(leftmost)), right.at(clamped(rightmost)))) return false;
  }
  return true;
}

// In the quadrant of the arc, as if it were the first one.
bool turns_clear(const Grid& grid, Point centre, Point from, Point to, double radius,
                 double slack) noexcept {
  const bool right = from.x + to.x >= 2 * centre.x, down = from.y + to.y >= 2 * centre.y;
  Point low{std::abs(from.x - centre.x), std::abs(from.y - centre.y)};
  Point high{std::abs(to.x - centre.x), std::abs(to.y - centre.y)};
  if (low.x * high.y < low.y * high.x) std::swap(low, high);
  if (high.y == 0) return true;
  const double far = 2 * radius - 2 * slack, share = far / radius;
  const int x = static_cast<int>(centre.x), y = static_cast<int>(centre.y);
  for (int k = 0; k - slack < share * high.y; ++k) {
    const double top = std::max(0.0, k - slack), bottom = std::min(k + 1 - slack, share * high.y);
    const double left = slack + top * high.x / high.y;
    double end = share * low.x;
    if (bottom < share * low.y) end = bottom * low.x / low.y;
    if (top > share * low.y) end = std::sqrt(std::max(0.0, far * far - top * top));
    end += slack;
    const int row = down ? y + k : y - 1 - k;
    if (row < -1 || row > grid.height()) return false;
    if (!(right ? is_free(grid, row, x + left, x + end) : is_free(grid, row, x - end, x - left)))
      return false;
  }
  return true;
}

}  // namespace lasius::disc
