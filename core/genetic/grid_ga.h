// The genetic algorithm on grids: the comparator of the ant colonies.
#pragma once

#include <functional>

#include "core/genetic/grid_ga_memory.h"
#include "lasius/params/params.h"
#include "lasius/plan/progress.h"
#include "lasius/plan/request.h"
#include "lasius/plan/result.h"

namespace lasius {

/// Plans from `request.start` to `request.goal`, which are free, joined and not equal. With a disc
/// as run_colony().
///
/// Ahn and Ramakrishna: A genetic algorithm for shortest path routing problem and the sizing of
/// populations. IEEE Trans. Evolutionary Computation 6 (6), 2002. A chromosome is a path, cell by
/// cell; parents are won in pairwise tournaments without replacement; they cross at a cell that
/// both visit, drawn among all such cells; a mutation draws a cell of the path and goes on from
/// there by a new way; a repair takes out loops. Population and generations are free there; the
/// others are its values: crossover with probability 1, mutation 0.05.
///
/// What a grid asks for beside: new ways are greedy walks that step back from dead ends, to a cell
/// drawn from the map and from there to the goal, the first one straight to the goal (as on the
/// grids of Chaari et al.: Design and performance analysis of global path planning techniques.
/// Int. J. Advanced Robotic Systems 14 (2), 2017). Fitness is the length after polish. The best
/// path replaces the worst child where no child is as good.
///
///   joined  true where a cell can be reached from the start
/// One generation is one entry of the result's curves; `mean` is over the unpolished paths.
Result run_grid_ga(const Grid& grid, const Request& request, const Params& params,
                   const std::function<bool(Cell)>& joined, GridGaMemory& memory,
                   const Observer& observer, const disc::DiscSpace* disc = nullptr);

}  // namespace lasius
