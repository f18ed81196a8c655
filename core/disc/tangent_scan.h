// The rays that leave a circle along one of its arcs, or a point, followed row by row on bits.
//
// Rays run into one quadrant, in mirrored columns u as in kernels/sight/scan_cone.h, whose windows
// and fixed point this shares: line j (j = 0, 1, ...) is a grid line, row j the cells between lines
// j and j + 1. A gap holds what the rays between two of them reach of a line. Blocked cells, in
// which no point is free, cut gaps, and so do shadows that the visitor casts; the rest of the band
// does not: what is found may turn out to be out of sight. Rays past a blocked cell are those past
// its corners, tangents from the circle to a lattice point.
//
// A gap grows as long as rays still leave the circle: one of its sides is the circle itself, which
// is free there, until the row in which the last ray leaves.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/disc/tangent.h"
#include "kernels/sight/cone.h"
#include "kernels/sight/scan_bits.h"
#include "kernels/sight/sight.h"

namespace lasius::disc {

using kernels::Fixed;
using kernels::kOne;
using kernels::kWordsAtOnce;

/// The rays through one gap.
struct Gap {
  Fixed left = 0, right = 0;  ///< columns on a line
  Fixed left_slope = 0, right_slope = 0;
  std::int32_t line = 0;
  bool wall = false;   ///< right is the side of a blocked cell in the row behind
  bool grows = false;  ///< one side is the circle
};

/// Rays that end in the row in hand: columns on the next line, and the slopes of the rays there
/// where these are known.
struct Shadow {
  Fixed left, right;
  Fixed left_slope = kUnknownSlope, right_slope = kUnknownSlope;

  static constexpr Fixed kUnknownSlope = -1;
};

/// A circle or point, and the first and last of the rays that leave it.
struct Sweep {
  double u, v;      ///< centre; v from line 0 on
  double offset;    ///< see heading_of
  Normal from, to;  ///< of the first and last ray
};

/// Where a scan runs: rows of blocked cells, and of those that arcs pass.
struct ScanFrame {
  kernels::BitmapView blocked, passed;
  kernels::BitmapView crowded;  ///< a bit for 8 x 8 cells: any of them in either
  int down;                     ///< +1: line j is grid line line0 + j; -1: line0 - j
  int line0;
};

constexpr Fixed kOutward = kOne >> 23;  ///< what is looked at beyond the sides of a gap
constexpr Fixed kThin = kOne >> 26;     ///< a gap that is not wider holds no ray of its own

/// A Visitor has
///   void meet(int u, const Gap&, const Gap& next)  for each cell of row gap.line that arcs pass;
///       `next`: its sides on the next line. Adds to `shadows`.
///   kernels::ConeLimits limits()  asked when the scan leaves the neighbourhood
///   bool go_on(std::int64_t words)  told of the work done, false to stop.
template <int S, class Visitor>
class TangentScan {
 public:
  TangentScan(const ScanFrame& frame, const Sweep& sweep, std::vector<Gap>& stack,
              std::vector<Shadow>& shadows, Visitor& visitor) noexcept
      : sweep_(sweep),
        row0_(row_bytes(frame, frame.blocked)),
        passed0_(row_bytes(frame, frame.passed)),
        step_(frame.down * frame.blocked.stride * std::ptrdiff_t{sizeof(std::uint64_t)}),
        start_u_(sweep.u + sweep.offset * sweep.from.a),
        leaves_v_(sweep.v - sweep.offset * sweep.to.b),
        last_slope_(slope_of(sweep.to)),
        border_(S > 0 ? frame.blocked.width : 0),
        last_line_(std::min(kNearLines,
                            frame.down > 0 ? frame.blocked.height - frame.line0 : frame.line0)),
        limit_(kernels::fixed(kernels::floor_column(to_fixed(start_u_)) + kNearColumns)),
        crowded_(frame.crowded),
        down_(frame.down),
        line0_(frame.line0),
        stack_(stack),
        shadows_(shadows),
        visitor_(visitor) {}

