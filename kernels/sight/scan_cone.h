// Visible corners in a cone of rays, found row by row on the bits of a grid.
//
// Line j (j = 0, 1, ...) is a grid line, row j the cells between lines j and j + 1, counted away
// from the root. An interval is what the rays through one gap reach of a line. Going on by a row
// cuts it at the row's blocked cells: rays through a blocked cell's near edge end there, rays that
// meet its side end at the side, the others form the next intervals.
//
// Arithmetic. A boundary ray passes through the root, whose coordinates are multiples of 1/2, and
// through a lattice point. On a line at depth d <= 32768 its exact column is a fraction whose
// denominator is at most 2^17, so an exact column that is no integer is at least 2^-17 away from
// any. The computed column is off by less than 2^-29: a slope is a quotient of exact numbers,
// rounded to 2^-53 of itself (2^-38 columns over a run of at most 2^15) and then to 2^-44 (2^-29
// over at most 2^15 rows). Comparing with the slack kSlack = 2^-19 therefore decides "less, equal,
// greater" against integers as exact arithmetic would.
//
// A gap narrower than kSlack holds neither a lattice point nor a cell's centre strictly inside, on
// this line or later: such a point at depth d3 has a slope that differs from those of the boundary
// rays, made at depths d1 and d2, by at least 1/(4 d1 d3) and 1/(4 d2 d3), so at any depth from
// max(d1, d2) on the rays are at least 2^-17 + 2^-17 apart. Points on a boundary ray are in the
// cone of the corner which that ray touches. So such gaps are dropped, and with them those of
// width 0, where a ray would squeeze between two diagonal blocks.
//
// An edge of the limits is no ray. It cuts off only what lies a column or more outside of what is
// wanted, and a gap that it cut is followed only while it is wider than a column, so nothing that
// counts is decided within kSlack of an edge.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernels/sight/cone.h"
#include "kernels/sight/scan_bits.h"

namespace lasius::kernels {

constexpr Fixed kSlack = kOne >> 19;

/// Scans the cone of one root. A Visitor has
///   double corner(int u, int line, Turn)  for each corner that a taut path from the root may turn
///       at; returns the length of a shorter way there if it knows one, else a negative number
///   bool beaten(const Rival&, Fixed u, int line)  is the way over the rival to that point shorter
///       than the straight one from the root?
///   ConeLimits limits()  asked when the scan leaves the root's neighbourhood
///   bool go_on(std::int64_t words)  told of the work done, false to stop.
/// Corners come in a fixed order.
template <int S, class Visitor>
class ConeScan {
 public:
  /// @param near_lines  from the root, to where limits are asked for; and some more columns
  ConeScan(const ConeFrame& frame, std::vector<Interval>& stack, Visitor& visitor,
           int near_lines = kNearLines) noexcept
      : frame_(frame),
        row0_(bytes_of(frame.map.row(frame.down > 0 ? frame.line0 : frame.line0 - 1))),
        step_(frame.down * frame.map.stride * std::ptrdiff_t{sizeof(std::uint64_t)}),
        last_line_(std::min(near_lines, frame.lines())),
        limit_(fixed(floor_column(frame.root) + near_lines + kMoreColumns)),
        stack_(stack),
        visitor_(visitor) {}

  /// From a lattice point between two slopes. Returns whether rays were cut off at the limits.
  bool from_corner(Fixed left_slope, Fixed right_slope, const Rival& level = {-1, 0, 0}) {
    const int column = floor_column(frame_.root);
    const Fixed reach = frame_.root + right_slope;
    int last = last_cell(reach);
    int a = next_cell<S, true>(row0_, column, last);
    if (a > last && reach > limit_) {
      look_far();
      last = last_cell(reach);
      a = next_cell<S, true>(row0_, column, last);
    }
    Interval first{frame_.root + left_slope, reach, left_slope, right_slope, 1, a <= last, 0, 0};
    if (first.wall) first.right = fixed(a);
    if (level.length >= 0 && fixed(level.u) <= first.right &&
        visitor_.beaten(level, first.left, 1)) {
      return cut_off_;
    }
    if (first.right - first.left > kSlack && clip(first, 1)) run(first);
    return cut_off_;
  }

