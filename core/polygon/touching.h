// Points that would lie on an edge or on another point but for rounding are put there.
#pragma once

#include <vector>

#include "lasius/polygon/world.h"

namespace lasius::polygon {

/// Makes points of the polygons and lines that are within `reach` of each other one point, and the
/// others that are so near to an edge points of that edge, too. Then what touches shares a point,
/// and still does so on whatever grid. Nothing moves by more than `reach`.
void join_touching(std::vector<Polygon>& polygons, std::vector<Ring>& lines, double reach);

}  // namespace lasius::polygon