  /// Returns whether rays were cut off at the limits.
  bool run() {
    stack_.clear();
    stack_.push_back(first_gap());
    bool going = true;
    while (going && !stack_.empty()) {
      Gap gap = stack_.back();
      stack_.pop_back();
      if (gap.line == 0 || clip(gap, gap.line)) going = follow(gap);
    }
    visitor_.go_on(words_);
    return cut_off_;
  }

 private:
  using B = kernels::Bits<S>;

  static const char* row_bytes(const ScanFrame& frame, const kernels::BitmapView& map) noexcept {
    return kernels::bytes_of(map.row(frame.down > 0 ? frame.line0 : frame.line0 - 1));
  }
  static Fixed to_fixed(double u) noexcept {
    return static_cast<Fixed>(u * static_cast<double>(kOne));
  }
  static int floor_of(Fixed u) noexcept { return kernels::floor_column(u); }
  static double slope_of(Normal n) noexcept {
    return n.b < 0x1p16 * n.a ? n.b / n.a : 0x1p16;  // kernels::kLevelSlope
  }

  Gap first_gap() const noexcept {
    Gap gap;
    const double slope = slope_of(sweep_.from);
    const double start_v = sweep_.v - sweep_.offset * sweep_.from.b;
    const Fixed first = to_fixed(start_u_ - slope * start_v);
    const Fixed first_slope = to_fixed(slope);
    gap.grows = sweep_.offset != 0;
    if (sweep_.offset > 0) {
      gap.left = to_fixed(start_u_);
      gap.right = first;
      gap.right_slope = first_slope;
    } else if (sweep_.offset < 0) {
      gap.left = first;
      gap.left_slope = first_slope;
      gap.right = to_fixed(start_u_);
    } else {
      gap.left = first;
      gap.left_slope = first_slope;
      gap.right = to_fixed(start_u_ - last_slope_ * sweep_.v);
      gap.right_slope = to_fixed(last_slope_);
    }
    return gap;
  }

  // Where the circle, or the last ray once it has left, is on a line.
  double edge(int line) const noexcept {
    const double depth = line - sweep_.v;
    if (line < leaves_v_) {
      const double square = std::max(0.0, sweep_.offset * sweep_.offset - depth * depth);
      return sweep_.u + std::copysign(std::sqrt(square), sweep_.offset);
    }
    return sweep_.u + sweep_.offset * sweep_.to.a + last_slope_ * (line - leaves_v_);
  }

  // Of the ray through a point.
  Fixed slope_to(double u, int line) const noexcept {
    const double du = u - sweep_.u, dv = line - sweep_.v;
    const double along =
        std::sqrt(std::max(0.0, du * du + dv * dv - sweep_.offset * sweep_.offset));
    const Normal n{sweep_.offset * du + along * dv, along * du - sweep_.offset * dv};
    return n.b > 0 ? to_fixed(slope_of(n)) : 0;
  }

  [[gnu::noinline]] void look_far() {
    const kernels::ConeLimits limits = visitor_.limits();
    near_ = false;
    last_line_ = limits.last_line;
    limit_ = kernels::fixed(limits.last_column);
    left0_ = limits.left0;
    right0_ = limits.right0;
    slope_ = limits.slope;
  }

  // As in ConeScan: what lies past the limits is cut off; false if too little is left.
  bool clip(Gap& gap, int line) {
    if (near_) {
      if (gap.right <= limit_) return gap.right - gap.left > kThin || gap.grows;
      look_far();
    }
    const Fixed moved = line * slope_;
    const Fixed left = left0_ + moved;
    const Fixed right = std::min(right0_ + moved, limit_);
    if (gap.left >= left && gap.right <= right) return gap.right - gap.left > kThin || gap.grows;
    cut_off_ = true;
    gap.left = std::max(gap.left, left);
    if (gap.right > right) {
      gap.right = right;
      if (gap.wall) gap.right_slope = slope_to(floor_of(right), line);
      gap.wall = false;
    }
    return gap.right - gap.left > kOne;
  }

