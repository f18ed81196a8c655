#include "tools/polygon/polygon_answer.h"

#include <algorithm>

#include "core/base/did_you_mean.h"
#include "lasius/error.h"
#include "tools/bitmap/answer.h"
#include "tools/console/elapsed.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

static_assert(WorldOptions::kMostMargin == polygon::GrowOptions::kMostMargin);

/// A value that has no effect is held against what another algorithm takes.
void check_elsewhere(const std::string& key, const std::string& value) {
  for (const Algorithm& algorithm : polygon::algorithms()) {
    if (!algorithm.has(key)) continue;
    auto scratch = polygon::defaults(algorithm.name);
    return polygon::set_parameter(scratch, key, value);
  }
  Params scratch;
  lasius::set_parameter(scratch, key, value);
}

}  // namespace

Point PreparedWorld::low() const {
  Point p = planner.world().boundary.outer.front();
  for (const Point q : planner.world().boundary.outer) p = {std::min(p.x, q.x), std::min(p.y, q.y)};
  return p;
}

Point PreparedWorld::high() const {
  Point p = planner.world().boundary.outer.front();
  for (const Point q : planner.world().boundary.outer) p = {std::max(p.x, q.x), std::max(p.y, q.y)};
  return p;
}

PreparedWorld prepare_world(const WorldOptions& options) {
  const auto start = Clock::now();
  const polygon::World world = polygon::read_world(options.file, {.repair = options.repair});
  const double read_ms = ms_since(start);
  const auto prepare_start = Clock::now();
  const auto make = [&] {
    try {
      return polygon::Planner(
          world, {.margin = options.margin, .join = static_cast<polygon::Join>(options.join)});
    } catch (const Error& fault) {
      throw Error(ErrorCode::file_broken, {.file = options.file}, fault.problem(), fault.remedy());
    }
  };
  polygon::Planner planner = make();
  return {.file = options.file,
          .repair = options.repair,
          .hash = polygon::hash(world),
          .planner = std::move(planner),
          .read_ms = read_ms,
          .prepare_ms = ms_since(prepare_start)};
}

polygon::Params polygon_parameters(const PolygonCommand& command, std::vector<std::string>& notes) {
  const auto all = polygon::algorithms();
  const auto known = names_of(all);
  refuse_elsewhere(command.algorithm, false);
  const std::string name(command.algorithm.empty()
                             ? known.front()
                             : known[choice_value("--algorithm", command.algorithm, known)]);
  const Algorithm& algorithm = polygon::find_algorithm(name);
  auto parameters = polygon::defaults(name);
  for (const auto& [key, value] : command.named) {
    if (algorithm.has(key)) {
      set_parameter(parameters, key, value);
      continue;
    }
    check_elsewhere(key, value);
    notes.push_back("--" + key + " has no effect: " + name + " has no such parameter");
  }
  for (const std::string& setting : command.settings) {
    refuse_option(setting);
    const auto [key, value] = setting_parts(setting);
    if (!algorithm.has(key))
      throw UsageError(
          "--set " + setting + ": " + name + " has no parameter \"" + std::string(key) + "\"; " +
          (algorithm.parameters.empty() ? "it takes none"
                                        : did_you_mean(key, names_of(algorithm.parameters))));
    set_parameter(parameters, key, value);
  }
  parameters.seed = command.seed;
  parameters.threads = command.threads;
  polygon::validate(parameters);
  return parameters;
}

PolygonAnswer polygon_answer(const PreparedWorld& world, const PolygonCommand& command,
                             const polygon::Params& parameters, const StopCondition& stop,
                             const polygon::Observer& observer) {
  const auto begin = Clock::now();
  PolygonAnswer answer{.parameters = parameters,
                       .start = *(command.start ? command.start : world.planner.world().start),
                       .goal = *(command.goal ? command.goal : world.planner.world().goal),
                       .result = {},
                       .optimum = {}};
  answer.result = world.planner.plan(
      {.start = answer.start, .goal = answer.goal, .stop = stop, .target_gap = command.target_gap},
      parameters, observer);
  answer.elapsed_ms = ms_since(begin);
  if (command.with_optimum) {
    const auto best = world.planner.plan(
        {.start = answer.start, .goal = answer.goal, .stop = again(stop, command.time_limit)},
        polygon::defaults("exact"));
    if (best.optimal) answer.optimum = best.length;
  }
  return answer;
}

}  // namespace lasius::tool
