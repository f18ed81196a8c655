// What tours keep and one-trees need not: blossoms, which bring the bound nearer to the tour.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lasius::tour {

/// A handle of stops, and an odd number of legs that leave it, its teeth. A tour takes at most
/// `most` of the legs within the handle and the teeth (Edmonds 1965): at each stop of the handle it
/// takes two, each tooth at most once, so twice these are at most 2 |handle| + |teeth|.
struct Blossom {
  std::vector<int> handle;                 ///< stops, rising
  std::vector<std::pair<int, int>> teeth;  ///< inner stop, outer stop
  std::int64_t most() const { return static_cast<std::int64_t>(handle.size() + teeth.size() / 2); }
  friend bool operator==(const Blossom&, const Blossom&) = default;
};

/// How much of a leg a mean of trees takes, from 0 to 1.
struct SharedLeg {
  int a, b;
  double share;
};

/// Blossoms of which such legs, at most two a stop in sum, take clearly more than tours do: handles
/// are the stops that legs join which are taken in part (Padberg & Hong 1980), with several limits
/// of what that is.
std::vector<Blossom> blossoms_of(int stops, std::span<const SharedLeg> legs);

}  // namespace lasius::tour
