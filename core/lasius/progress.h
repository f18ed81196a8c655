// What an observer sees of a run under way.
#pragma once

#include <functional>
#include <vector>

#include "lasius/export.h"
#include "lasius/geometry.h"

namespace lasius {

/// What an observer may look at, between two iterations, on the calling thread. `exact` has none;
/// to `grid-ga` ants are its individuals, and there is no pheromone (0). @throws std::out_of_range
/// for an ant that is none.
class LASIUS_EXPORT Progress {
 public:
  virtual ~Progress();
  int iteration = 0;       ///< from 0
  double best_length = 0;  ///< NaN if none yet
  double mean_length = 0;  ///< NaN if none arrived
  int arrived = 0;
  virtual int ants() const = 0;
  /// The tour of one ant, start to goal; empty if it did not arrive.
  virtual std::vector<Cell> tour(int ant) const = 0;
  /// The way that one ant had taken when it ended, arrived or stuck.
  virtual std::vector<Cell> walk(int ant) const { return tour(ant); }
  /// Pheromone on a cell of the map.
  virtual double pheromone(Cell c) const = 0;
};
using Observer = std::function<void(const Progress&)>;

}  // namespace lasius
