// The figures of `lasius_bench colony`, each group measured by one function.
#pragma once

#include <string>
#include <vector>

#include "bench/report.h"
#include "lasius/grid/grid.h"
#include "lasius/plan/planner.h"

namespace lasius::bench {

/// A map with one query.
struct Course {
  std::string name;
  Grid grid;
  Cell start, goal;
};
/// maps/fan400x200.map and its query.
const Course& fan_course();

/// Ant steps a second, in processor time, of the textbook ant system, the bare ceiling, `as` with 8
/// neighbours and `fan2004`, in turns; medians over the rounds.
std::vector<Figure> measure_steps(int rounds);

/// Ant steps a second of every colony, in walks alone and in unpolished plans, as a ratio to
/// fan2004's in the same round.
std::vector<Figure> measure_variants(int rounds);

/// fan2004 with 64 ants on one thread and on two, in turns, and whether they answer alike.
std::vector<Figure> measure_threads(int rounds);

/// The fan course alone and inside a blocked map of side x side: time of an iteration, memory.
std::vector<Figure> measure_area(int rounds, int side);

/// Time of queries between cells that are not joined, on a map of 40% noise of that side.
std::vector<Figure> measure_unreachable(int queries, int side);

}  // namespace lasius::bench