  /// From the centre of the cell before line 0: all rays towards larger u. `border` is the column
  /// that ends every row.
  bool from_centre(int border) {
    look_far();
    const int a = next_cell<S, true>(row0_ - step_, floor_column(frame_.root), border);
    Interval first{frame_.root, fixed(a), 0, 0, 0, true, 0, 0};
    if (clip(first, 0)) run(first);
    return cut_off_;
  }

 private:
  using B = Bits<S>;

  Fixed slope_to(int u, int line) const noexcept { return slope_through(fixed(u), line); }
  Fixed slope_through(Fixed u, int line) const noexcept {
    return static_cast<Fixed>(static_cast<double>(u - frame_.root) / (line + frame_.depth0));
  }

  // The last cell that a ray ending at this column passes, or the last one within the limit.
  int last_cell(Fixed reach) const noexcept {
    return floor_column((reach < limit_ ? reach : limit_) - kSlack);
  }

  // Most scans among many obstacles end near the root, where limits cost more than they save.
  [[gnu::noinline]] void look_far() {
    const ConeLimits limits = visitor_.limits();
    near_ = false;
    last_line_ = limits.last_line;
    limit_ = fixed(limits.last_column);
    left0_ = limits.left0;
    right0_ = limits.right0;
    slope_ = limits.slope;
  }

  // Cuts off what lies past the limits on a line. False if all that is left lies within a column of
  // the edge that cut it, which the caller made wider than what it needs: rays near an edge only
  // come nearer.
  bool clip(Interval& v, int line) {
    if (near_) {
      if (v.right <= limit_) return v.right - v.left > kSlack;
      look_far();
    }
    const Fixed moved = line * slope_;
    const Fixed left = left0_ + moved;
    const Fixed right = right0_ + moved < limit_ ? right0_ + moved : limit_;
    if (v.left >= left && v.right <= right) return v.right - v.left > kSlack;
    cut_off_ = true;
    if (v.left < left) v.left = left;
    if (v.right > right) {
      v.right = right;
      if (v.wall) v.right_slope = slope_through(v.right, line);
      v.wall = false;
    }
    return v.right - v.left > kOne;
  }

  // How far the right boundary moves in the row ahead. Along a wall it stays.
  static Fixed widening(const Interval& v) noexcept { return v.wall ? 0 : v.right_slope; }

  void run(Interval& first) {
    stack_.clear();
    bool going = follow(first);
    while (going && !stack_.empty()) {
      first = stack_.back();
      stack_.pop_back();
      if (clip(first, first.line)) going = follow(first);
    }
    visitor_.go_on(words_);
  }

  bool stopped() {
    if (words_ < kWordsAtOnce) return false;
    const bool stop = !visitor_.go_on(words_);
    words_ = 0;
    return stop;
  }

  // Follows one interval until it ends; further gaps go on the stack. False when stopped.
  bool follow(Interval& v) {
    const char* next = row0_ + step_ * v.line;
    int quiet = 0;  // consecutive rows that held nothing
    for (;; ++v.line, next += step_) {
      if (v.wall && !blocked_cell<S>(next, floor_column(v.right + kSlack))) {
        v.right_slope = slope_to(floor_column(v.right + kSlack), v.line);
        v.wall = false;
      }
      if (near_ && (v.line > last_line_ || v.right + widening(v) > limit_)) {
        look_far();
        if (!clip(v, v.line)) return true;
      }
      if (v.line > last_line_) break;
      ++words_;
      const int base = floor_column(v.left - kSlack);
      const int last_point = floor_column(v.right + kSlack);
      const int last = last_cell(v.right + widening(v));
      const int fresh = rivals_;
      if (last - base < B::kValid - 1 && last_point - base < B::kValid - 1) {
        const std::uint64_t n = B::window(next, base);
        const std::uint64_t p = B::window(next - step_, base);
        const int first = floor_column(v.left + kSlack);
        const std::uint64_t turns = turn_points(n, p, on_axis(v)) & B::to(last_point - base);
        const std::uint64_t blocks = n & B::from(first - base) & B::to(last - base);
        if ((turns | blocks) == 0) {
          v.left += v.left_slope;
          v.right += widening(v);
          if (v.wall) {
            next += follow_wall(next, v);
          } else if (++quiet >= kQuietRows) {
            next += stride(next, n, base, v);
          }
          if (!clip(v, v.line + 1)) return true;
          continue;
        }
        report(turns, n, p, base, v);
      } else if (!report_wide(next, base, last_point, v)) {
        return false;
      }
      quiet = 0;
      if (!split(next, last, v, fresh) || !clip(v, v.line + 1)) return true;
      if (stopped()) return false;
    }
    cut_off_ = true;
    return true;
  }

