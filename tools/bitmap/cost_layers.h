// What cells cost, as the command line gives it: files of values with their factors, and inflation.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lasius/cost/planner.h"
#include "lasius/grid/map_io.h"
#include "tools/options/options.h"
#include "tools/record/json_values.h"

namespace lasius::tool {

/// What cells of a map cost, and where that comes from.
struct LoadedCosts {
  CostLayers asked;
  CostField field;
  std::vector<std::uint64_t> hashes = {};   ///< of the layers' files, a ROS map's with its image
  std::vector<std::string> images = {};     ///< of layers that are ROS maps
  std::optional<Inflation> inflation = {};  ///< in cells
  std::vector<std::string> notes = {};      ///< layers without effect, as sentences
  std::optional<CostPlanner> planner = {};  ///< once there is one of the map
};

/// The weights of a map's cells: 1, each file's values times its factor, and the inflation, whose
/// robot has `radius` cells. Blocks cells where a ROS map among the layers is occupied. `metres`:
/// the inflation is given in metres, of the frame. Precondition: then there is one.
/// @throws Error for files that are missing, broken or of another size, and for inflation out of
/// its range.
LoadedCosts load_costs(Grid& grid, const std::optional<WorldFrame>& frame, const CostLayers& asked,
                       bool metres, double radius);

/// A length by a cell's in the same unit: what is whole but for rounding is whole.
double cells_in(double length, double resolution);
/// Adds the inflation that is asked for to costs that were made without it, or notes that it
/// reaches no cell.
void inflate(LoadedCosts& costs, const Grid& grid, const std::optional<WorldFrame>& frame,
             bool metres, double radius);

/// What a result tells of costs: `layers` in what was found, `inflation` and `moves` in parameters.
void record_costs(const LoadedCosts& costs, Json& findings, Json& parameters);
/// @throws Error(file_broken) where a layer is not the one that the result records.
void check_layers(const LoadedCosts& costs, const Json& result);

}  // namespace lasius::tool
