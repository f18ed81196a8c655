// The options of commands on bitmaps, and of those among polygons in their place.
#pragma once

#include <string>

#include "tools/command_line/search_options.h"

namespace lasius::tool {

inline constexpr const char* kMapHelp =
    "Map: .map, PBM, PGM, PNG, BMP or ROS YAML; polygon world: .geojson, .json or .wkt";

void add_run_options(OptionTable& table, RunOptions& to, const SearchHelp& help);
/// What is left to do once all options of a run on a bitmap are read. @throws UsageError;
/// Error(invalid_parameter) for a value that the library refuses.
void finish_run(RunOptions& run);
/// The same of a plan, with its start and goal as they were typed.
PlanCommand plan_command(RunOptions& run, const std::string& start, const std::string& goal);

/// `--prepare [graph|labels]`.
void add_prepare(OptionTable& table, MapOptions& to, const char* help);
/// --cost and --inflation.
void add_cost_options(OptionTable& table, CostLayers& to);
void add_world_options(OptionTable& table, WorldOptions& to);
/// @throws UsageError where an option of polygon worlds is given with a bitmap.
void refuse_world_options(const OptionTable& table);
/// @throws UsageError where --radius is given for a polygon world.
void refuse_radius(const OptionTable& table);

}  // namespace lasius::tool
