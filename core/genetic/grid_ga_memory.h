// What the genetic algorithm on grids works with, kept from plan to plan.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/special_values.h"
#include "core/genetic/grid_ga_route.h"
#include "core/smooth/path_maker.h"
#include "lasius/grid/geometry.h"

namespace lasius {

/// A chromosome with its path after polish. Cache lines of its own: threads make neighbours.
struct alignas(64) Individual {
  std::vector<Cell> cells;    // the path, start and goal included; empty when stopped
  double tour = 0;            // its length; NaN when stopped
  double length = kInfinity;  // after polish: less is fitter
  std::vector<Point> points;

  std::int64_t bytes() const noexcept { return held_bytes(cells, points); }  // memory held
};

struct GridGaMemory {
  struct alignas(64) Scratch {  // of one thread
    RouteMaker routes;
    PathMaker maker;
    std::vector<Cell> draft;
    std::vector<std::int32_t> places;         // indices in a path, hashed by cell
    std::vector<std::pair<int, int>> common;  // indices of a cell in both paths

    std::int64_t bytes() const noexcept {  // memory held
      return routes.bytes() + maker.bytes() + held_bytes(draft, places, common);
    }
  };

  std::vector<Scratch> scratch;
  std::vector<Individual> population, children;
  std::vector<int> parents, order;  // of tournaments

  std::int64_t bytes() const noexcept {  // memory held
    return held_bytes_of_all(scratch) + held_bytes_of_all(population) +
           held_bytes_of_all(children) + held_bytes(parents, order);
  }
};

}  // namespace lasius
