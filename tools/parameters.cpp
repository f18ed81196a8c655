#include "parameters.h"

#include <algorithm>
#include <string>

#include "exit_code.h"
#include "values.h"

namespace lasius::tool {

bool has_parameter(const Algorithm& algorithm, std::string_view name) {
  return std::any_of(algorithm.parameters.begin(), algorithm.parameters.end(),
                     [name](const Parameter& parameter) { return parameter.name == name; });
}

Params default_params(std::string_view name) {
  if (name.empty()) return defaults(algorithms().front().name);
  if (name == "goritov2020")
    throw UsageError("--algorithm: goritov2020 plans for arms, not on maps; use `lasius arm`");
  const auto known = names_of(algorithms());
  return defaults(known[choice_value("--algorithm", name, known)]);
}

const Algorithm& find_algorithm(std::span<const Algorithm> all, std::string_view name) {
  return *std::find_if(all.begin(), all.end(),
                       [name](const Algorithm& algorithm) { return algorithm.name == name; });
}

const Algorithm& find_algorithm(std::string_view name) {
  return find_algorithm(algorithms(), name);
}

bool set_common(Params& params, std::string_view name, std::string_view value) {
  set_parameter(params, name, value);
  return has_parameter(find_algorithm(params.algorithm), name);
}

std::pair<std::string_view, std::string_view> setting_parts(std::string_view setting) {
  const auto equals = setting.find('=');
  if (equals == std::string_view::npos)
    throw UsageError("--set " + std::string(setting) + ": not of the form NAME=VALUE");
  return {setting.substr(0, equals), setting.substr(equals + 1)};
}

void set_named(Params& params, std::string_view setting) {
  const auto [name, value] = setting_parts(setting);
  const auto& algorithm = find_algorithm(params.algorithm);
  if (!has_parameter(algorithm, name)) {
    const auto unknown = "--set " + std::string(setting) + ": " + params.algorithm +
                         " has no parameter \"" + std::string(name) + "\"; ";
    if (!algorithm.parameters.empty())
      throw UsageError(unknown + did_you_mean(name, names_of(algorithm.parameters)));
    // One that needs none was meant for another.
    const Algorithm& other = algorithms()[1];
    throw UsageError(unknown + "it takes none. " + std::string(other.name) +
                     " has: " + did_you_mean(name, names_of(other.parameters)));
  }
  set_parameter(params, name, value);
}

}  // namespace lasius::tool
