// The weights of a map's free cells, as searches look at them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/special_values.h"
#include "core/grid/distance.h"
#include "lasius/cost/field.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::cost {

/// The middle of a cell, seen from its upper left corner.
inline constexpr Point kMiddle{0.5, 0.5};

/// Weights with a border of one cell; infinite where nothing goes. 8 bytes a cell.
class Terrain {
 public:
  /// @throws Error(invalid_parameter) where the sizes differ.
  Terrain(const Grid& grid, const CostField& costs)
      : Terrain(grid, (costs.range(grid), costs.weights())) {}
  /// The same of width x height weights above 0, row by row.
  Terrain(const Grid& grid, std::span<const double> weights)
      : width_(grid.width()),
        height_(grid.height()),
        weights_(static_cast<std::size_t>(stride()) * (height_ + 2), kInfinity) {
    double least = kInfinity, most = 0;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        if (grid.blocked({x, y})) continue;
        const double weight = weights[static_cast<std::size_t>(y) * width_ + x];
        weights_[index(x, y)] = weight;
        least = std::min(least, weight);
        most = std::max(most, weight);
      }
    }
    if (most > 0) range_ = {least, most};
  }

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }
  int stride() const noexcept { return width_ + 2; }
  /// The least and greatest weight that a free cell has, or has had.
  double least() const noexcept { return range_.least; }
  double most() const noexcept { return range_.most; }
  std::int64_t bytes() const noexcept { return held_bytes(weights_); }

  /// Of a cell of the map or of its border of one.
  std::size_t index(int x, int y) const noexcept {
    return static_cast<std::size_t>(y + 1) * stride() + (x + 1);
  }
  Cell cell(std::size_t index) const noexcept {
    return {static_cast<int>(index % stride()) - 1, static_cast<int>(index / stride()) - 1};
  }
  const double& at(std::size_t index) const noexcept { return weights_[index]; }
  double weight(int x, int y) const noexcept { return weights_[index(x, y)]; }
  bool free(int x, int y) const noexcept { return weight(x, y) < kInfinity; }
  /// Gives a cell of the map another weight; infinite: blocked.
  void set(Cell c, double weight) noexcept {
    weights_[index(c.x, c.y)] = weight;
    if (!(weight < kInfinity)) return;
    range_ = {std::min(range_.least, weight), std::max(range_.most, weight)};
  }
  /// What a straight move between the centres of neighbours costs.
  double move_cost(Cell from, Cell to) const noexcept {
    return distance(centre(from), centre(to)) / 2 * (weight(from.x, from.y) + weight(to.x, to.y));
  }
  /// Do two blocked cells meet diagonally at a lattice point, the other two being free?
  bool squeeze(int x, int y) const noexcept {
    const bool nw = free(x - 1, y - 1), ne = free(x, y - 1);
    return nw == free(x, y) && ne == free(x - 1, y) && nw != ne;
  }

 private:
  int width_;
  int height_;
  CostField::Range range_;
  std::vector<double> weights_;
};

}  // namespace lasius::cost
