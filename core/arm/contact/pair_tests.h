// How far two placed shapes are apart.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "core/arm/contact/gjk.h"
#include "core/arm/contact/shape.h"
#include "core/arm/robot/kinematics.h"

namespace lasius::arm {

/// Bodies in the world by number, the base first.
using Bodies = std::array<Placement, Robot::kMaxJoints + 1>;

inline void place_bodies(const Kinematics& arm, std::span<const double> q, Kinematics::Poses& poses,
                         Bodies& bodies) {
  arm.place(q, poses);
  std::copy_n(poses.begin(), arm.size(), bodies.begin() + 1);
}

/// Metres between the balls around two shapes, or the ball of one and the other itself.
struct BallGap {
  double gap;
  Vec3 centre, normal;  // of the first one's ball; away from the second
  Vec3 guess;           // of how the shapes lie to each other: for gjk_apart
};
inline BallGap ball_gap(const Shape& a, const Placement& at, const Shape& b,
                        const PlacedShape& placed) noexcept {
  const Vec3 centre = at * a.centre, off = centre - placed.nearest(centre);
  const double away = length(off);
  if (away > 0) return {away - a.radius - b.round, centre, (1 / away) * off, off};
  return {-a.radius - b.round, centre, {}, centre - placed.centre()};
}

/// Metres between two shapes where that is below `enough`, else something from there on; never
/// above the distance, of covers of that of what they cover.
template <GjkAsked asked>
double shapes_apart(const Shape& a, const PlacedShape& at, Vec3 guess, const Shape& b,
                    const PlacedShape& other, double enough) noexcept {
  const double round = a.round + b.round;
  return gjk_apart<asked>(at, other, guess, enough + round) - round;
}

/// Which of two shapes is looked into, where not both are exact.
inline bool first_is_opened(const Shape& a, const Shape& b) noexcept {
  return !a.exact && (b.exact || a.radius >= b.radius);
}

}  // namespace lasius::arm
