#include "core/smooth/triangle.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/base/poller.h"

namespace lasius {
namespace {

using kernels::BitmapView;
using kernels::HalfPoint;

// x of an edge at falling heights: floor + part / whole.
class EdgeX {
 public:
  // At height y, a.y <= y <= b.y, a.y < b.y; then two half cells further with each step.
  EdgeX(HalfPoint a, HalfPoint b, int y) noexcept : whole_(b.y - a.y) {
    const std::int64_t dx = b.x - a.x;
    std::int64_t rest = dx * (y - a.y);
    floor_ = a.x + floor_div(rest);
    part_ = rest - floor_div(rest) * whole_;
    rest = 2 * dx;
    step_ = floor_div(rest);
    part_step_ = rest - step_ * whole_;
  }
  void step() noexcept {
    floor_ += step_;
    part_ += part_step_;
    if (part_ >= whole_) {
      part_ -= whole_;
      ++floor_;
    }
  }
  int first_even() const noexcept { return static_cast<int>((floor_ + (part_ > 0) + 1) & ~1LL); }
  int last_even() const noexcept { return static_cast<int>(floor_ & ~1LL); }

 private:
  std::int64_t floor_div(std::int64_t n) const noexcept {
    return n / whole_ - (n % whole_ != 0 && n < 0);
  }
  std::int64_t whole_;
  std::int64_t floor_;
  std::int64_t part_;
  std::int64_t step_;
  std::int64_t part_step_;
};

// Looks for corners of blocked cells inside one triangle, a line of the lattice at a time.
class CornerScan {
 public:
  CornerScan(const BitmapView& map, HalfPoint a, HalfPoint b, HalfPoint c) noexcept
      : map_(map), a_(a), b_(b), c_(c), sign_(turn(a, b, c) > 0 ? 1 : -1) {}

  // The leftmost and rightmost corners on line y between x_lo and x_hi (even), of cells below the
  // line and above it if they are in the triangle's height.
  void line(int y, int x_lo, int x_hi, bool above, bool below, std::vector<HalfPoint>& corners) {
    const std::uint64_t* upper = map_.row((y >> 1) - (above ? 1 : 0));
    const std::uint64_t* lower = map_.row((y >> 1) - (below ? 0 : 1));
    const int first = (x_lo >> 1) - 1;
    const int last = x_hi >> 1;
    int left = x_hi + 2;  // of the leftmost corner, none yet
    for (int word = first >> 6; word <= last >> 6 && left > x_hi; ++word) {
      std::uint64_t bits = within(upper[word] | lower[word], word, first, last);
      for (++work_; bits != 0 && left > x_hi; bits &= bits - 1) {
        const int cell = word * 64 + std::countr_zero(bits);
        for (int x = std::max(2 * cell, x_lo); x <= std::min(2 * cell + 2, x_hi); x += 2) {
          if (!counts(x, y, cell, above, below)) continue;
          left = x;
          break;
        }
      }
    }
    if (left > x_hi) return;
    corners.push_back({left, y});
    for (int word = last >> 6; word >= first >> 6; --word) {
      std::uint64_t bits = within(upper[word] | lower[word], word, first, last);
      ++work_;
      while (bits != 0) {
        const int cell = word * 64 + 63 - std::countl_zero(bits);
        bits &= ~(std::uint64_t{1} << (cell & 63));
        for (int x = std::min(2 * cell + 2, x_hi); x >= std::max(2 * cell, x_lo); x -= 2) {
          if (!counts(x, y, cell, above, below)) continue;
          if (x > left) corners.push_back({x, y});
          return;
        }
      }
    }
  }

  // Words scanned since the last call, at least 1 a line.
  std::int64_t take_work() noexcept { return std::exchange(work_, 1); }

 private:
  static std::uint64_t within(std::uint64_t bits, int word, int first, int last) noexcept {
    if (word == first >> 6) bits &= ~std::uint64_t{0} << (first & 63);
    if (word == last >> 6) bits &= ~std::uint64_t{0} >> (63 - (last & 63));
    return bits;
  }

  // Side of a - b and b - c that a point is on: positive inside.
  std::int64_t inside_ab(HalfPoint p) const noexcept { return sign_ * turn(a_, b_, p); }
  std::int64_t inside_bc(HalfPoint p) const noexcept { return sign_ * turn(b_, c_, p); }

