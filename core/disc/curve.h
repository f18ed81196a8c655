// The path of a disc's centre: straight pieces and arcs.
#pragma once

#include <span>
#include <vector>

#include "core/disc/disc_space.h"
#include "lasius/grid/geometry.h"
#include "lasius/path/path.h"

namespace lasius::disc {

/// Of arcs as long as at the radius asked for: to first order, a taut curve grows with its radius
/// by what it turns, so this is the shortest length of that radius, not of the one planned with.
double curve_length(std::span<const CurvePiece> curve) noexcept;

/// A polyline that keeps the radius as the curve does and is at most a thousandth longer: each arc
/// becomes the sides of a polygon around it, finer where other obstacles are near.
std::vector<Point> polyline_of(const Curve& curve, const DiscSpace& space);

}  // namespace lasius::disc
