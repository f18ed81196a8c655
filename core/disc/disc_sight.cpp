// Straight moves of a disc.
#include <algorithm>
#include <bit>

#include "core/disc/disc_space.h"
#include "kernels/sight/scan_bits.h"
#include "kernels/sight/sight.h"

namespace lasius::disc {

/// From its upper end down.
struct DiscSpace::Segment {
  Point from, to;
  double x, y;    // along it
  double across;  // columns a row
  double least;   // of the square of what it has to pass circles' centres by, times its own
  double square;  // of its length
  bool clear_ends;
  mutable std::uint32_t passed = ~std::uint32_t{0};  // the arc compared last
  double at(double row) const noexcept {
    return row <= from.y ? from.x : row >= to.y ? to.x : from.x + (row - from.y) * across;
  }
};

// Of a cell of the band, past the arcs that pass it and within its box. The segment's part in the
// cell's row reaches from column `left` to `right`.
bool DiscSpace::keeps_cell(const Segment& segment, int x, int y, double left,
                           double right) const noexcept {
  for (const std::uint32_t number : arcs_at(x, y)) {
    if (number == segment.passed) continue;
    const Arc& arc = arcs_[segment.passed = number];
    const double to_x = arc.x - segment.from.x, to_y = arc.y - segment.from.y;
    const double beside = to_x * segment.y - to_y * segment.x;
    if (beside * beside >= segment.least) continue;
    const double along = to_x * segment.x + to_y * segment.y;
    if (along > 0 && along < segment.square) return false;
    if (segment.clear_ends) continue;
    const double end_x = along > 0 ? to_x - segment.x : to_x;
    const double end_y = along > 0 ? to_y - segment.y : to_y;
    if ((end_x * end_x + end_y * end_y) * segment.square < segment.least) return false;
  }
  const unsigned around = walls(x, y);
  if (around == 0) return true;
  const Box box = box_of(around, x, y);
  const double low = std::max<double>(left, x), high = std::min<double>(right, x + 1);
  if (low < box.left || high > box.right) return false;
  double top = std::max<double>(y, segment.from.y), bottom = std::min<double>(y + 1, segment.to.y);
  if (top >= box.top && bottom <= box.bottom) return true;
  if (left < x || right > x + 1) {  // the part that is in the cell
    const double slope = segment.y / segment.x;
    const double enters = segment.from.y + (low - segment.from.x) * slope;
    const double leaves = segment.from.y + (high - segment.from.x) * slope;
    const auto [first, last] = std::minmax(enters, leaves);
    top = std::max(top, first);
    bottom = std::min(bottom, last);
  }
  return top >= box.top && bottom <= box.bottom;
}

bool DiscSpace::keeps_row(const Segment& segment, int y, double low_x,
                          double high_x) const noexcept {
  const int first = std::clamp(static_cast<int>(low_x), 0, map_.width() - 1);
  const int beyond = static_cast<int>(high_x);  // a cell that it only touches does not count
  const int last =
      std::max(first, std::min(map_.width() - 1, beyond < high_x ? beyond : beyond - 1));
  using B = kernels::Bits<1>;
  const char* blocked = kernels::bytes_of(blocked_.row(y));
  const char* band = kernels::bytes_of(band_.row(y));
  for (int x = first; x <= last; x += B::kValid) {
    const std::uint64_t mask = B::to(std::min(B::kValid - 1, last - x));
    if ((B::window(blocked, x) & mask) != 0) return false;
    for (std::uint64_t left = B::window(band, x) & mask; left != 0; left &= left - 1)
      if (!keeps_cell(segment, x + std::countr_zero(left), y, low_x, high_x)) return false;
  }
  return true;
}

bool DiscSpace::keeps(Point a, Point b, bool clear_ends, double slack) const noexcept {
  if (a.y > b.y) std::swap(a, b);
  const double x = b.x - a.x, y = b.y - a.y;
  const double limit = radius_ - slack;
  const Segment segment{
      a, b, x, y, y > 0 ? x / y : 0, limit * limit * (x * x + y * y), x * x + y * y, clear_ends};
  const int first = std::clamp(static_cast<int>(a.y), 0, map_.height() - 1);
  const int beyond = static_cast<int>(b.y);
  const int last = std::max(first, std::min(map_.height() - 1, beyond < b.y ? beyond : beyond - 1));
  double top = a.x;
  for (int row = first; row <= last;) {
    // The rows of a tile at once, where its cells, and those beside it, are free.
    const int end = std::min(last, row | 7);
    const double bottom = end == last ? b.x : segment.at(end + 1);
    const auto [low, high] = std::minmax(top, bottom);
    const int left = std::clamp(static_cast<int>(low), 0, map_.width() - 1);
    const int right = std::clamp(static_cast<int>(high), left, map_.width() - 1);
    if (!kernels::row_free(crowded_.row(row >> 3), left >> 3, right >> 3)) {
      double above = top;
      for (; row < end; ++row) {
        const double below = segment.at(row + 1);
        if (!keeps_row(segment, row, std::min(above, below), std::max(above, below))) return false;
        above = below;
      }
      if (!keeps_row(segment, row, std::min(above, bottom), std::max(above, bottom))) return false;
    }
    row = end + 1;
    top = bottom;
  }
  return true;
}

}  // namespace lasius::disc
