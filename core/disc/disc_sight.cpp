// Straight moves of a disc.
#include <algorithm>
#include <bit>
#include <cmath>

#include "core/disc/disc_space.h"
#include "kernels/sight/sight.h"

namespace lasius::disc {

/// From its upper end down.
struct DiscSpace::Segment {
  Point from, to;
  double x, y;    // along it
  double across;  // columns a row
  double least;   // of the square of what it has to pass circles' centres by, times its own
  double at(double row) const noexcept {
    return row <= from.y ? from.x : row >= to.y ? to.x : from.x + (row - from.y) * across;
  }
};

bool DiscSpace::keeps_arcs(const Segment& segment, int x, int y) const noexcept {
  const double whole = segment.x * segment.x + segment.y * segment.y;
  for (const std::uint32_t number : arcs_at(x, y)) {
    const double to_x = arcs_[number].x - segment.from.x, to_y = arcs_[number].y - segment.from.y;
    const double beside = to_x * segment.y - to_y * segment.x;
    if (beside * beside >= segment.least) continue;
    const double along = to_x * segment.x + to_y * segment.y;
    if (along > 0 && along < whole) return false;  // its ends are clear
  }
  return true;
}

bool DiscSpace::keeps_box(const Segment& segment, int x, int y) const noexcept {
  const BandCell& cell = band_cell(x, y);
  constexpr std::uint32_t kWhole = (1u << 24) - 1;
  if ((cell.box_and_count & kWhole) == kWhole) return true;
  const Box box = box_of(cell, x, y);
  double top = std::max<double>(y, segment.from.y), bottom = std::min<double>(y + 1, segment.to.y);
  double left = segment.at(top), right = segment.at(bottom);
  if (left > right) std::swap(left, right);
  if (left < x || right > x + 1) {  // the part that is in the cell
    const double slope = segment.y / segment.x;
    const double enters = segment.from.y + (std::max<double>(left, x) - segment.from.x) * slope;
    const double leaves =
        segment.from.y + (std::min<double>(right, x + 1) - segment.from.x) * slope;
    const auto [first, last] = std::minmax(enters, leaves);
    top = std::max(top, first);
    bottom = std::min(bottom, last);
    left = std::max<double>(left, x);
    right = std::min<double>(right, x + 1);
  }
  return left >= box.left && right <= box.right && top >= box.top && bottom <= box.bottom;
}

bool DiscSpace::keeps_row(const Segment& segment, int y, double low_x,
                          double high_x) const noexcept {
  const int first = std::clamp(static_cast<int>(low_x), 0, map_.width() - 1);
  const int last = std::clamp(static_cast<int>(std::ceil(high_x)) - 1, first, map_.width() - 1);
  const std::uint64_t* blocked = blocked_.row(y);
  const std::uint64_t* band = band_.row(y);
  for (int word = first >> 6; word <= last >> 6; ++word) {
    std::uint64_t mask = ~std::uint64_t{0};
    if (word == first >> 6) mask &= ~std::uint64_t{0} << (first & 63);
    if (word == last >> 6) mask &= ~std::uint64_t{0} >> (63 - (last & 63));
    if ((blocked[word] & mask) != 0) return false;
    for (std::uint64_t left = band[word] & mask; left != 0; left &= left - 1) {
      const int x = 64 * word + std::countr_zero(left);
      if (!keeps_arcs(segment, x, y) || !keeps_box(segment, x, y)) return false;
    }
  }
  return true;
}

bool DiscSpace::sees(Point a, Point b) const noexcept {
  if (a.y > b.y) std::swap(a, b);
  const double x = b.x - a.x, y = b.y - a.y;
  const double limit = radius_ - kSlack;
  const Segment segment{a, b, x, y, y > 0 ? x / y : 0, limit * limit * (x * x + y * y)};
  const int first = std::clamp(static_cast<int>(a.y), 0, map_.height() - 1);
  const int last = std::clamp(static_cast<int>(std::ceil(b.y)) - 1, first, map_.height() - 1);
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
