// What an observer sees of a search under way.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/plan/search_result.h"

namespace lasius {

/// Where a search stands, in any world. Colonies and genetic algorithms show it after every
/// iteration, exact searches with every shorter path, on the thread that called the planner.
struct Progress {
  int iteration = 0;  ///< from 0; of an exact search the number of the improvement
  double best_length = std::numeric_limits<double>::quiet_NaN();  ///< NaN if none yet
  double mean_length = std::numeric_limits<double>::quiet_NaN();  ///< NaN if no ant arrived
  int arrived = 0;                                                ///< ants that reached the goal
  std::optional<double> lower_bound;  ///< certified, where the algorithm knows one by now
  /// The curves so far, this iteration's entries last; among polygons those of the route at hand;
  /// they hold until the observer returns.
  /// Null from an exact search.
  const Convergence* curves = nullptr;
};

/// The same on a bitmap, with what can be looked at while the observer is called. To `grid-ga` ants
/// are its individuals; `exact` has none.
class LASIUS_EXPORT GridProgress : public Progress {
 public:
  virtual ~GridProgress();
  /// The best path so far; empty if there is none.
  virtual std::vector<Point> path() const = 0;
  /// Ants of an iteration.
  virtual int ants() const { return 0; }
  /// The tour of one ant, start to goal; empty if it did not arrive.
  /// @throws std::out_of_range unless 0 <= ant < ants().
  virtual std::vector<Cell> tour(int ant) const;
  /// The way that one ant had taken when it ended, arrived or stuck. @throws as tour.
  virtual std::vector<Cell> walk(int ant) const { return tour(ant); }
  /// Pheromone on a cell of the map; 0 where the algorithm has none.
  virtual double pheromone(Cell c) const;
};
/// Called with a view that holds until it returns.
using Observer = Callback<const GridProgress&>;

}  // namespace lasius
