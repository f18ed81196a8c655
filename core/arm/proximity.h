// Distances from a segment to the shapes of a scene, metres, in the shape's own frame.
//
// The distance from a point that runs along a segment to a convex set is a convex function of its
// place, so a minimum is found by the sign of a derivative: no iteration can miss it.
#pragma once

#include "core/arm/robot/vec3.h"

namespace lasius::arm {

struct Segment {
  Vec3 from;
  Vec3 to;
};

using Triangle = std::array<Vec3, 3>;

/// To the box around the origin with these half sides. Exact.
double distance_to_box(const Segment& s, Vec3 half) noexcept;

/// To the solid cylinder around the z axis. Within 1e-9 of the segment's length, never below.
double distance_to_cylinder(const Segment& s, double radius, double half_length) noexcept;

double distance_to_point(const Segment& s, Vec3 point) noexcept;
double distance_to_segment(const Segment& s, const Segment& t) noexcept;
double distance_to_triangle(const Segment& s, const Triangle& triangle) noexcept;

}  // namespace lasius::arm