  // Follows one gap until it ends or falls into several, which go on the stack. False when stopped.
  bool follow(Gap& gap) {
    int quiet = 0;  // rows in succession that held nothing
    for (;;) {
      const char* next = row0_ + step_ * gap.line;
      if (gap.wall && !kernels::blocked_cell<S>(next, floor_of(gap.right + kOutward))) {
        gap.right_slope = slope_to(floor_of(gap.right + kOutward), gap.line);
        gap.wall = false;
      }
      if (quiet >= kQuietRows && !gap.wall && stride(gap)) {
        if (!clip(gap, gap.line)) return true;
        if (words_ >= kWordsAtOnce && !tell()) return false;
        continue;
      }
      const int line = gap.line;
      Fixed left = gap.left + gap.left_slope;
      Fixed right = gap.wall ? gap.right : gap.right + gap.right_slope;
      if (gap.grows) (sweep_.offset > 0 ? left : right) = to_fixed(edge(line + 1));
      if (near_ && (line > last_line_ || right > limit_)) look_far();
      if (line > last_line_) {
        cut_off_ = true;
        return true;
      }
      ++words_;
      const Fixed from = line == 0 ? std::max(gap.left, to_fixed(start_u_)) : gap.left;
      const Fixed reached = std::min(right, limit_);
      const int first = floor_of(from - kOutward);
      const int to = std::min(border_, floor_of(reached + kOutward));
      const char* passed = passed0_ + step_ * line;
      ++quiet;
      if (to - first >= B::kValid || ((B::window(next, first) | B::window(passed, first)) &
                                      B::to(std::max(0, to - first))) != 0) {
        quiet = 0;
        Gap ahead = gap;
        ahead.left = left;
        ahead.right = right;
        ++ahead.line;
        const bool open = look(next, passed, first, to, gap, ahead);
        if (!open || !shadows_.empty()) {
          split(next, floor_of(from + kOutward), floor_of(reached - kOutward), ahead);
          shadows_.clear();
          return words_ < kWordsAtOnce || tell();
        }
      }
      gap.left = left;
      gap.right = right;
      ++gap.line;
      if (gap.grows && gap.line >= leaves_v_) finish(gap);
      if (!clip(gap, gap.line)) return true;
      if (words_ >= kWordsAtOnce && !tell()) return false;
    }
  }

  // Goes on to the end of a row of tiles, if all that a gap reaches there is free.
  bool stride(Gap& gap) noexcept {
    const int y = down_ > 0 ? line0_ + gap.line : line0_ - gap.line - 1;
    const int lines = down_ > 0 ? 8 - (y & 7) : (y & 7) + 1;
    if (gap.grows || lines < kLeastStride || gap.line + lines > last_line_ ||
        gap.right_slope > (limit_ - gap.right) / lines)
      return false;
    const Fixed right = gap.right + lines * gap.right_slope;
    const int first = floor_of(gap.left - kOutward), to = floor_of(right + kOutward);
    if (to >= border_) return false;
    const int low = S > 0 ? first : -to - 1, high = S > 0 ? to : -first - 1;
    if (!kernels::row_free(crowded_.row(y >> 3), low >> 3, high >> 3)) return false;
    gap.left += lines * gap.left_slope;
    gap.right = right;
    gap.line += lines;
    ++words_;
    return true;
  }

  // The last ray has left: its slope is the side's.
  void finish(Gap& gap) const noexcept {
    gap.grows = false;
    (sweep_.offset > 0 ? gap.left_slope : gap.right_slope) = to_fixed(last_slope_);
  }

  bool tell() {
    const bool go_on = visitor_.go_on(words_);
    words_ = 0;
    return go_on;
  }

