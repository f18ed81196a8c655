// The colony on a bitmap, composed from parameters: run once, or often on a map that changes.
#pragma once

#include "core/colony/colony_memory.h"
#include "core/colony/grid_colony.h"
#include "lasius/params/own_rules.h"
#include "lasius/params/params.h"
#include "lasius/plan/progress.h"
#include "lasius/plan/request.h"
#include "lasius/plan/result.h"

namespace lasius {

/// Runs the colony that `params` composes from `request.start` to `request.goal`, which are free,
/// joined and not equal. `own`, checked, may take the place of some of its rules. For a disc `grid`
/// has the cells whose centres are clear, and `params` its rule of corners
/// (core/disc/disc_cells.h). Over a terrain, whose free cells are the grid's, costs take the place
/// of lengths: in deposits, in what is best, in curves; the result's length stays the length.
/// Of more than one island no rule is the caller's own.
Result run_colony(const Grid& grid, const Request& request, const Params& params,
                  ColonyMemory& memory, const Observer& observer, const OwnRules& own,
                  const disc::DiscSpace* disc = nullptr, const cost::Terrain* terrain = nullptr);

/// A colony that keeps its trail while its map changes and its start moves. One thread at a time
/// uses an object; a colony itself walks on Params::threads, which change nothing.
///
/// Iterations are counted on from run to run, whatever changes: schedules of alpha, beta and the
/// rules go on, and so do the ants' random numbers. So results depend on seed, parameters and the
/// sequence of calls alone. The first run gives what run_colony() gives.
class SurvivingColony {
 public:
  /// `grid`, edited by its owner between calls, must outlive the object and keep its size; so must
  /// `disc`, see run_colony(). `params` are a colony's of one island, valid.
  SurvivingColony(const Grid& grid, Cell goal, const Params& params,
                  const disc::DiscSpace* disc = nullptr)
      : goal_(goal),
        params_(params),
        colony_(grid, params_, memory_, no_own_rules(), GridColony::After::more_runs, disc) {}
  SurvivingColony(const SurvivingColony&) = delete;
  SurvivingColony& operator=(const SurvivingColony&) = delete;

  /// Up to `iterations` more, from `start`, which is free, joined to the goal and not equal to it.
  /// The result's path is the best since the start last moved or a change spoilt it; from a start
  /// that the best tour passes, the rest of that is offered before ants walk. Curves are this
  /// run's; an observer's Progress::iteration counts all. An iteration that is cut short leaves the
  /// trail as it was, to the bit, and its number to the next run: only its path may be in the
  /// result. Passes over the trail are completed: they take longer the more cells ants know.
  Result run(Cell start, int iterations, const StopCondition& stop = {},
             const Observer& observer = {});

  /// To be called when cells of `part` have been edited, before the next run; any number of times.
  /// `part` lies in the grid and is not empty, the goal stays free. Moves and heuristic are the
  /// grid's again; the best tour and the best path go where they are blocked, and so do their
  /// deposits; MAX-MIN bounds stay until an ant arrives. Pheromone elsewhere stays as it is.
  ///
  /// Where free cells of `part` might make a way shorter than the best tour, by the straight
  /// distances from start and goal to them, tau nears the tour's level beside them,
  ///     tau <- (1 - g) tau + g most,   g = 0.3 max(0, 1 - d / R),
  /// d the distance from `part`, R its longer side, most the largest tau on the best tour; and that
  /// tour deposits no longer, though its path is still offered. After Guntsch & Middendorf 2001
  /// (resets in proportion to nearness); share and radius are ours, see docs/theory.md. A terminal
  /// index forgets instead what leads nowhere, see forget_lost_ways().
  void changed(const Rectangle& part) {
    if (!blank_) colony_.changed(part);
  }
  /// Blank again, as a new object.
  void forget() noexcept { blank_ = true; }

 private:
  Cell goal_;
  Params params_;
  ColonyMemory memory_;
  GridColony colony_;
  bool blank_ = true;
};

}  // namespace lasius
