// What is wrong with the rings of a polygon, by ring and point; with a margin.
#pragma once

#include <optional>
#include <string>

#include "core/polygon/world/geos.h"

namespace lasius::polygon {

/// Coordinates must not be larger.
inline constexpr double kMostCoordinate = 1e12;
/// Rings must not be smaller: squares of lengths would underflow.
inline constexpr double kLeastExtent = 1e-100;

/// The first fault of a polygon ("Self-intersection near (3, 3), on ring 0 between its points 0 and
/// 1"), or nothing. Ring 0 is the outer one, points count from 0.
std::optional<std::string> fault(const Geos& geos, const Polygon& polygon);

/// The first fault of a wall, or nothing; points count from 0.
std::optional<std::string> wall_fault(const Ring& line);

/// Takes out points that repeat the one before.
void drop_repeats(Ring& ring);

/// What is wrong with a margin, or nothing; and the remedy.
std::optional<std::string> margin_fault(double margin);
inline constexpr const char* kMarginRemedy = "it must be a number from 0 to 1e12";

}  // namespace lasius::polygon
