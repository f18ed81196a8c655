// The options of polygon worlds: as typed, and read.
#pragma once

#include <string>
#include <string_view>

#include "tools/command_line/run_text.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// True for the files that are polygon worlds, by their ending: .geojson, .json, .wkt.
bool is_world(std::string_view file);

struct WorldText {
  std::string margin, join;
  bool repair = false;
};

struct PolygonText {
  WorldText world;
  std::string start, goal;
};

/// @throws UsageError
WorldOptions make_world_options(const std::string& file, const WorldText& text);
PolygonCommand make_polygon(const RunText& run, const PolygonText& text);

/// @throws UsageError where --radius is given for a polygon world.
void refuse_radius(std::string_view radius);

/// @throws UsageError where an option of polygon worlds is given with a bitmap.
void refuse_world_options(const WorldText& text);

}  // namespace lasius::tool
