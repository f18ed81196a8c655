// What motions cost: by a vehicle's prices, and by the weights of the cells that its reference
// point goes through.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/cost/path_cost.h"
#include "core/vehicle/lattice.h"
#include "lasius/cost/field.h"
#include "lasius/vehicle/motion.h"

namespace lasius::vehicle {

/// Goes along the reference point's path, over the first `at` of the extent of what is driven. An
/// arc is gone along by chords no farther than 0.001 cells from it; what a chord costs is to be
/// multiplied by what is returned, as the arc is longer by that.
template <class Weight, class OnPiece>
double walk_cells(const Segment& s, double at, cost::PathCost<Weight, OnPiece>& sum) {
  constexpr double kBeside = 1e-3;
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(at * std::sqrt(s.sharpest() / (8 * kBeside)))));
  Pose from = s.begin;
  double chords = 0;
  for (int i = 1; i <= pieces; ++i) {
    const Pose to = s.pose(at * i / pieces);
    sum.add({from.x, from.y}, {to.x, to.y});
    chords += distance({from.x, from.y}, {to.x, to.y});
    from = to;
  }
  return s.sharpest() == 0 || chords == 0 ? 1 : at / chords;
}

/// Prices of one vehicle on one map. Costs here are divided by unit(), the least weight: then each
/// cell counts at least as much as without weights. A turn in place and a change of gear count as
/// lengths in the cell where they happen. Blocked cells and the outside, where a reference point
/// outside of its footprint may come, have the weight that they are given, or that of the nearest
/// cell.
class Prices {
 public:
  /// @param costs  null: none. Of equal weights costs are those without, times unit()
  Prices(const Grid& grid, const Vehicle& vehicle, const CostField* costs);

  bool weighted() const noexcept { return !weights_.empty(); }
  double unit() const noexcept { return unit_; }
  int width() const noexcept { return width_; }
  /// Of all cells, row by row; none where weighted() is false.
  std::span<const double> weights() const noexcept { return weights_; }
  /// At least 1.
  double weight(int x, int y) const noexcept {
    if (weights_.empty()) return 1;
    x = std::clamp(x, 0, width_ - 1);
    y = std::clamp(y, 0, height_ - 1);
    return weights_[static_cast<std::size_t>(y) * width_ + x];
  }
  /// Of the cell of a pose.
  double weight(const Pose& at) const noexcept { return weight(floor_of(at.x), floor_of(at.y)); }

  /// Of the first `at` of the extent of a motion.
  double part(const Segment& s, double at) const;
  /// With the changes of gear.
  double of(std::span<const Segment> segments) const;

 private:
  Vehicle vehicle_;
  int width_, height_;
  double unit_ = 1;
  std::vector<double> weights_;
};

/// What the motions of a lattice cost from each cell: what each drives in each cell is known.
class EdgePrices {
 public:
  EdgePrices(const Prices& prices, const Vehicle& vehicle, const Lattice& lattice);

  double at(int edge, int x, int y) const noexcept {
    double sum = 0;
    for (int i = first_[edge]; i < first_[edge + 1]; ++i)
      sum += parts_[i].price * prices_.weight(x + parts_[i].dx, y + parts_[i].dy);
    return sum;
  }

 private:
  struct Part {
    int dx, dy;
    double price;
  };
  const Prices& prices_;
  std::vector<int> first_;  ///< by edge, and the end
  std::vector<Part> parts_;
};

}  // namespace lasius::vehicle
