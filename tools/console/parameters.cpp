#include "tools/console/parameters.h"

#include <algorithm>
#include <array>

#include "core/base/did_you_mean.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"

namespace lasius::tool {

namespace {

std::string list_of(const Algorithm& algorithm) {
  return "`lasius algorithms " + std::string(algorithm.name) + "` lists all";
}

}  // namespace

bool moves_on_cells(const Params& params) {
  return find_algorithm(params.algorithm()).kind != Algorithm::Kind::exact;
}

bool squeezes(const Params& params) {
  return moves_on_cells(params) && params.corners == Corners::allow &&
         params.neighbours != Neighbours::four;
}

std::pair<std::string_view, std::string_view> setting_of(std::string_view setting,
                                                         const Algorithm& algorithm,
                                                         std::span<const Algorithm> all) {
  const std::string told = "--set " + std::string(setting) + ": ";
  const auto equals = setting.find('=');
  if (equals == std::string_view::npos) throw UsageError(told + "not of the form NAME=VALUE");
  const auto name = setting.substr(0, equals);
  constexpr std::array<std::string_view, 8> kOptions{
      "seed", "threads", "time-limit", "target-gap", "margin", "join", "boundary", "radius"};
  std::string option(name);
  std::ranges::replace(option, '_', '-');
  if (std::ranges::find(kOptions, option) != kOptions.end() && !algorithm.has(name))
    throw UsageError(told + "this is an option, --" + option);
  const auto value = setting.substr(equals + 1);
  if (name == "rho") return {name, value};  // refused with both its meanings
  if (algorithm.has(name)) return {name, value};
  const auto unknown =
      told + std::string(algorithm.name) + " has no parameter \"" + std::string(name) + "\"; ";
  if (!algorithm.parameters.empty())
    throw UsageError(unknown + did_you_mean(name, algorithm.parameters, list_of(algorithm)));
  // One that needs none was meant for another.
  auto other = std::ranges::find_if(all, [&](const Algorithm& a) { return a.has(name); });
  const bool known = other != all.end();
  if (!known)
    other =
        std::ranges::find_if_not(all, &std::span<const Parameter>::empty, &Algorithm::parameters);
  throw UsageError(unknown + "it takes none. " +
                   (known ? "One that has it: --algorithm " + std::string(other->name)
                          : "With --algorithm " + std::string(other->name) + ": " +
                                did_you_mean(name, other->parameters, list_of(*other))));
}

void refuse_repeats(std::span<const std::string> settings) {
  const auto name_of = [](std::string_view setting) {
    return parameter_meant_by(setting.substr(0, setting.find('=')));
  };
  for (auto later = settings.begin(); later != settings.end(); ++later) {
    const auto before = std::ranges::find(settings.begin(), later, name_of(*later), name_of);
    if (before != later)
      throw UsageError("--set " + *before + ", --set " + *later + ": " +
                       std::string(name_of(*later)) + " is given more than once");
  }
}

}  // namespace lasius::tool
