#include "polygon_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "elapsed.h"
#include "exit_code.h"
#include "lasius/error.h"
#include "lasius/version.h"
#include "parameters.h"
#include "values.h"

namespace lasius::tool {
namespace {

Json settings_json(const PreparedWorld& world, const PolygonCommand& command,
                   const polygon::Parameters& parameters) {
  Json object =
      parameters_json(find_algorithm(polygon::algorithms(), parameters.algorithm),
                      [&](std::string_view name) { return get_parameter(parameters, name); });
  object["target_gap"] = number(command.target_gap);
  object["time_limit"] = optional_number(command.time_limit);
  object["margin"] = number(world.planner.margin());
  object["join"] = kJoins[static_cast<std::size_t>(world.planner.join())];
  object["repair"] = world.repair;
  return object;
}

Json crossing_length(const std::optional<polygon::Crossing>& crossing) {
  return crossing ? number(crossing->length) : Json(nullptr);
}

/// What the graph gave: sizes, the lines crossed, and the optima that bound the path.
Json maklink_json(const PreparedWorld& world, const polygon::Result& result) {
  const auto& graph = world.planner.maklink();
  Json json = {{"lines", graph.lines.size()},
               {"regions", graph.regions.size()},
               {"crossed", result.crossing.lines},
               {"values", numbers(result.crossing.values)},
               {"dijkstra_length", crossing_length(result.dijkstra)},
               {"dijkstra_path", result.dijkstra ? points(result.dijkstra->path) : Json(nullptr)},
               {"discrete_optimum", crossing_length(result.discrete_optimum)},
               {"sequence_optimum", crossing_length(result.sequence_optimum)}};
  return json;
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

polygon::Parameters polygon_parameters(const PolygonCommand& command,
                                       std::vector<std::string>& notes) {
  const auto all = polygon::algorithms();
  const auto known = names_of(all);
  const std::string name(command.algorithm.empty()
                             ? known.front()
                             : known[choice_value("--algorithm", command.algorithm, known)]);
  const Algorithm& algorithm = find_algorithm(all, name);
  auto parameters = polygon::defaults(name);
  for (const auto& [key, value] : command.named) {
    if (has_parameter(algorithm, key))
      set_parameter(parameters, key, value);
    else
      notes.push_back("--" + key + " has no effect: " + name + " has no such parameter");
  }
  for (const std::string& setting : command.settings) {
    const auto [key, value] = setting_parts(setting);
    if (!has_parameter(algorithm, key))
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
                             const polygon::Parameters& parameters, const StopCondition& stop,
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
        {.start = answer.start, .goal = answer.goal, .stop = {.token = stop.token}},
        polygon::defaults("exact"));
    if (best.optimal) answer.optimum = best.length;
  }
  return answer;
}

Json polygon_json(const PreparedWorld& world, const PolygonCommand& command,
                  const PolygonAnswer& answer) {
  const polygon::Result& result = answer.result;
  const Point low = world.low(), high = world.high();
  Json json = Json::object();
  json["format"] = kFormat;
  json["version"] = LASIUS_VERSION;
  json["map"] = {{"file", world.file},
                 {"hash", hash_text(world.hash)},
                 {"width", number(high.x - low.x)},
                 {"height", number(high.y - low.y)}};
  json["algorithm"] = answer.parameters.algorithm;
  json["start"] = point(answer.start);
  json["goal"] = point(answer.goal);
  json["seed"] = answer.parameters.seed;
  json["threads"] = answer.parameters.threads;
  json["parameters"] = settings_json(world, command, answer.parameters);
  json["status"] = to_string(result.status);
  json["error"] = result.error.empty() ? Json(nullptr) : Json(result.error);
  json["length"] = number(result.length);
  json["path"] = points(result.path);
  json["iterations"] = result.iterations;
  json["best"] = numbers(result.best);
  json["mean"] = numbers(result.mean);
  json["arrived"] = result.arrived;
  json["lower_bound"] = optional_number(result.lower_bound);
  json["gap"] = optional_number(result.gap());
  json["optimal"] = result.optimal;
  if (command.with_optimum) {
    json["optimum"] = optional_number(answer.optimum);
    json["optimum_gap"] = gap_to(answer.optimum, result.length);
  }
  json["maklink"] = maklink_json(world, result);
  json["elapsed_ms"] = number(answer.elapsed_ms);
  return json;
}

std::string polygon_text(const PolygonAnswer& answer) {
  std::ostringstream out;
  out << to_string(answer.result.status) << "\n";
  if (answer.result.path.empty()) return out.str();
  out << to_text(answer.result.length) << "\n";
  for (const Point p : answer.result.path) out << to_text(p.x) << " " << to_text(p.y) << "\n";
  return out.str();
}

}  // namespace lasius::tool
