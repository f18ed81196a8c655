#include "tools/polygon/polygon_report.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "lasius/version.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

Json settings_json(const PreparedWorld& world, const PolygonCommand& command,
                   const polygon::Params& parameters) {
  Json object =
      parameters_json(polygon::find_algorithm(parameters.algorithm()),
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
  json["algorithm"] = answer.parameters.algorithm();
  json["start"] = point(answer.start);
  json["goal"] = point(answer.goal);
  json["seed"] = answer.parameters.seed;
  json["threads"] = answer.parameters.threads;
  json["parameters"] = settings_json(world, command, answer.parameters);
  json["status"] = to_string(result.status);
  json["error"] = result.error.empty() ? Json(nullptr) : Json(result.error);
  json["length"] = number(result.length);
  json["path"] = points(result.path);
  add_search(json, result);
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
