// Pheromone on the edges of a lattice.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice.h"

namespace lasius::arm {

/// tau of every edge, and tau^alpha of it as the ants read it.
///
/// As in the grid's field, evaporation multiplies one number that cancels in every draw, so an edge
/// without a deposit costs nothing; only edges with a new deposit get a new power.
class LatticeTrail {
 public:
  LatticeTrail(std::int64_t edges, double initial, double alpha);

  // What trail_rules.h asks of a trail; a place is an edge.
  void evaporate(double persistence);
  void deposit(std::int64_t edge, double amount);
  double tau(std::int64_t edge) const noexcept { return stored(edge) * scale_; }

  /// Brings the powers up to date with the deposits so far.
  void refresh();
  /// tau^alpha, up to a factor that all edges share.
  double attraction(std::int64_t edge) const noexcept {
    const double power = power_[edge];
    return power > 0 ? power : untouched_power_;
  }

 private:
  double stored(std::int64_t edge) const noexcept {
    const double value = stored_[edge];
    return value > 0 ? value : untouched_;
  }
  double power(double stored) const noexcept;

  double alpha_;
  double scale_;          // tau = stored * scale
  double untouched_ = 1;  // stored, where there was no deposit
  double untouched_power_;
  ZeroArray<double> stored_;           // 0: untouched
  ZeroArray<double> power_;            // likewise
  std::vector<std::int64_t> touched_;  // every edge with a deposit
  std::vector<std::int64_t> changed_;  // since the last refresh
  bool all_changed_ = false;
};

}  // namespace lasius::arm
