// A drive, with all that is told of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lasius/drive/drive.h"
#include "tools/bitmap/map_file.h"
#include "tools/drive/driven_vehicle.h"
#include "tools/options/options.h"

namespace lasius::tool {

struct DriveAnswer {
  LoadedMap map;
  std::optional<LoadedMap> world;  ///< nothing: as the map has it
  Changes changes;
  std::uint64_t changes_hash = 0;
  Place start, goal;
  double sense = 0;  ///< cells
  std::optional<DrivenVehicle> vehicle;
  DriveResult result;
  double elapsed_ms = 0;  ///< of the drive
  /// What costs the cells have without inflation, if any.
  std::optional<CostField> layers;
  /// The shortest walk by the robot's own moves through the world as it is at tick 0, over costs
  /// the cheapest one's cost, where there is one and it was found in time.
  std::optional<double> optimum;

  const LoadedMap& truth() const { return world ? *world : map; }
  /// Length travelled, or its cost, by the optimum, of a drive that arrived.
  std::optional<double> ratio() const {
    if (result.status != Status::solved || !optimum || !(*optimum > 0)) return std::nullopt;
    return (layers ? result.cost : result.length) / *optimum;
  }
};

/// The map of what is there. @throws Error(file_broken) unless it has the map's size and place.
LoadedMap read_world(MapOptions options, const std::string& file, const LoadedMap& map);

/// The world with its changes up to a tick, without moving obstacles; those that were put off too.
Grid world_at(const DriveAnswer& answer, std::int64_t tick);

}  // namespace lasius::tool
