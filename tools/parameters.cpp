#include "parameters.h"

#include <algorithm>
#include <vector>

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
  std::vector<std::string_view> known;
  for (const auto& algorithm : algorithms()) known.push_back(algorithm.name);
  return defaults(known[choice_value("--algorithm", name, known)]);
}

const Algorithm& find_algorithm(std::string_view name) {
  const auto all = algorithms();
  return *std::find_if(all.begin(), all.end(),
                       [name](const Algorithm& algorithm) { return algorithm.name == name; });
}

bool set_common(Params& params, std::string_view name, std::string_view value) {
  set_parameter(params, name, value);
  return has_parameter(find_algorithm(params.algorithm), name);
}

namespace {

std::vector<std::string_view> names_of(const Algorithm& algorithm) {
  std::vector<std::string_view> names;
  for (const auto& parameter : algorithm.parameters) names.push_back(parameter.name);
  return names;
}

}  // namespace

void set_named(Params& params, std::string_view setting) {
  const auto equals = setting.find('=');
  if (equals == std::string_view::npos)
    throw UsageError("--set " + std::string(setting) + ": not of the form NAME=VALUE");
  const auto name = setting.substr(0, equals);
  const auto& algorithm = find_algorithm(params.algorithm);
  if (!has_parameter(algorithm, name)) {
    const auto unknown = "--set " + std::string(setting) + ": " + params.algorithm +
                         " has no parameter \"" + std::string(name) + "\"; ";
    if (!algorithm.parameters.empty())
      throw UsageError(unknown + did_you_mean(name, names_of(algorithm)));
    // One that needs none was meant for another.
    const Algorithm& other = algorithms()[1];
    throw UsageError(unknown + "it takes none. " + std::string(other.name) +
                     " has: " + did_you_mean(name, names_of(other)));
  }
  set_parameter(params, name, setting.substr(equals + 1));
}

}  // namespace lasius::tool
