// How exponents and shares of a colony's rules change with the iteration.
#pragma once

#include "lasius/export.h"
#include "lasius/params/params.h"

namespace lasius {

/// What the rules of a step weigh in one iteration; the fields are those of Params. A step takes
/// the largest weight with probability `greedy`; else it is drawn by one of three rules, of whose
/// shares only the ratios count.
struct StepWeights {
  double alpha = 1;           ///< exponent of pheromone, 0 to 20
  double beta = 1;            ///< exponent of visibility and heuristic, 0 to 20
  double greedy = 0;          ///< share of steps that take the largest weight, 0 to 1
  double pheromone_rule = 0;  ///< by pheromone and visibility, 0 to 10^6
  double distance_rule = 0;   ///< by the heuristic alone, 0 to 10^6
  double combined_rule = 1;   ///< by the product of all, 0 to 10^6; not all three are 0
  friend bool operator==(const StepWeights&, const StepWeights&) = default;
};

/// Those that parameters give to an iteration, from 0. Linear from the first values at iteration 0
/// to the last ones at the critical time, constant from there (Fan et al. 2004, eq. 5 and 6: alpha
/// = 4q/mc, beta = (3mc - 1.5q)/mc for q < mc), but for the share of the heuristic alone, which
/// goes on to its last value at the settling time.
LASIUS_EXPORT StepWeights schedule(const Params& params, int iteration) noexcept;

}  // namespace lasius
