// A bitmap with a weight for each free cell, and what polylines cost there: what peers plan over
// and all paths are judged by. It shares nothing with the library's evaluator.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "lasius/cost/field.h"
#include "lasius/grid/grid.h"

namespace lasius::peers {

/// Weights with a border of one cell, infinite where nothing goes.
class WeightedMap {
 public:
  WeightedMap(const Grid& grid, const CostField& costs);

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }
  double least() const noexcept { return least_; }  ///< of the free cells
  /// Of a cell of the map or of its border.
  double weight(int x, int y) const noexcept { return weights_[index({x, y})]; }
  bool free(int x, int y) const noexcept {
    return weight(x, y) < std::numeric_limits<double>::infinity();
  }
  /// Is a step between two cells that touch allowed? One of the cells beside a diagonal is free.
  bool joined(Cell a, Cell b) const noexcept {
    return free(a.x, a.y) && free(b.x, b.y) &&
           (a.x == b.x || a.y == b.y || free(a.x, b.y) || free(b.x, a.y));
  }

  std::size_t size() const noexcept { return weights_.size(); }  ///< with the border
  std::size_t index(Cell c) const noexcept {
    return static_cast<std::size_t>(c.y + 1) * stride() + static_cast<std::size_t>(c.x + 1);
  }
  Cell cell(std::size_t index) const noexcept {
    return {static_cast<int>(index % stride()) - 1, static_cast<int>(index / stride()) - 1};
  }
  std::size_t stride() const noexcept { return static_cast<std::size_t>(width_) + 2; }

 private:
  int width_, height_;
  double least_ = std::numeric_limits<double>::infinity();
  std::vector<double> weights_;
};

/// What polylines cost; keeps its memory from one to the next.
class PathIntegral {
 public:
  explicit PathIntegral(const WeightedMap& map) : map_(&map) {}
  /// The exact integral of the weight. On a grid line the cheaper free side counts. Infinite where
  /// the polyline enters a blocked cell, leaves the map, or squeezes between two blocked cells that
  /// touch at a corner.
  double of(std::span<const Point> path);

 private:
  void cut(Point a, Point b);

  const WeightedMap* map_;
  std::vector<double> cuts_x_, cuts_y_, cuts_;
};

}  // namespace lasius::peers
