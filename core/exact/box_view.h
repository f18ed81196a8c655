// The corners from which some point of a box may be seen.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/special_values.h"
#include "core/exact/quadrant.h"
#include "kernels/sight/scan_bits.h"

namespace lasius::exact {

/// Two rows of cells, around the grid line between them.
template <int S>
struct CornerWindow {
  using B = kernels::Bits<S>;

  CornerWindow(const char* above, const char* below, int base) noexcept
      : a(B::window(above, base)),
        b(B::window(below, base)),
        a1(B::previous(a)),
        b1(B::previous(b)) {}

  /// Lattice points where exactly one cell is blocked, from index 1 to `last`.
  template <class Sink>
  void report(int last, int base, int y, Sink& sink) const {
    std::uint64_t found = ((a ^ b) & ~(a1 | b1)) | ((a1 ^ b1) & ~(a | b));
    found &= B::from(1) & B::to(last);
    for (; found != 0; found &= ~B::only(B::first(found))) {
      sink.corner(S * (base + B::first(found)), y);
    }
  }
  /// Where a path along the line ends, as in scan_line.
  std::uint64_t ends() const noexcept { return ((a & b) | (a1 & b) | (a & b1)) & B::from(1); }

  std::uint64_t a, b, a1, b1;
};

/// Along grid line y, from column u = S * x on: the one way that a corner sees through no width,
/// between blocked cells above and others below.
template <int S, class Sink>
void view_along_line(const kernels::BitmapView& map, int y, int u, Sink& sink) {
  using B = kernels::Bits<S>;
  const char* above = kernels::bytes_of(map.row(y - 1));
  const char* below = kernels::bytes_of(map.row(y));
  for (int base = u - 1;; base += B::kValid - 1) {
    const CornerWindow<S> window(above, below, base);
    const std::uint64_t ends = window.ends() & B::to(B::kValid - 1);
    window.report(ends != 0 ? B::first(ends) : B::kValid - 1, base, y, sink);
    if (ends != 0 || !sink.go_on(1)) return;
  }
}

/// Rays from a box through one gap: columns that they reach of a line, and slopes, columns a line.
struct Beam {
  double left, right;
  double least, most;
};

/// All rays that leave a box towards larger u = S * x and `down`, row by row, cut by blocked cells.
/// Cells of the box count as free. What a beam keeps of its rays is a range of columns and one of
/// slopes, which hold all of them and some others: so more corners may be found than see the box,
/// and never fewer. A ray that touches blocked cells on both its sides is lost, as it is in a
/// ConeScan; boxes are a cell larger than what matters, so that such a ray has others beside it.
///
/// A Sink has  void corner(int x, int y)  for each corner found, maybe more than once, and
///   bool go_on(std::int64_t words)  told of the work done, false to stop.
template <int S, class Sink>
class BoxView {
 public:
  BoxView(const kernels::BitmapView& map, const LatticeBox& box, int down, Sink& sink) noexcept
      : map_(map),
        down_(down),
        line0_(down > 0 ? box.y0 : box.y1),
        lines_(down > 0 ? map.height - line0_ : line0_),
        depth_(box.y1 - box.y0),
        near_(S > 0 ? box.x0 : -box.x1),
        far_(S > 0 ? box.x1 : -box.x0),
        border_(S > 0 ? map.width : 0),
        sink_(sink) {}

  void run() {
    for (int line = 0; line < lines_ && (line < depth_ || !beams_.empty()); ++line) {
      const char* row = kernels::bytes_of(row_behind(line + 1));
      next_.clear();
      const int covered = line < depth_ ? add_box_rays(row, line) : near_;
      for (const Beam& beam : beams_) cut(beam, row, line, covered);
      beams_.swap(next_);
      if (!report(line + 1)) return;
    }
  }

 private:
  // More than what rounding takes off a column.
  static constexpr double kRounding = 1e-9;

  const std::uint64_t* row_behind(int line) const noexcept {
    return map_.row(down_ > 0 ? line0_ + line - 1 : line0_ - line);
  }

  // Rays that leave the box in a row beside it, or through its last line. Returns where the free
  // cells end that they cover.
  int add_box_rays(const char* row, int line) {
    const int end = kernels::next_cell<S, true>(row, far_, border_);
    const int begin = line + 1 == depth_ ? near_ : far_;
    if (begin < end) {
      next_.push_back({static_cast<double>(begin), static_cast<double>(end), 0, kInfinity});
    }
    return end;
  }

  // Goes on by a row, from `line`.
  void cut(const Beam& beam, const char* row, int line, int covered) {
    const int last = static_cast<int>(std::min<double>(beam.right + beam.most, border_));
    for (int c = std::max(static_cast<int>(std::floor(beam.left)), covered);;) {
      c = kernels::next_cell<S, false>(row, c, last);
      if (c > last || c >= beam.right) return;
      const int end = kernels::next_cell<S, true>(row, c, last);
      const double left = std::max<double>(beam.left, c);
      const double right = std::min<double>(beam.right, end);
      const double wall = end <= last ? end : kInfinity;
      add({std::max(left, left + beam.least - kRounding),
           std::min(wall, right + beam.most + kRounding), beam.least, beam.most},
          line + 1);
      c = end;
    }
  }

  void add(Beam beam, int line) {
    if (!(beam.left < beam.right)) return;
    beam.least = std::max(beam.least, (beam.left - far_) / line - kRounding);
    if (line > depth_) {
      beam.most = std::min(beam.most, (beam.right - near_) / (line - depth_) + kRounding);
    }
    if (!next_.empty() && next_.back().right >= beam.left && next_.back().left <= beam.left) {
      Beam& before = next_.back();
      before.right = std::max(before.right, beam.right);
      before.least = std::min(before.least, beam.least);
      before.most = std::max(before.most, beam.most);
    } else {
      next_.push_back(beam);
    }
  }

  bool report(int line) {
    const char* behind = kernels::bytes_of(row_behind(line));
    const char* ahead = kernels::bytes_of(row_behind(line + 1));
    std::int64_t words = 1;
    for (const Beam& beam : beams_) {
      const int last = static_cast<int>(std::floor(std::min<double>(beam.right, border_)));
      for (int base = static_cast<int>(std::ceil(beam.left)) - 1; base < last;
           base += B::kValid - 1, ++words) {
        const CornerWindow<S> window(behind, ahead, base);
        window.report(std::min(last - base, B::kValid - 1), base, line0_ + down_ * line, sink_);
      }
    }
    return sink_.go_on(words);
  }

  using B = kernels::Bits<S>;

  const kernels::BitmapView map_;
  const int down_, line0_, lines_;
  const int depth_;       // of the box, in lines
  const int near_, far_;  // its columns
  const int border_;      // the column that ends every row
  Sink& sink_;
  std::vector<Beam> beams_, next_;
};

/// All round. Corners of the box itself are not told of.
template <class Sink>
void view_from_box(const kernels::BitmapView& map, const LatticeBox& box, Sink& sink) {
  for (const int down : {1, -1}) {
    BoxView<1, Sink>(map, box, down, sink).run();
    BoxView<-1, Sink>(map, box, down, sink).run();
  }
  for (int y = box.y0; y <= box.y1; ++y) {
    view_along_line<1>(map, y, box.x1, sink);
    view_along_line<-1>(map, y, -box.x0, sink);
  }
}

}  // namespace lasius::exact
