#include "core/smooth/triangle.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace lasius {
namespace {

using kernels::BitmapView;
using kernels::FinePoint;
using kernels::HalfPoint;

template <class P>
constexpr typename PointScale<P>::Number kCellOf =
    typename PointScale<P>::Number{1} << PointScale<P>::kBits;

// x of an edge at falling heights: floor + part / whole.
template <class P>
class EdgeX {
 public:
  using Number = typename PointScale<P>::Number;
  using Wide = typename PointScale<P>::Wide;

  // At height y, a.y <= y <= b.y, a.y < b.y; then a cell further with each step.
  EdgeX(P a, P b, Number y) noexcept : whole_(b.y - a.y) {
    const Wide dx = b.x - a.x;
    Wide rest = dx * (y - a.y);
    floor_ = a.x + floor_div(rest);
    part_ = rest - floor_div(rest) * whole_;
    rest = kCell * dx;
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
  // The nearest grid lines to the right and to the left.
  Number first_line() const noexcept {
    return static_cast<Number>((floor_ + (part_ > 0) + kCell - 1) & -kCell);
  }
  Number last_line() const noexcept { return static_cast<Number>(floor_ & -kCell); }

 private:
  static constexpr Wide kCell = kCellOf<P>;
  Wide floor_div(Wide n) const noexcept { return n / whole_ - (n % whole_ != 0 && n < 0); }
  Wide whole_;
  Wide floor_;
  Wide part_;
  Wide step_;
  Wide part_step_;
};

// Looks for corners of blocked cells inside one triangle, a line of the lattice at a time.
template <class P>
class CornerScan {
 public:
  using Number = typename PointScale<P>::Number;

  CornerScan(const BitmapView& map, P a, P b, P c) noexcept
      : map_(map), a_(a), b_(b), c_(c), sign_(turn(a, b, c) > 0 ? 1 : -1) {}

