// What the genetic algorithm on grids works with, kept from plan to plan.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/genetic/grid_ga_route.h"
#include "core/smooth/path_maker.h"
#include "lasius/geometry.h"

namespace lasius {

/// A chromosome with its path after polish. Cache lines of its own: threads make neighbours.
struct alignas(64) Individual {
  std::vector<Cell> cells;  // the path, start and goal included; empty when stopped
  double tour = 0;          // its length; NaN when stopped
  double length = std::numeric_limits<double>::infinity();  // after polish: less is fitter
  std::vector<Point> points;
};

struct GridGaMemory {
  struct alignas(64) Scratch {  // of one thread
    RouteMaker routes;
    PathMaker maker;
    std::vector<Cell> draft;
    std::vector<std::pair<std::uint32_t, int>> places;  // cell and its index in a path
    std::vector<std::pair<int, int>> common;            // indices of a cell in both paths
  };

  std::vector<Scratch> scratch;
  std::vector<Individual> population, children;
  std::vector<int> parents, order;  // of tournaments
};

}  // namespace lasius
