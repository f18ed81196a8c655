#include "core/arm/lattice_trail.h"

#include <algorithm>
#include <cassert>

#include "kernels/base/power.h"

namespace lasius::arm {
namespace {

// A power of two keeps every ratio exact. Weaker trails than the floor count as the floor: with
// alpha up to 8 no weight leaves the range of a double.
constexpr double kRescaleBelow = 0x1p-40;
constexpr double kFloor = 0x1p-60;

}  // namespace

LatticeTrail::LatticeTrail(const Lattice& lattice, Pheromone kind, double initial, double alpha)
    : lattice_(lattice),
      kind_(kind),
      alpha_(alpha),
      scale_(initial),
      untouched_power_(power(1)),
      stored_(lattice.moves() * lattice.nodes()),
      power_(lattice.moves() * lattice.nodes()) {}

double LatticeTrail::power(double stored) const noexcept {
  if (alpha_ == 0) return 1;
  return alpha_ == 1 ? stored : kernels::power(stored, alpha_);
}

void LatticeTrail::evaporate(double persistence) {
  assert(scale_ > 0);
  scale_ *= std::max(persistence, kFloor);
  while (scale_ < kRescaleBelow) {
    scale_ /= kRescaleBelow;
    untouched_ = std::max(untouched_ * kRescaleBelow, kFloor);
    for (const auto place : touched_)
      stored_[place] = std::max(stored_[place] * kRescaleBelow, kFloor);
    all_changed_ = true;
  }
}

void LatticeTrail::deposit(std::int64_t place, double amount) {
  if (!(stored_[place] > 0)) touched_.push_back(place);
  stored_[place] = stored(place) + amount / scale_;
  changed_.push_back(place);
}

void LatticeTrail::refresh() {
  untouched_power_ = power(untouched_);
  for (const auto place : all_changed_ ? touched_ : changed_) power_[place] = power(stored_[place]);
  changed_.clear();
  all_changed_ = false;
}

}  // namespace lasius::arm
