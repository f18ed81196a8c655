// The inputs that a saved result records.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "tools/console/exit_code.h"
#include "tools/record/json_values.h"

namespace lasius::tool {

/// The value at some keys of a result, as in "map/file". @throws UsageError naming a missing key.
const Json& value_at(const Json& result, const std::string& keys);

/// The same as a value of C++. @throws UsageError, also where it is of another type.
template <class Value>
Value recorded(const Json& result, const std::string& keys) {
  const Json& value = value_at(result, keys);
  try {
    return value.get<Value>();
  } catch (const Json::exception&) {
    throw UsageError("\"" + keys + "\" is " + dumped(value));
  }
}

/// Null: nothing.
template <class Value>
std::optional<Value> recorded_optional(const Json& result, const std::string& keys) {
  if (value_at(result, keys).is_null()) return std::nullopt;
  return recorded<Value>(result, keys);
}

/// [x, y]
Point recorded_point(const Json& result, const std::string& keys);

/// A number in its range. @throws UsageError
double recorded_real(const Json& result, const std::string& keys, double least, double most);
std::int64_t recorded_integer(const Json& result, const std::string& keys, std::int64_t least,
                              std::int64_t most);

/// True for a plan of a vehicle.
bool of_vehicle(const Json& result);

/// The seed, a whole number in its range.
std::uint64_t recorded_seed(const Json& result);

}  // namespace lasius::tool