  // Rows without blocked cells go by several at a time. From a line whose row behind is n.
  [[gnu::noinline]] std::ptrdiff_t stride(const char* next, std::uint64_t n, int base,
                                          Interval& v) noexcept {
    std::ptrdiff_t moved = 0;
    for (;;) {
      const Fixed right = v.right + kStride * v.right_slope;
      const int hull = floor_column(right + kSlack) - base;
      if (hull >= B::kValid || v.line + kStride > last_line_) return moved;
      n |= B::window(next + step_, base) | B::window(next + 2 * step_, base) |
           B::window(next + 3 * step_, base);
      if ((n & B::to(hull)) != 0) return moved;
      n = 0;
      v.left += kStride * v.left_slope;
      v.right = right;
      v.line += kStride;
      next += kStride * step_;
      moved += kStride * step_;
      words_ += kStride;
    }
  }

  // Goes on along rows that are free up to the wall at the interval's right and blocked there: they
  // hold no corner and cut nothing. From the line after v.line, whose row behind is `row`, to where
  // the interval ends at the latest. Returns the bytes that it went on by.
  [[gnu::noinline]] std::ptrdiff_t follow_wall(const char* row, Interval& v) noexcept {
    const int base = floor_column(v.left - kSlack);
    const int wall = floor_column(v.right + kSlack) - base;
    if (wall < 0 || wall >= B::kValid) return 0;
    std::uint64_t like = B::only(wall);
    if (on_axis(v)) like |= B::window(row, base) & B::only(0);
    like = B::to_uncut(like, base);
    const std::uint64_t seen = B::to_uncut(B::to(wall), base);
    const auto alike = [&] { return ((B::uncut(row, base) ^ like) & seen) == 0; };
    const Fixed wide = v.right - v.left - kSlack;
    if (wide <= 0 || !alike()) return 0;
    const int most = std::min(kRowsAlongWall, last_line_ - v.line);
    int rows = 0;
    for (row += step_; rows < most && alike(); row += step_) ++rows;
    if (v.left_slope > wide / kRowsAlongWall)
      rows = std::min(rows, static_cast<int>((wide - 1) / v.left_slope) + 1);
    v.left += rows * v.left_slope;
    v.line += rows;
    words_ += rows;
    return rows * step_;
  }

  // Is the left boundary the line straight onward from a lattice root?
  bool on_axis(const Interval& v) const noexcept {
    return v.left == frame_.root && v.left_slope == 0 && frame_.depth0 == 0;
  }

  // Points (at indices >= 1) where a taut path may turn, from the rows ahead (n) and behind (p):
  // exactly one of the four cells is blocked and the ray passes beside it. Rays run towards larger
  // u, except the axis at index 1: it passes beside blocks behind, and goes straight on along
  // those ahead.
  static std::uint64_t turn_points(std::uint64_t n, std::uint64_t p, bool axis) noexcept {
    const std::uint64_t n1 = B::previous(n);
    const std::uint64_t p1 = B::previous(p);
    std::uint64_t found = ~n & ~p1 & (n1 ^ p);
    if (axis) {
      found &= ~(B::only(1) & n1);
      found |= B::only(1) & p1 & ~(p | n | n1);
    }
    return found & B::from(1);
  }

  void report(std::uint64_t turns, std::uint64_t n, std::uint64_t p, int base, Interval& v) {
    for (; turns != 0; turns &= ~B::only(B::first(turns))) {
      const int i = B::first(turns);
      const std::uint64_t bit = B::only(i);
      const Turn turn = (p & bit) != 0                ? Turn::sideways
                        : (B::previous(n) & bit) != 0 ? Turn::onward
                                                      : Turn::back;
      const double shorter = visitor_.corner(base + i, v.line, turn);
      const bool beaten = shorter >= 0 && rivals_ + 1 < kRivals;
      if (beaten) rival_[++rivals_] = {shorter, base + i, v.line};
      if (turn == Turn::sideways) v.right_rival = beaten ? rivals_ : 0;
      if (turn == Turn::back && beaten) v.left_rival = rivals_;
    }
  }

