// What tours keep and one-trees need not: combs, which bring the bound nearer to the tour.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poller.h"

namespace lasius::tour {

/// A handle of stops, and an odd number of teeth, sets of stops each partly in the handle. A tour
/// takes at most `most` legs within the handle and within the teeth, those within both counted
/// twice (Grötschel & Padberg 1979; with teeth of two stops, a blossom, Edmonds 1965): within a set
/// it takes fewer than that has stops. Teeth have no stop in common, unless all are of two.
struct Comb {
  std::vector<int> handle;              ///< rising
  std::vector<std::vector<int>> teeth;  ///< each rising
  std::int64_t most() const;
  friend bool operator==(const Comb&, const Comb&) = default;
};

/// How much of a leg a mean of trees takes, from 0 to 1.
struct SharedLeg {
  int a, b;
  double share;
};

/// Combs of which such legs, at most two a stop in sum, take about more than tours do. Handles are
/// the stops that legs join which are taken in part (Padberg & Hong 1980), with several limits of
/// what that is, or grow from a stop by the most of such legs; teeth are the legs that leave them.
/// So first among stops, then among sets of stops, of which the legs take all they can. Stopped,
/// those that were found so far.
std::vector<Comb> combs_of(int stops, std::span<const SharedLeg> legs, Poller& poller);

}  // namespace lasius::tour
