// A caller's own rules in a colony on a bitmap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/growing_array.h"
#include "core/base/held_bytes.h"
#include "core/base/poller.h"
#include "core/colony/update.h"
#include "lasius/grid.h"
#include "lasius/own_rules.h"
#include "lasius/params.h"
#include "lasius/stop.h"

namespace lasius {

/// @throws Error(invalid_parameter) where rules do not go with a map or with parameters, which are
/// valid.
void check_own_rules(const OwnRules& own, const Grid& grid, const Params& params);

/// Where nothing is the caller's own.
inline const OwnRules& no_own_rules() {
  static const OwnRules none;
  return none;
}

/// The weights of an iteration by the caller's own schedule, which there is.
/// @throws Error(invalid_parameter) for one out of range.
StepWeights own_weights(const OwnRules& own, const Params& params, int iteration);

/// The tours of an iteration as numbers of cells and moves.
class NumberedTours {
 public:
  /// What an update is given of these tours; holds until the next call. Fewer when stopped.
  IterationTours number(const Tours& tours, const Grid& grid, Trail trail, Poller& poller);

  std::int64_t bytes() const noexcept {
    return cells_.bytes() + arcs_.bytes() + held_bytes(offsets_, lengths_);
  }

 private:
  void add(const Tour& tour, TrailPlace cell, const kernels::Moves& moves, int width, bool arcs);

  GrowingArray<TrailPlace> cells_, arcs_;  // of all tours, that of the best so far last
  std::vector<std::int64_t> offsets_;      // of a tour's first cell, and the end
  std::vector<double> lengths_;            // of the ants' tours
};

/// Lets the caller's own update, which there is, change the trail. True where it asks for the end
/// of the search. Cut short by `stop`; then perhaps not called.
bool update_by_caller(Field& field, const OwnRules& own, const Params& params, const Grid& grid,
                      Cell goal, const Tours& tours, NumberedTours& numbered,
                      const StopCondition& stop);

}  // namespace lasius
