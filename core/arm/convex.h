// Distances between convex sets, by their support points (Gilbert, Johnson & Keerthi 1988).
//
// What is returned is how far a plane keeps the two apart: each support point gives such a plane,
// so the answer is never above the true distance, however well the search for it went.
#pragma once

#include "core/arm/proximity.h"

namespace lasius::arm {

/// A box, or a cylinder around z: all points within `round` across z of a box with these half
/// sides, of which x and y are 0 where `round` is not.
struct Block {
  Placement pose;
  Vec3 half;
  double round = 0;

  /// A point of it that is furthest along `direction`.
  Vec3 support(Vec3 direction) const noexcept;
};

/// Metres between two blocks, where that is below `enough`; else a value from `enough` on that is
/// not above it. Less than the true one by at most a millionth of it and 1e-9.
double distance_between(const Block& a, const Block& b, double enough) noexcept;
double distance_between(const Block& a, const Triangle& b, double enough) noexcept;
double distance_between(const Triangle& a, const Triangle& b, double enough) noexcept;

}  // namespace lasius::arm
