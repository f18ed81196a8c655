// Where a question's map comes from.
#pragma once

#include <filesystem>
#include <string>

#include "lasius/grid/generate.h"
#include "lasius/grid/map_io.h"
#include "tools/study/study.h"

namespace lasius::study {

/// A map of any kind in a file of `folder`, or a generated map: "random WxH DENSITY SEED" with any
/// kind of `lasius generate`, whose own density is "default". @throws Error for a missing or broken
/// file, or a map that cannot be made.
Grid load_map(const std::string& source, const std::filesystem::path& folder);
/// load_map() with the frame that a ROS map has.
Map load_framed_map(const std::string& source, const std::filesystem::path& folder);
/// The map of a question, with what its layers block, and what cells weigh by them.
struct WeightedMap {
  Map map;
  CostField costs;
};
/// @throws Error for what load_framed_map() or load_costs() refuse.
WeightedMap load_weighted_map(const Question& question, const std::filesystem::path& folder);
/// The map of a question, its obstacles grown by the radius, in cells.
Grid load_map(const Question& question, const std::filesystem::path& folder);

/// True for a map that is generated: its second word is a size.
bool is_generated(const std::string& source);

/// What the words of a generated map say. @throws Error(invalid_parameter) for other words; whether
/// the map can be made is not looked at.
struct GeneratedMap {
  MapKind kind{};
  GenerateOptions options = {};
};
GeneratedMap generated_map(const std::string& source);

}  // namespace lasius::study
