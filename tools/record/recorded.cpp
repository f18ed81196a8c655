#include "tools/record/recorded.h"

#include <algorithm>
#include <array>

#include "tools/console/values.h"

namespace lasius::tool {

const Json& value_at(const Json& result, const std::string& keys) {
  const Json* value = &result;
  for (std::size_t from = 0; from <= keys.size();) {
    const auto to = std::min(keys.find('/', from), keys.size());
    const std::string key = keys.substr(from, to - from);
    if (!value->is_object() || !value->contains(key))
      throw UsageError("it lacks an input of its run, \"" + keys.substr(0, to) + "\"");
    value = &(*value)[key];
    from = to + 1;
  }
  return *value;
}

Point recorded_point(const Json& result, const std::string& keys) {
  const auto [x, y] = recorded<std::array<double, 2>>(result, keys);
  return {x, y};
}

double recorded_real(const Json& result, const std::string& keys, double least, double most) {
  return real_value("\"" + keys + "\"", dumped(value_at(result, keys)), least, most);
}

std::int64_t recorded_integer(const Json& result, const std::string& keys, std::int64_t least,
                              std::int64_t most) {
  return integer_value("\"" + keys + "\"", dumped(value_at(result, keys)), least, most);
}

std::uint64_t recorded_seed(const Json& result) {
  return static_cast<std::uint64_t>(recorded_integer(result, "seed", 0, kMaxExactInteger));
}

bool of_vehicle(const Json& result) {
  return result.contains("parameters") && result["parameters"].is_object() &&
         result["parameters"].contains("vehicle");
}

}  // namespace lasius::tool
