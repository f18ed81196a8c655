// Parameters of algorithms by name, from the command line.
#pragma once

#include <algorithm>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lasius/params/params.h"
#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// Names of algorithms or of parameters.
template <class Named>
std::vector<std::string_view> names_of(std::span<const Named> things) {
  std::vector<std::string_view> names;
  for (const Named& thing : things) names.push_back(thing.name);
  return names;
}

/// True where the algorithm moves from cell to cell.
bool moves_on_cells(const Params& params);

/// True where it may squeeze between blocked cells, where no path of the plane may.
bool squeezes(const Params& params);

/// Name and value of --set "NAME=VALUE", which `algorithm` has. @throws UsageError for anything
/// else: another form, an option of its own, an unknown name, with the nearest.
std::pair<std::string_view, std::string_view> setting_of(std::string_view setting,
                                                         const Algorithm& algorithm,
                                                         std::span<const Algorithm> all);

/// @throws UsageError where two of --set are of one parameter.
void refuse_repeats(std::span<const std::string> settings);

/// The values that an algorithm has until it is told others. @throws UsageError or Error for a
/// preset that it does not have.
template <class Params>
Params params_of(std::string_view algorithm, Preset preset = Preset::usual) {
  if constexpr (std::constructible_from<Params, std::string_view, Preset>) {
    return Params(algorithm, preset);
  } else {
    if (preset != Preset::usual)
      throw UsageError("--preset " + std::string(to_string(preset)) + ": " +
                       std::string(algorithm) +
                       " has none; see lasius algorithms for those that have");
    return Params(algorithm);
  }
}

/// Holds a value that has no effect against what another algorithm takes.
template <class Params>
void check_elsewhere(std::span<const Algorithm> all, const std::string& name,
                     const std::string& value) {
  const auto other = std::ranges::find_if(all, [&](const auto& a) { return a.has(name); });
  if (other != all.end()) {
    auto scratch = params_of<Params>(other->name);
    set_parameter(scratch, name, value);
  } else {
    lasius::Params scratch;
    set_parameter(scratch, name, value);
  }
}

/// Says in the options which of the parameters that were asked for the others leave unread.
template <class Params>
void note_unread(SearchOptions& options, const Params& params, const Algorithm& algorithm) {
  if constexpr (requires { why_unread(params, std::string_view()); }) {
    const auto note = [&](const std::string& told, std::string_view name) {
      const std::string why = why_unread(params, name);
      if (!why.empty()) options.notes.push_back(told + " has no effect: " + why);
    };
    for (const auto& [name, value] : options.preset_settings)
      note("the preset's " + name + "=" + value, name);
    for (const auto& [name, value] : options.named)
      if (algorithm.has(name)) note("--" + name, name);
    for (const auto& setting : options.settings)
      note("--set " + setting, std::string_view(setting).substr(0, setting.find('=')));
  }
}

/// The parameters that were asked for, for a plan: those that are not read have their defaults.
/// Tells in the options what was asked for, and what of it has no effect.
/// @throws UsageError for unknown names, with the nearest; Error(invalid_parameter) for values.
template <class Params>
Params make_params(SearchOptions& options, const ProblemKind& kind) {
  const Algorithm& algorithm =
      *std::ranges::find(kind.algorithms, algorithm_of(kind, options.algorithm), &Algorithm::name);
  auto params = params_of<Params>(algorithm.name, options.preset);
  for (const auto& [name, value] : options.preset_settings) set_parameter(params, name, value);
  for (const auto& [name, value] : options.named) {
    if (algorithm.has(name)) {
      set_parameter(params, name, value);
      continue;
    }
    check_elsewhere<Params>(kind.algorithms, name, value);
    options.notes.push_back("--" + name + " has no effect: " + std::string(algorithm.name) +
                            " has no such parameter");
  }
  for (const auto& setting : options.settings) {
    const auto [name, value] = setting_of(setting, algorithm, kind.algorithms);
    set_parameter(params, name, value);
  }
  for (const Parameter& parameter : algorithm.parameters)
    options.asked[std::string(parameter.name)] = get_parameter(params, parameter.name);
  note_unread(options, params, algorithm);
  if constexpr (std::same_as<Params, lasius::Params>) reset_unread(params);
  params.seed = options.seed;
  params.threads = options.threads;
  validate(params);
  return params;
}

// Of ProblemKind: an algorithm's values until it is told others, and its formulas.
template <class Params>
std::string default_text(const Algorithm& algorithm, std::string_view parameter, Preset preset) {
  const bool has = std::same_as<Params, lasius::Params> && has_preset(algorithm.name, preset);
  return get_parameter(params_of<Params>(algorithm.name, has ? preset : Preset::usual), parameter);
}
template <class Params>
std::vector<std::string> formulas_of(const Algorithm& algorithm) {
  return formulas(Params(algorithm.name));
}

}  // namespace lasius::tool
