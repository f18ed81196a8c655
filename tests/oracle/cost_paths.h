// Costs of paths over weighted cells, by means that the library does not use.
#pragma once

#include <functional>
#include <span>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::oracle {

/// The weight of a free cell.
using WeightOf = std::function<double(Cell)>;

/// A cost that some path has between two points inside free cells: the least over paths whose bends
/// are at `points` places of each edge or its ends. Infinite where there is none. For tiny
/// maps: the graph is dense.
double cost_over_points(const Grid& grid, const WeightOf& weight, Point start, Point goal,
                        int points);

/// The cost of a polyline by sampling `samples` points of each segment, as many from either side of
/// every grid line; infinite where most of a blocked cell's width is entered.
double sampled_cost(const Grid& grid, const WeightOf& weight, std::span<const Point> path,
                    int samples);

}  // namespace lasius::oracle
