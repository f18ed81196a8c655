// What a way through each cell of a bitmap costs: a weight, from layers and inflation.
//
// The cost of a path is the integral of the weight along it. On a grid line the cheaper of the two
// cells beside it counts, if both are free; a path may not squeeze between two diagonally adjacent
// blocked cells.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// Costs around what is blocked, as the inflation layer of Nav2 has them (InflationLayer::
/// computeCost): of a cell whose centre is d cells from the nearest blocked cell's centre,
/// weight * exp(-scaling (d - r)), at most `weight`, where r is `inscribed` and d is at most
/// `radius`; 0 farther away. What lies outside the map does not count as blocked.
struct Inflation {
  double radius = 0;     ///< cells, 0 to 20000
  double scaling = 0;    ///< per cell, 0 to 1000
  double weight = 2;     ///< 0 to CostField::kMost
  double inscribed = 1;  ///< the robot's radius in cells, counted as 1 where it is less
};

/// A weight for each cell: what one cell's length in it costs. 1 everywhere, until layers are
/// added.
class LASIUS_EXPORT CostField {
 public:
  static constexpr double kLeast = 1e-6;  ///< the least weight that a cell may have
  static constexpr double kMost = 1e6;    ///< and the greatest

  /// Weight 1 for width x height cells. @throws Error(invalid_parameter) unless 1 <= width, height
  /// <= Grid::kMaxSide.
  CostField(int width, int height);
  /// The weights themselves, row by row from the top left; 8 bytes a cell are kept.
  /// @throws as above, and unless there are width x height values in [kLeast, kMost].
  CostField(int width, int height, std::span<const double> weights);

  /// Adds factor * value to each weight.
  /// @throws Error(invalid_parameter), the field unchanged, unless there are width x height values,
  /// finite and at least 0, and the factor is so, too, or where a weight passes kMost.
  void add(std::span<const double> values, double factor = 1);
  /// Adds what the inflation of the grid's blocked cells costs. @throws as above, for a grid of
  /// another size, or parameters out of their ranges.
  void add(const Grid& grid, const Inflation& inflation);

  int width() const noexcept { return width_; }    ///< in cells
  int height() const noexcept { return height_; }  ///< in cells
  /// Of a cell of the map.
  double weight(Cell c) const noexcept {
    return weights_[static_cast<std::size_t>(c.y) * width_ + c.x];
  }
  /// All weights, row by row.
  std::span<const double> weights() const noexcept { return weights_; }

  /// The least and the greatest weight of the free cells; 1 and 1 where none is free.
  struct Range {
    double least = 1;  ///< of a free cell
    double most = 1;   ///< likewise
  };
  /// @throws Error(invalid_parameter) for a grid of another size.
  Range range(const Grid& grid) const;
  /// 64-bit fingerprint of size and weights, the same on every machine.
  std::uint64_t hash() const noexcept;

 private:
  void check_size(const Grid& grid) const;

  int width_;
  int height_;
  std::vector<double> weights_;
};

/// A terrain's slope, a layer for CostField::add: of each cell the length of its height's gradient,
/// by the heights on both sides of it, at the map's edge on one side; 1 is a rise of 45 degrees.
/// @param heights  of the cells, in cells, row by row from the top left
/// @throws Error(invalid_parameter) unless there are width x height finite ones
LASIUS_EXPORT std::vector<double> slope(int width, int height, std::span<const double> heights);

/// Which cells a ROS costmap blocks, and what the others cost.
struct Costmap {
  Grid grid;        ///< the cells that may be planned on
  CostField costs;  ///< their weights
};
/// Makes them of a costmap's width x height values, row by row from the top (those of a message
/// begin at the bottom): of 0 to 252 a cell costs 1 + weight * value / 252, 253 and 254 block it,
/// 255 is unknown, which blocks, or costs 1.
/// @throws Error(invalid_parameter) for another number of values, sides as of CostField, or a
/// weight out of [0, CostField::kMost].
LASIUS_EXPORT Costmap read_costmap(int width, int height, std::span<const std::uint8_t> values,
                                   double weight = 2, bool unknown_is_free = false);

/// The cost of a polyline: exact, up to rounding. Nothing where it leaves the map, enters a blocked
/// cell, runs between two of them or squeezes between two that touch at a corner; what is shorter
/// than 1e-9 cells of it does not count as entering. 0 for fewer than two points.
/// @throws Error(invalid_parameter) for a grid of another size.
LASIUS_EXPORT std::optional<double> path_cost(const Grid& grid, const CostField& costs,
                                              std::span<const Point> path);

}  // namespace lasius
