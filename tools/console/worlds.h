// The kinds of world that there are, and who plans on each.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/params.h"

namespace lasius::tool {

/// The planners of one kind of world.
struct World {
  enum class Kind { bitmap, arm, polygon };
  Kind kind;
  std::string_view key;     ///< in the JSON of `algorithms`
  std::string_view title;   ///< in its text; empty for bitmaps
  std::string_view plans;   ///< what its algorithms do, as in "among polygons"
  std::string_view detail;  ///< said behind that
  std::string_view advice;  ///< for those who ask one of them elsewhere
  std::span<const Algorithm> algorithms;
  std::string (*default_text)(const Algorithm&, std::string_view parameter);
  std::vector<std::string> (*formulas)(const Algorithm&);
};

/// Those that this program was built with, bitmaps first.
std::span<const World> worlds();

/// The name asked for, or of the world's first algorithm where it is empty. @throws UsageError for
/// one that plans elsewhere, and for an unknown one, with the nearest.
std::string_view algorithm_of(World::Kind kind, std::string_view name);

/// Endings of the names of files that hold polygon worlds.
inline constexpr std::array<std::string_view, 3> kPolygonFileEndings{".geojson", ".json", ".wkt"};
/// True for a name with one of these endings.
bool is_polygon_file(std::string_view file);

}  // namespace lasius::tool