  bool report_wide(const char* next, int base, int last_point, Interval& v) {
    bool axis = on_axis(v);
    for (int c = base; c < last_point; c += B::kValid - 1, axis = false) {
      const std::uint64_t n = B::window(next, c);
      const std::uint64_t p = B::window(next - step_, c);
      const int last = last_point - c < B::kValid - 1 ? last_point - c : B::kValid - 1;
      report(turn_points(n, p, axis) & B::to(last), n, p, c, v);
      ++words_;
      if (stopped()) return false;
    }
    return true;
  }

  // Goes on by one row, cutting the interval at the row's blocked cells. The last gap stays in v
  // (false if there is none), on the line it had; the gaps before it go on the stack. `fresh` is
  // the number of the last rival before this row's.
  bool split(const char* next, int last, Interval& v, int fresh) {
    const Fixed right = v.right;
    int c = floor_column(v.left + kSlack);
    for (;;) {
      if (blocked_cell<S>(next, c)) {
        c = next_cell<S, false>(next, c + 1, last);
        if (fixed(c) >= right - kSlack) return false;
        v.left = fixed(c);
        v.left_slope = slope_to(c, v.line);
        v.left_rival = 0;
        while (fresh < rivals_ && rival_[fresh + 1].u < c) ++fresh;
        if (fresh < rivals_ && rival_[fresh + 1].u == c) {
          v.left_rival = static_cast<std::uint8_t>(fresh + 1);
        }
      }
      const int a = next_cell<S, true>(next, c, last);
      const Fixed left = v.left + v.left_slope;
      if (a > last) {
        v.left = left;
        v.right = right + widening(v);
        return v.right - left > kSlack && !beaten(v);
      }
      const Fixed stop = fixed(a);
      const bool open = stop - left > kSlack;
      if (stop >= right - kSlack) {  // the last gap
        v.right_rival = 0;
        v.left = left;
        v.right = stop;
        v.wall = true;
        return open && !beaten(v);
      }
      if (open) {
        // Field by field: a copied temporary would wait for its own stores.
        Interval& gap = stack_.emplace_back();
        gap.left = left;
        gap.right = stop;
        gap.left_slope = v.left_slope;
        gap.line = v.line;
        gap.wall = true;
        gap.left_rival = v.left_rival;
        if (beaten(gap)) {
          stack_.pop_back();
        } else {
          ++gap.line;
        }
      }
      c = a;
    }
  }

  // Is the root r no longer the way to go for any ray of this gap? Its ends are on the next line.
  // A rival corner w on one boundary ray sees every point p of the gap, because all rays between
  // came this far. |r p| - |w p| falls as p moves away from w's ray, so if the way over w is
  // shorter to the far end it is shorter to all p, and to all that lies behind them.
  bool beaten(const Interval& v) {
    return (v.left_rival != 0 && visitor_.beaten(rival_[v.left_rival], v.right, v.line + 1)) ||
           (v.right_rival != 0 && visitor_.beaten(rival_[v.right_rival], v.left, v.line + 1));
  }

  static constexpr int kRivals = 64;
  static constexpr int kNearLines = 12;
  static constexpr int kMoreColumns = 28;
  static constexpr int kQuietRows = 4;
  static constexpr int kStride = 3;
  static constexpr int kRowsAlongWall = 32;

  const ConeFrame& frame_;
  const char* row0_;
  std::ptrdiff_t step_;
  bool near_ = true;  // limits were not asked for yet
  int last_line_;
  Fixed limit_;
  Fixed left0_ = 0, right0_ = 0, slope_ = 0;
  std::vector<Interval>& stack_;
  Visitor& visitor_;
  std::int64_t words_ = 0;
  bool cut_off_ = false;
  std::uint8_t rivals_ = 0;
  Rival rival_[kRivals];  // from 1 on, in the order they were seen
};

}  // namespace lasius::kernels
