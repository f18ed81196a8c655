// The path of a disc's centre: straight pieces and arcs.
#pragma once

#include <vector>

#include "core/disc/disc_space.h"
#include "lasius/geometry.h"

namespace lasius::disc {

/// A straight piece, or an arc about a corner of a blocked cell with the disc's radius.
struct CurvePiece {
  Point from, to;
  int turn = 0;  ///< 0: straight; +1: an arc that turns from the x axis to the y axis, -1: back
  Point centre = {};  ///< of an arc
  double angle = 0;   ///< of an arc, in radians, more than 0 and at most pi / 2
};

/// Pieces from start to goal, each beginning where the one before ends and, but for single points,
/// in its direction.
using Curve = std::vector<CurvePiece>;

/// @param radius  of the arcs
double curve_length(const Curve& curve, double radius) noexcept;

/// A polyline that keeps the radius as the curve does and is at most a thousandth longer: each arc
/// becomes the sides of a polygon around it, finer where other obstacles are near.
std::vector<Point> polyline_of(const Curve& curve, const DiscSpace& space);

}  // namespace lasius::disc
