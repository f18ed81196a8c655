// When ants choose between rules.
#pragma once

#include "lasius/params.h"

namespace lasius {

/// True when ants choose between rules at some iteration, rather than always combine them.
inline bool mixes_rules(const Params& p) noexcept {
  return p.pheromone_rule_first > 0 || p.pheromone_rule > 0 || p.distance_rule_first > 0 ||
         p.distance_rule > 0 || (p.settling_time > p.critical_time && p.distance_rule_last > 0);
}

}  // namespace lasius
