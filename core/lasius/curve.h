// The path of a disc's centre as it is: straight pieces and arcs.
#pragma once

#include <vector>

#include "lasius/geometry.h"

namespace lasius {

/// A straight piece, or an arc about a corner of a blocked cell with the disc's radius.
struct CurvePiece {
  Point from;          ///< where it begins
  Point to;            ///< and ends
  int turn = 0;        ///< 0: straight; 1: an arc that turns from the x axis to the y axis, -1: back
  Point centre = {};   ///< of an arc
  double angle = 0;    ///< of an arc, in radians, more than 0 and at most pi / 2
  double radius = 0;   ///< of an arc, in cells
  friend bool operator==(const CurvePiece&, const CurvePiece&) = default;
};

/// Pieces from start to goal, each beginning where the one before ends and, but for single points,
/// in its direction.
using Curve = std::vector<CurvePiece>;

}  // namespace lasius
