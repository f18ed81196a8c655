// What lies near a point or along a segment, in grid units: bins over the grid of a world.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/polygon/world/lattice_point.h"

namespace lasius::polygon {

/// Numbers of segments, each in the bins that it passes.
class SpatialIndex {
 public:
  /// Over the box from `low` to `high`, of about `count` square bins.
  SpatialIndex(LatticePoint low, LatticePoint high, std::size_t count) : low_(low) {
    const auto wide = static_cast<double>(high.x - low.x) + 1;
    const auto tall = static_cast<double>(high.y - low.y) + 1;
    side_ = std::max(std::sqrt(wide * tall / static_cast<double>(count + 1)),
                     std::max(wide, tall) / kMostAcross);
    columns_ = static_cast<int>(wide / side_) + 1;
    rows_ = static_cast<int>(tall / side_) + 1;
    bins_.resize(static_cast<std::size_t>(columns_) * rows_);
  }

  void add(int number, LatticePoint a, LatticePoint b) {
    along(a, b, [&](std::size_t bin) {
      bins_[bin].push_back(number);
      return true;
    });
  }
  /// Calls visit(number) for what lies in the bins that a segment passes, maybe several times for
  /// one number, until it returns false. True where it never did.
  template <class Visit>
  bool near(LatticePoint a, LatticePoint b, const Visit& visit) const {
    return along(a, b, [&](std::size_t bin) { return std::ranges::all_of(bins_[bin], visit); });
  }
  /// Calls visit(number) for what lies in the bins of the square of half side `reach` around p.
  template <class Visit>
  void within(LatticePoint p, double reach, const Visit& visit) const {
    const auto x = static_cast<double>(p.x - low_.x), y = static_cast<double>(p.y - low_.y);
    const int first = column(x - reach), last = column(x + reach);
    const int top = row(y + reach);
    for (int r = row(y - reach); r <= top; ++r) {
      for (int c = first; c <= last; ++c) {
        for (const int number : bins_[index(c, r)]) visit(number);
      }
    }
  }

 private:
  static constexpr double kMostAcross = 4096;

  int column(double x) const {
    return static_cast<int>(std::clamp(x / side_, 0.0, columns_ - 1.0));
  }
  std::size_t index(int c, int r) const { return static_cast<std::size_t>(r) * columns_ + c; }
  int row(double y) const { return static_cast<int>(std::clamp(y / side_, 0.0, rows_ - 1.0)); }

  /// Column by column, by a unit more than the segment: what is rounded here decides nothing.
  template <class Visit>
  bool along(LatticePoint a, LatticePoint b, const Visit& visit) const {
    if (b.x < a.x) std::swap(a, b);
    const auto ax = static_cast<double>(a.x - low_.x), ay = static_cast<double>(a.y - low_.y);
    const auto bx = static_cast<double>(b.x - low_.x), by = static_cast<double>(b.y - low_.y);
    const double slope = bx > ax ? (by - ay) / (bx - ax) : 0;
    const int last = column(bx + 1);
    for (int c = column(ax - 1); c <= last; ++c) {
      double from = ay, to = by;
      if (bx > ax) {
        from = ay + slope * (std::clamp(c * side_ - 1, ax, bx) - ax);
        to = ay + slope * (std::clamp((c + 1) * side_ + 1, ax, bx) - ax);
      }
      const int top = row(std::max(from, to) + 1);
      for (int r = row(std::min(from, to) - 1); r <= top; ++r)
        if (!visit(index(c, r))) return false;
    }
    return true;
  }

  LatticePoint low_;
  double side_ = 1;  // of a bin
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<int>> bins_;  // row by row
};

}  // namespace lasius::polygon
