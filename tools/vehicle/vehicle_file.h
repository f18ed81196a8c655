// Files of vehicles: YAML or JSON.
#pragma once

#include <cstdint>
#include <string>

#include "lasius/vehicle/profile.h"
#include "lasius/vehicle/vehicle.h"
#include "tools/bitmap/map_file.h"

namespace lasius::tool {

/// A vehicle as plans and checks take it: in cells.
struct LoadedVehicle {
  std::string file = {};
  std::uint64_t hash = 0;         ///< of the file's bytes
  vehicle::Vehicle vehicle = {};  ///< y of its footprint as that of cells: down
  vehicle::SpeedLimits speeds = {};
};

/// Reads a vehicle for a map. Keys, of which `footprint` alone is always needed:
///   type                 car (default where a turning radius is given), differential or omni
///   units                metres or cells: of all lengths; metres where the map has a resolution
///   footprint            [[x, y], ...] about the reference point, x forward, y to the side that
///                        yaw grows to in `frame`; also as a text, as Nav2 has it
///   turning_radius, reverse, reverse_cost, cusp_cost, rotate_in_place, rotation_cost,
///   curvature_rate (of a unit squared; the profile then rests where the curvature jumps)
///   speed, reverse_speed, acceleration, braking, lateral_acceleration, turn_rate,
///   turn_acceleration    of the profile: a unit a second and a radian a second where not given
/// @throws Error(file_missing, file_broken) naming file, line and key
LoadedVehicle read_vehicle(const std::string& file, const LoadedMap& map, Frame frame);

}  // namespace lasius::tool