  // The leftmost and rightmost corners on line y between x_lo and x_hi, grid lines all, of cells
  // below the line and above it if they are in the triangle's height.
  void line(Number y, Number x_lo, Number x_hi, bool above, bool below, std::vector<P>& corners) {
    const std::uint64_t* upper = map_.row(cells(y) - (above ? 1 : 0));
    const std::uint64_t* lower = map_.row(cells(y) - (below ? 0 : 1));
    const int first = cells(x_lo) - 1;
    const int last = cells(x_hi);
    Number left = x_hi + kCell;  // of the leftmost corner, none yet
    for (int word = first >> 6; word <= last >> 6 && left > x_hi; ++word) {
      std::uint64_t bits = within(upper[word] | lower[word], word, first, last);
      for (++work_; bits != 0 && left > x_hi; bits &= bits - 1) {
        const int cell = word * 64 + std::countr_zero(bits);
        for (Number x = std::max(kCell * cell, x_lo); x <= std::min(kCell * (cell + 1), x_hi);
             x += kCell) {
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
        for (Number x = std::min(kCell * (cell + 1), x_hi); x >= std::max(kCell * cell, x_lo);
             x -= kCell) {
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
  static constexpr Number kCell = kCellOf<P>;
  static int cells(Number v) noexcept { return static_cast<int>(v >> PointScale<P>::kBits); }
  static std::uint64_t within(std::uint64_t bits, int word, int first, int last) noexcept {
    if (word == first >> 6) bits &= ~std::uint64_t{0} << (first & 63);
    if (word == last >> 6) bits &= ~std::uint64_t{0} >> (63 - (last & 63));
    return bits;
  }

  // Side of a - b and b - c that a point is on: positive inside.
  auto inside_ab(P p) const noexcept { return sign_ * turn(a_, b_, p); }
  auto inside_bc(P p) const noexcept { return sign_ * turn(b_, c_, p); }

  // True when the corner (x, y) of a cell in this column, above or below the line, bounds the
  // path: it is not on a - c, and its cell reaches into the triangle. A corner on a - b or b - c
  // may be touched from outside; such a cell lies on one side of that edge as a whole.
  bool counts(Number x, Number y, int cell, bool above, bool below) const noexcept {
    const P p{x, y};
    if (sign_ * turn(c_, a_, p) <= 0) return false;
    const auto ab = inside_ab(p);
    const auto bc = inside_bc(p);
    if (ab > 0 && bc > 0) return true;
    for (int side = 0; side < 2; ++side) {
      if (!(side == 0 ? above : below)) continue;
      const int row = cells(y) - 1 + side;
      if (!map_.blocked(cell, row)) continue;
      const P centre{kCell * cell + kCell / 2, kCell * row + kCell / 2};
      if ((ab > 0 || inside_ab(centre) > 0) && (bc > 0 || inside_bc(centre) > 0)) return true;
    }
    return false;
  }

  const BitmapView& map_;
  P a_;
  P b_;
  P c_;
  int sign_;
  std::int64_t work_ = 1;
};

// p is farther from `from` than q.
template <class P>
bool farther(P from, P p, P q) noexcept {
  const auto squared = [from](P r) {
    const typename PointScale<P>::Wide dx = r.x - from.x, dy = r.y - from.y;
    return dx * dx + dy * dy;
  };
  return squared(p) > squared(q);
}

// All corners that may be on the chain. False when told to stop before.
template <class P>
bool find_corners(const BitmapView& map, P a, P b, P c, Poller& poller, std::vector<P>& corners) {
  constexpr auto kCell = kCellOf<P>;
  P top = a;
  P middle = b;
  P bottom = c;
  if (top.y > middle.y) std::swap(top, middle);
  if (middle.y > bottom.y) std::swap(middle, bottom);
  if (top.y > middle.y) std::swap(top, middle);
  CornerScan<P> scan(map, a, b, c);
  auto y = (top.y + kCell - 1) & -kCell;
  if (y > bottom.y) return true;
  EdgeX<P> through(top, bottom, y);  // the edge that spans all rows
  const bool through_is_left = turn(top, bottom, middle) < 0;
  for (const auto& [from, to] : {std::pair{top, middle}, std::pair{middle, bottom}}) {
    if (from.y == to.y || y > to.y) continue;
    EdgeX<P> bent(from, to, y);
    for (; y <= to.y; y += kCell, through.step(), bent.step()) {
      const EdgeX<P>& left = through_is_left ? through : bent;
      const EdgeX<P>& right = through_is_left ? bent : through;
      const auto x_lo = left.first_line();
      const auto x_hi = right.last_line();
      const bool on_ac = a.y == c.y && y == a.y;
      if (x_lo <= x_hi && !on_ac) scan.line(y, x_lo, x_hi, y > top.y, y < bottom.y, corners);
      if (poller.stop_after(scan.take_work())) return false;
    }
  }
  return true;
}

}  // namespace

template <class P>
bool bends_round_block(const BitmapView& map, P a, P b, P c) noexcept {
  constexpr auto kCell = kCellOf<P>;
  const auto bend = turn(a, b, c);
  if (bend == 0 || ((b.x | b.y) & (kCell - 1)) != 0) return false;
  const int x = static_cast<int>(b.x >> PointScale<P>::kBits);
  const int y = static_cast<int>(b.y >> PointScale<P>::kBits);
  for (int qy = -1; qy <= 0; ++qy) {
    for (int qx = -1; qx <= 0; ++qx) {
      if (!map.blocked(x + qx, y + qy)) continue;
      // Neither segment enters the cell: it is inside the angle if its centre is.
      const P centre{b.x + kCell * qx + kCell / 2, b.y + kCell * qy + kCell / 2};
      const auto ab = turn(a, b, centre);
      const auto bc = turn(b, c, centre);
      if (bend > 0 ? ab > 0 && bc > 0 : ab < 0 && bc < 0) return true;
    }
  }
  return false;
}

template <class P>
bool chain_in_triangle(const BitmapView& map, P a, P b, P c, Poller& poller,
                       std::vector<P>& corners, std::vector<P>& chain) {
  corners.clear();
  chain.clear();
  if (!find_corners(map, a, b, c, poller, corners)) return false;
  // The hull of a, c and the corners from a round to c, by gift wrapping: few vertices, so fast.
  const int sign = turn(a, b, c) > 0 ? 1 : -1;
  for (P at = a;;) {
    P next = c;
    for (const P p : corners) {
      const auto side = sign * turn(at, next, p);
      if (side < 0 || (side == 0 && farther(at, p, next))) next = p;
    }
    if (next == c) return true;
    if (poller.stop_after(static_cast<std::int64_t>(corners.size()))) return false;
    chain.push_back(next);
    at = next;
  }
}

template bool bends_round_block(const BitmapView&, HalfPoint, HalfPoint, HalfPoint) noexcept;
template bool bends_round_block(const BitmapView&, FinePoint, FinePoint, FinePoint) noexcept;
template bool chain_in_triangle(const BitmapView&, HalfPoint, HalfPoint, HalfPoint, Poller&,
                                std::vector<HalfPoint>&, std::vector<HalfPoint>&);
template bool chain_in_triangle(const BitmapView&, FinePoint, FinePoint, FinePoint, Poller&,
                                std::vector<FinePoint>&, std::vector<FinePoint>&);

}  // namespace lasius