  // Meets the cells that arcs pass; true if no cell is blocked from one column to another.
  bool look(const char* next, const char* passed, int from, int to, const Gap& gap,
            const Gap& ahead) {
    bool open = true;
    // Rays that enter the row before a blocked cell do not get past it.
    const int enter = std::max(from, floor_of(gap.right + kOutward));
    if (to > enter) to = kernels::next_cell<S, true>(next, enter, to);
    for (int c = from; c <= to; c += B::kValid) {
      const std::uint64_t valid = B::to(std::min(to - c, B::kValid - 1));
      const std::uint64_t blocked = B::window(next, c) & valid;
      open &= blocked == 0;
      for (std::uint64_t cells = B::window(passed, c) & valid & ~blocked; cells != 0;) {
        const int i = B::first(cells);
        cells &= ~B::only(i);
        visitor_.meet(c + i, gap, ahead);
      }
    }
    return open;
  }

  // Cuts a gap, whose sides are those on the next line, at the blocked cells from column c on.
  void split(const char* next, int c, int last, Gap gap) {
    const int line = gap.line - 1;
    const bool right_grows = gap.grows && sweep_.offset < 0;
    bool left_grows = gap.grows && sweep_.offset > 0;
    for (;;) {
      if (c <= last && kernels::blocked_cell<S>(next, c)) {
        c = kernels::next_cell<S, false>(next, c + 1, last);
        if (c > last) return;
        gap.left_slope = slope_to(c, line);
        gap.left = kernels::fixed(c) + gap.left_slope;
        left_grows = false;
      }
      const int a = kernels::next_cell<S, true>(next, c, last);
      Gap part = gap;
      part.grows = left_grows;
      if (a > last) {
        part.grows |= right_grows;
        return shade(part, 0);
      }
      part.right = kernels::fixed(a);
      part.wall = true;
      shade(part, 0);
      c = a;
    }
  }

  // Takes the shadows from the first one on off a gap; what is left goes on the stack.
  void shade(Gap gap, std::size_t first) {
    const bool grows_left = gap.grows && sweep_.offset > 0;
    for (; first < shadows_.size(); ++first) {
      const Shadow& shadow = shadows_[first];
      if (shadow.right <= gap.left || shadow.left >= gap.right) continue;
      if (shadow.right < gap.right) {
        Gap rest = gap;
        rest.left = shadow.right;
        rest.left_slope = slope_at(shadow.right, shadow.right_slope, gap.line);
        rest.grows = gap.grows && !grows_left;
        if (shadow.left <= gap.left) {
          gap = rest;
          continue;
        }
        shade(rest, first + 1);
      } else if (shadow.left <= gap.left) {
        return;
      }
      gap.right = shadow.left;
      gap.right_slope = slope_at(shadow.left, shadow.left_slope, gap.line);
      gap.wall = false;
      gap.grows = grows_left;
    }
    if (gap.right - gap.left <= kThin && !gap.grows) return;
    if (gap.grows && gap.line >= leaves_v_) finish(gap);
    stack_.push_back(gap);
  }
  Fixed slope_at(Fixed u, Fixed known, int line) const noexcept {
    if (known != Shadow::kUnknownSlope) return known;
    return slope_to(static_cast<double>(u) / static_cast<double>(kOne), line);
  }

  static constexpr int kNearLines = 12, kNearColumns = 40, kQuietRows = 2, kLeastStride = 4;

  const Sweep& sweep_;
  const char* row0_;
  const char* passed0_;
  std::ptrdiff_t step_;
  double start_u_, leaves_v_, last_slope_;
  int border_;        // the column past the map
  bool near_ = true;  // limits were not asked for yet
  int last_line_;
  Fixed limit_;
  Fixed left0_ = 0, right0_ = 0, slope_ = 0;
  const kernels::BitmapView crowded_;
  int down_, line0_;
  std::vector<Gap>& stack_;
  std::vector<Shadow>& shadows_;  // of the row in hand
  Visitor& visitor_;
  std::int64_t words_ = 0;
  bool cut_off_ = false;
};

}  // namespace lasius::disc
