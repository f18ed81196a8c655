// How exponents and rule shares change with the iteration.
#pragma once

#include <algorithm>
#include <array>

#include "kernels/walk/walk.h"
#include "lasius/params.h"

namespace lasius {

/// What the rules of a step weigh in one iteration.
struct StepWeights {
  double alpha = 1;
  double beta = 0;
  std::array<double, kernels::kRules> rule_shares{};  ///< by kernels::Rule
};

/// True when ants choose between rules at some iteration, rather than always combine them.
inline bool mixes_rules(const Params& p) noexcept {
  return p.pheromone_rule_first > 0 || p.pheromone_rule > 0 || p.distance_rule_first > 0 ||
         p.distance_rule > 0 || (p.settling_time > p.critical_time && p.distance_rule_last > 0);
}

/// Linear from the first values at iteration 0 to the last ones at the critical time, constant from
/// there (Fan et al. 2004, eq. 5 and 6: alpha = 4q/mc, beta = (3mc - 1.5q)/mc for q < mc), but for
/// the share of distance alone, which goes on to its last value at the settling time.
inline StepWeights schedule(const Params& p, int iteration) noexcept {
  const auto part = [iteration](int from, int to) {
    return iteration < to ? static_cast<double>(iteration - from) / (to - from) : 1.0;
  };
  const auto between = [](double first, double last, double a) {
    return a < 1 ? first + (last - first) * a : last;
  };
  const double a = part(0, p.critical_time);
  const bool settles = iteration >= p.critical_time && p.settling_time > p.critical_time;
  const double distance = settles ? between(p.distance_rule, p.distance_rule_last,
                                            part(p.critical_time, p.settling_time))
                                  : between(p.distance_rule_first, p.distance_rule, a);
  return {between(p.alpha_first, p.alpha, a),
          between(p.beta_first, p.beta, a),
          {p.greedy, between(p.pheromone_rule_first, p.pheromone_rule, a), distance,
           between(p.combined_rule_first, p.combined_rule, a)}};
}

}  // namespace lasius
