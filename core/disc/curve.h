// The path of a disc's centre: straight pieces and arcs.
#pragma once

#include <vector>

#include "core/disc/disc_space.h"
#include "lasius/geometry.h"
#include "lasius/path.h"

namespace lasius::disc {

/// @param radius  of the arcs
double curve_length(const Curve& curve, double radius) noexcept;

/// A polyline that keeps the radius as the curve does and is at most a thousandth longer: each arc
/// becomes the sides of a polygon around it, finer where other obstacles are near.
std::vector<Point> polyline_of(const Curve& curve, const DiscSpace& space);

}  // namespace lasius::disc
