// What is wrong with the rings of a polygon, by ring and point; and its repair.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geos.h"

namespace lasius::polygon {

/// Coordinates must not be larger.
inline constexpr double kMostCoordinate = 1e12;

/// The first fault of a polygon ("ring 0 crosses itself near (3, 4), between its points 2 and 3"),
/// or nothing. Ring 0 is the outer one, points count from 0.
std::optional<std::string> fault(const Geos& geos, const Polygon& polygon);

/// Takes out points that repeat the one before.
void drop_repeats(Ring& ring);

/// The same area as valid polygons; none where nothing is left. Precondition: finite coordinates.
std::vector<Polygon> repaired(const Geos& geos, Polygon polygon);

}  // namespace lasius::polygon
