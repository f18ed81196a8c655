// Vehicles: a footprint, a smallest turn, what may be driven and at what price.
#pragma once

#include <vector>

#include "lasius/export.h"
#include "lasius/grid/geometry.h"

namespace lasius::vehicle {

/// Where a vehicle stands, in continuous cell coordinates: its reference point (often the middle of
/// the rear axle), and the yaw in radians from the x axis (columns) towards the y axis (rows). As y
/// points down a picture, a growing yaw turns clockwise on it. A world whose y points up has yaw
/// and curvature of the other sign, and its footprint is mirrored.
struct Pose {
  double x = 0;    ///< column
  double y = 0;    ///< row, downwards
  double yaw = 0;  ///< radians, any number of turns, |yaw| at most 10^5
  friend bool operator==(const Pose&, const Pose&) = default;
};

inline constexpr double kMostTurningRadius = 1e5;  ///< cells

/// What moves. Lengths in cells.
struct Vehicle {
  /// Corners of a simple polygon, of either orientation, in the frame of the vehicle: x forward, y
  /// to the side to which yaw grows. The reference point (0, 0) may lie outside.
  std::vector<Point> footprint = {};
  /// Of the reference point, the least: 0.1 to kMostTurningRadius; 0: it turns in place alone.
  double turning_radius = 0;
  bool reverse = false;          ///< may drive backwards
  double reverse_cost = 2;       ///< of a cell backwards, at least 1; a cell forwards costs 1
  double cusp_cost = 0;          ///< of each change between forwards and backwards, cells
  bool rotate_in_place = false;  ///< may turn where it stands
  double rotation_cost = 3;      ///< of a radian in place, 0.001 to 1e5 cells
  bool sideways =
      false;  ///< drives to any side, its heading kept; a cell costs 1 whatever the side
  /// By how much the curvature may change for each cell driven, 1 / cells^2; 0: without limit.
  double curvature_rate = 0;
  friend bool operator==(const Vehicle&, const Vehicle&) = default;
};

/// One that steers: forwards and backwards, along arcs of the radius or wider.
LASIUS_EXPORT Vehicle car(std::vector<Point> footprint, double turning_radius);
/// One with two driven wheels: it turns in place, and drives straight.
LASIUS_EXPORT Vehicle differential(std::vector<Point> footprint);
/// One that drives to any side with its heading kept, and turns where it stands.
LASIUS_EXPORT Vehicle omni(std::vector<Point> footprint);
/// A rectangle from `back` behind the reference point to `front` before it, to `half_width` on
/// either side.
LASIUS_EXPORT std::vector<Point> rectangle(double back, double front, double half_width);

/// @throws Error(invalid_parameter) unless the footprint is a simple polygon of 3 to 256 corners
/// whose farthest corner is at most 1024 cells from the reference point, and every number in range;
/// a radius of 0 needs rotation in place; one that drives to any side has neither a radius nor a
/// reverse.
LASIUS_EXPORT void validate(const Vehicle& vehicle);

/// The circle about the reference point that holds the footprint: its radius, cells.
LASIUS_EXPORT double circumscribed_radius(const Vehicle& vehicle) noexcept;
/// The circle about the reference point inside the footprint: its radius, cells; 0 where the
/// reference point lies outside.
LASIUS_EXPORT double inscribed_radius(const Vehicle& vehicle) noexcept;

}  // namespace lasius::vehicle
