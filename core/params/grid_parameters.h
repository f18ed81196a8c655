// The parameters that algorithms on bitmaps read, and what some of them say together.
#pragma once

#include <span>

#include "lasius/params/params.h"

namespace lasius {

/// The parameters that every grid colony reads.
std::span<const Parameter> colony_parameters();
/// The parameters that the genetic comparator reads.
std::span<const Parameter> genetic_parameters() noexcept;

/// True when ants choose between rules at some iteration, rather than always combine them.
inline bool mixes_rules(const Params& p) noexcept {
  return (p.critical_time > 0 && p.pheromone_rule_first + p.distance_rule_first > 0) ||
         p.pheromone_rule > 0 || p.distance_rule > 0 ||
         (p.settling_time > p.critical_time && p.distance_rule_last > 0);
}

}  // namespace lasius
