#include "tools/console/parameters.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/base/did_you_mean.h"
#include "tools/console/exit_code.h"
#ifdef LASIUS_WITH_POLYGON
#include "lasius/polygon_plan.h"
#endif
#include "tools/console/values.h"

namespace lasius::tool {

void refuse_elsewhere(std::string_view name, [[maybe_unused]] bool on_bitmap) {
  const std::string option = "--algorithm: " + std::string(name);
  if (name == "goritov2020")
    throw UsageError(option + " plans for arms, not on maps; use `lasius arm`");
#ifdef LASIUS_WITH_POLYGON
  const auto among = [name](std::span<const Algorithm> all) {
    const auto names = names_of(all);
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (on_bitmap && !among(algorithms()) && among(polygon::algorithms()))
    throw UsageError(option + " plans among polygons (.geojson, .json, .wkt), not on bitmaps");
  if (!on_bitmap && !among(polygon::algorithms()) && among(algorithms()))
    throw UsageError(option + " plans on bitmaps, not among polygons");
#endif
}

void refuse_option(std::string_view setting) {
  constexpr std::array<std::string_view, 4> kOptions{"seed", "threads", "time-limit", "target-gap"};
  std::string name(setting_parts(setting).first);
  std::replace(name.begin(), name.end(), '_', '-');
  if (std::find(kOptions.begin(), kOptions.end(), name) != kOptions.end())
    throw UsageError("--set " + std::string(setting) + ": this is an option, --" + name);
}

Params default_params(std::string_view name) {
  if (name.empty()) return defaults(algorithms().front().name);
  refuse_elsewhere(name, true);
  const auto known = names_of(algorithms());
  return defaults(known[choice_value("--algorithm", name, known)]);
}

bool set_common(Params& params, std::string_view name, std::string_view value) {
  Params read = params;
  set_parameter(read, name, value);
  if (!find_algorithm(params.algorithm()).has(name)) return false;
  params = read;
  return true;
}

std::pair<std::string_view, std::string_view> setting_parts(std::string_view setting) {
  const auto equals = setting.find('=');
  if (equals == std::string_view::npos)
    throw UsageError("--set " + std::string(setting) + ": not of the form NAME=VALUE");
  return {setting.substr(0, equals), setting.substr(equals + 1)};
}

void set_named(Params& params, std::string_view setting) {
  const auto [name, value] = setting_parts(setting);
  refuse_option(setting);
  const auto& algorithm = find_algorithm(params.algorithm());
  if (!algorithm.has(name)) {
    const auto unknown = "--set " + std::string(setting) + ": " + params.algorithm() +
                         " has no parameter \"" + std::string(name) + "\"; ";
    if (!algorithm.parameters.empty())
      throw UsageError(unknown + did_you_mean(name, names_of(algorithm.parameters)));
    // One that needs none was meant for another.
    const Algorithm& other = algorithms()[1];
    throw UsageError(unknown + "it takes none. With --algorithm " + std::string(other.name) + ": " +
                     did_you_mean(name, names_of(other.parameters)));
  }
  set_parameter(params, name, value);
}

}  // namespace lasius::tool
