// Parameters of algorithms by name: from the command line, and to and from results.
#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "lasius/params.h"

namespace lasius::tool {

/// The defaults of an algorithm; of the library's first one where `name` is empty.
/// @throws UsageError for an unknown one, with the nearest.
Params default_params(std::string_view name);

/// @throws UsageError for an algorithm that plans elsewhere: for arms, or among polygons where
/// `on_bitmap`, else on bitmaps.
void refuse_elsewhere(std::string_view name, bool on_bitmap);

/// @throws UsageError for a parameter of --set that is an option of its own.
void refuse_option(std::string_view setting);

/// Names of algorithms or of parameters.
template <class Named>
std::vector<std::string_view> names_of(std::span<const Named> things) {
  std::vector<std::string_view> names;
  for (const Named& thing : things) names.push_back(thing.name);
  return names;
}

/// Sets a parameter that has an option of its own. False where the algorithm does not have it; the
/// value is checked all the same.
bool set_common(Params& params, std::string_view name, std::string_view value);

/// Name and value of "NAME=VALUE". @throws UsageError for anything else.
std::pair<std::string_view, std::string_view> setting_parts(std::string_view setting);

/// Sets "NAME=VALUE". @throws UsageError where the algorithm has no such parameter, with the
/// nearest; Error(invalid_parameter) for a bad value.
void set_named(Params& params, std::string_view setting);

}  // namespace lasius::tool