  // True when the corner (x, y) of a cell in this column, above or below the line, bounds the
  // path: it is not on a - c, and its cell reaches into the triangle. A corner on a - b or b - c
  // may be touched from outside; such a cell lies on one side of that edge as a whole.
  bool counts(int x, int y, int cell, bool above, bool below) const noexcept {
    const HalfPoint p{x, y};
    if (sign_ * turn(c_, a_, p) <= 0) return false;
    const std::int64_t ab = inside_ab(p);
    const std::int64_t bc = inside_bc(p);
    if (ab > 0 && bc > 0) return true;
    for (int side = 0; side < 2; ++side) {
      if (!(side == 0 ? above : below)) continue;
      const int row = (y >> 1) - 1 + side;
      if (!map_.blocked(cell, row)) continue;
      const HalfPoint centre{2 * cell + 1, 2 * row + 1};
      if ((ab > 0 || inside_ab(centre) > 0) && (bc > 0 || inside_bc(centre) > 0)) return true;
    }
    return false;
  }

  const BitmapView& map_;
  HalfPoint a_;
  HalfPoint b_;
  HalfPoint c_;
  std::int64_t sign_;
  std::int64_t work_ = 1;
};

// p is farther from `from` than q.
bool farther(HalfPoint from, HalfPoint p, HalfPoint q) noexcept {
  const auto squared = [from](HalfPoint r) {
    const std::int64_t dx = r.x - from.x;
    const std::int64_t dy = r.y - from.y;
    return dx * dx + dy * dy;
  };
  return squared(p) > squared(q);
}

// All corners that may be on the chain. False when told to stop before.
bool find_corners(const BitmapView& map, HalfPoint a, HalfPoint b, HalfPoint c, Poller& poller,
                  std::vector<HalfPoint>& corners) {
  HalfPoint top = a;
  HalfPoint middle = b;
  HalfPoint bottom = c;
  if (top.y > middle.y) std::swap(top, middle);
  if (middle.y > bottom.y) std::swap(middle, bottom);
  if (top.y > middle.y) std::swap(top, middle);
  CornerScan scan(map, a, b, c);
  int y = (top.y + 1) & ~1;
  EdgeX through(top, bottom, y);  // the edge that spans all rows
  const bool through_is_left = turn(top, bottom, middle) < 0;
  for (const auto& [from, to] : {std::pair{top, middle}, std::pair{middle, bottom}}) {
    if (from.y == to.y || y > to.y) continue;
    EdgeX bent(from, to, y);
    for (; y <= to.y; y += 2, through.step(), bent.step()) {
      const EdgeX& left = through_is_left ? through : bent;
      const EdgeX& right = through_is_left ? bent : through;
      const int x_lo = left.first_even();
      const int x_hi = right.last_even();
      const bool on_ac = a.y == c.y && y == a.y;
      if (x_lo <= x_hi && !on_ac) scan.line(y, x_lo, x_hi, y > top.y, y < bottom.y, corners);
      if (poller.stop_after(scan.take_work())) return false;
    }
  }
  return true;
}

}  // namespace

bool bends_round_block(const BitmapView& map, HalfPoint a, HalfPoint b, HalfPoint c) noexcept {
  const std::int64_t bend = turn(a, b, c);
  if (bend == 0 || ((b.x | b.y) & 1) != 0) return false;
  const int x = b.x >> 1;
  const int y = b.y >> 1;
  for (int qy = -1; qy <= 0; ++qy) {
    for (int qx = -1; qx <= 0; ++qx) {
      if (!map.blocked(x + qx, y + qy)) continue;
      // Neither segment enters the cell: it is inside the angle if its centre is.
      const HalfPoint centre{b.x + 2 * qx + 1, b.y + 2 * qy + 1};
      const std::int64_t ab = turn(a, b, centre);
      const std::int64_t bc = turn(b, c, centre);
      if (bend > 0 ? ab > 0 && bc > 0 : ab < 0 && bc < 0) return true;
    }
  }
  return false;
}

bool chain_in_triangle(const BitmapView& map, HalfPoint a, HalfPoint b, HalfPoint c, Poller& poller,
                       std::vector<HalfPoint>& corners, std::vector<HalfPoint>& chain) {
  corners.clear();
  chain.clear();
  if (!find_corners(map, a, b, c, poller, corners)) return false;
  // The hull of a, c and the corners from a round to c, by gift wrapping: few vertices, so fast.
  const std::int64_t sign = turn(a, b, c) > 0 ? 1 : -1;
  for (HalfPoint at = a;;) {
    HalfPoint next = c;
    for (const HalfPoint p : corners) {
      const std::int64_t side = sign * turn(at, next, p);
      if (side < 0 || (side == 0 && farther(at, p, next))) next = p;
    }
    if (next == c) return true;
    if (poller.stop_after(static_cast<std::int64_t>(corners.size()))) return false;
    chain.push_back(next);
    at = next;
  }
}

}  // namespace lasius
