// Pheromone in a lattice.
#pragma once

#include <cstdint>
#include <vector>

#include "core/arm/lattice.h"

namespace lasius::arm {

/// tau of every place, an arc or an edge, and tau^alpha of it as the ants read it.
///
/// As in the grid's field, evaporation multiplies one number that cancels in every draw, so a place
/// without a deposit costs nothing; only places with a new deposit get a new power.
class LatticeTrail {
 public:
  /// Precondition: `initial`, the pheromone everywhere, is a normal number above 0.
  LatticeTrail(const Lattice& lattice, Pheromone kind, double initial, double alpha);

  /// What carries the pheromone of a move.
  std::int64_t place(Node v, int move) const noexcept {
    return kind_ == Pheromone::arcs ? lattice_.moves() * v + move : lattice_.edge(v, move);
  }

  // What trail_rules.h asks of a trail.
  void evaporate(double persistence);
  void deposit(std::int64_t place, double amount);
  double tau(std::int64_t place) const noexcept { return stored(place) * scale_; }

  /// Brings the powers up to date with the deposits so far.
  void refresh();
  /// tau^alpha, up to a factor that all places share.
  double attraction(std::int64_t place) const noexcept {
    const double power = power_[place];
    return power > 0 ? power : untouched_power_;
  }

 private:
  double stored(std::int64_t place) const noexcept {
    const double value = stored_[place];
    return value > 0 ? value : untouched_;
  }
  double power(double stored) const noexcept;

  const Lattice& lattice_;
  Pheromone kind_;
  double alpha_;
  double scale_;          // tau = stored * scale
  double untouched_ = 1;  // stored, where there was no deposit
  double untouched_power_;
  ZeroArray<double> stored_;           // by place; 0: untouched
  ZeroArray<double> power_;            // stored^alpha by place; 0: untouched
  std::vector<std::int64_t> touched_;  // every place with a deposit
  std::vector<std::int64_t> changed_;  // since the last refresh
  bool all_changed_ = false;
};

}  // namespace lasius::arm
