// Parameters of algorithms by name: from the command line, and to and from results.
#pragma once

#include <string>
#include <string_view>

#include "lasius/params.h"

namespace lasius::tool {

/// The defaults of an algorithm; of the library's first one where `name` is empty.
/// @throws UsageError for an unknown one, with the nearest.
Params default_params(std::string_view name);

/// The library's entry. Precondition: a known name.
const Algorithm& find_algorithm(std::string_view name);

bool has_parameter(const Algorithm& algorithm, std::string_view name);

/// Sets a parameter that has an option of its own. False where the algorithm does not have it; the
/// value is checked all the same.
bool set_common(Params& params, std::string_view name, std::string_view value);

/// Sets "NAME=VALUE". @throws UsageError where the algorithm has no such parameter, with the
/// nearest; Error(invalid_parameter) for a bad value.
void set_named(Params& params, std::string_view setting);

}  // namespace lasius::tool
