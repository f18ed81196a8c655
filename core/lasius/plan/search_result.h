// How a search ended, in any world.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lasius/base/status.h"
#include "lasius/export.h"

namespace lasius {

/// The course of a search by iteration; empty for one without iterations.
struct Convergence {
  int iterations = 0;        ///< done
  std::vector<double> best;  ///< by iteration: shortest final path up to then; NaN if none
  std::vector<double> mean;  ///< by iteration: mean raw tour of the arrived ants; NaN if none
  std::vector<int> arrived;  ///< by iteration: ants that reached the goal
  // Of colonies on bitmaps; empty elsewhere. NaN in an iteration in which no ant arrived.
  std::vector<double> raw_best;  ///< by iteration: its shortest raw tour
  std::vector<double> cut_mean;  ///< by iteration: mean of its tours after Params::walk_cut
  std::vector<double> cut_best;  ///< by iteration: the shortest of them
  /// By iteration: the shortest path that it offered, of its own: after polish; of `terminal-index`
  /// the way along the index. `best` is the least so far.
  std::vector<double> iteration_best;
  std::vector<std::int64_t> steps;  ///< by iteration: moves of all ants, backward ones too
  /// By iteration: of the cells on its raw tours the share within a tenth of the distance from
  /// start to goal of the straight line through both.
  std::vector<double> band;
  /// By iteration: how open the trail leaves the choice, 1 where all moves are alike and 0 where
  /// one has all pheromone: entropy of the moves' pheromone over its greatest, mean over at most 64
  /// cells spread over the best tour so far. NaN where there is no trail.
  std::vector<double> trail_entropy;
};

/// What the answers of all planners have in common. Without a path `length` is not a number.
struct LASIUS_EXPORT SearchResult {
  Status status = Status::no_path;  ///< how it ended
  Limit limit = Limit::none;        ///< which one ended it
  Fault fault = Fault::none;        ///< why it is invalid or unreachable
  std::string error;                ///< the same in a sentence that names the place; empty for none
  double length = std::numeric_limits<double>::quiet_NaN();  ///< of the path, in the world's unit
  std::optional<double> lower_bound;                         ///< certified: no path is shorter
  /// Certified (length - lower_bound) / lower_bound; 0 at length 0; nothing where there is no path
  /// or no bound above 0.
  std::optional<double> gap() const;
  bool optimal = false;     ///< proven shortest
  Convergence curves = {};  ///< the course of the search
};

}  // namespace lasius
