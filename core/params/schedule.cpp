#include "lasius/params/schedule.h"

namespace lasius {

StepWeights schedule(const Params& p, int iteration) noexcept {
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
  return {.alpha = between(p.alpha_first, p.alpha, a),
          .beta = between(p.beta_first, p.beta, a),
          .greedy = p.greedy,
          .pheromone_rule = between(p.pheromone_rule_first, p.pheromone_rule, a),
          .distance_rule = distance,
          .combined_rule = between(p.combined_rule_first, p.combined_rule, a)};
}

}  // namespace lasius
