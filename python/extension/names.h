// Values of enumerations by their names, as Python says them.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "lasius/base/error.h"
#include "lasius/grid/moves.h"

namespace lasius::python {

/// @throws Error(invalid_parameter) for a name that is none of them.
template <class Enum>
Enum value_of(const char* parameter, std::span<const std::string_view> names,
              std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<Enum>(found - names.begin());
  std::string list;
  for (const std::string_view n : names) list += (list.empty() ? "" : ", ") + std::string(n);
  throw Error(ErrorCode::invalid_parameter,
              std::string(parameter) + " is '" + std::string(name) + "'",
              "it must be one of " + list);
}

inline Corners corners_from(std::string_view name) {
  return value_of<Corners>("corners", kCornersNames, name);
}

}  // namespace lasius::python
