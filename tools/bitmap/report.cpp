#include "tools/bitmap/report.h"

#include <nlohmann/json.hpp>

#include "lasius/params.h"
#include "lasius/version.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

/// All that decides a result beside map, question and seed: enough to replay it.
Json settings_json(const PreparedMap& map, const RunOptions& run) {
  Json object = parameters_json(find_algorithm(run.params.algorithm()), [&](std::string_view name) {
    return get_parameter(run.params, name);
  });
  object["target_gap"] = number(run.target_gap);
  object["time_limit"] = optional_number(run.time_limit);
  object["radius"] = number(map.radius);
  object["unknown"] = map.unknown_is_free ? "free" : "blocked";
  if (map.prepare) object["prepare"] = true;
  object["frame"] = run.frame == Frame::world ? "world" : "cell";
  return object;
}

Json cell_json(const Place& place) {
  const auto [x, y] = place.number;
  return Json::array({parameter_json(whole_text(x)), parameter_json(whole_text(y))});
}

}  // namespace

void add_search(Json& json, const SearchResult& result) {
  json["iterations"] = result.iterations;
  json["best"] = numbers(result.best);
  json["mean"] = numbers(result.mean);
  json["arrived"] = result.arrived;
  json["lower_bound"] = optional_number(result.lower_bound);
  json["gap"] = optional_number(result.gap());
  json["optimal"] = result.optimal;
}

Json result_json(const PreparedMap& map, const RunOptions& run, const Answer& answer) {
  const Result& result = answer.result;
  Json json = Json::object();
  json["format"] = kFormat;
  json["version"] = LASIUS_VERSION;
  if (answer.index) json["index"] = *answer.index;
  json["map"] = {{"file", map.file},
                 {"hash", hash_text(map.hash)},
                 {"width", map.width},
                 {"height", map.height}};
  json["algorithm"] = run.params.algorithm();
  json["start"] = cell_json(answer.start);
  json["goal"] = cell_json(answer.goal);
  json["seed"] = run.params.seed;
  json["threads"] = run.params.threads;
  json["parameters"] = settings_json(map, run);
  json["status"] = to_string(result.status);
  const bool failed = result.status == Status::invalid || result.status == Status::unreachable;
  json["error"] = failed ? Json(explain(outcome(map, run, answer))) : Json(nullptr);
  json["length"] = number(result.length);
  json["path"] = points(result.path);
  if (run.frame == Frame::world) {
    json["start_world"] = point(answer.start.asked);
    json["goal_world"] = point(answer.goal.asked);
    json["length_m"] = number(map.metres(result.length));
    json["path_world"] = points(map.to_world(result.path));
  }
  add_search(json, result);
  if (run.with_optimum) {
    json["optimum"] = optional_number(answer.optimum);
    json["optimum_gap"] = gap_to(answer.optimum, result.length);
    json["grid_optimum"] = optional_number(answer.grid_optimum);
  }
  json["elapsed_ms"] = number(answer.elapsed_ms);
  return json;
}

}  // namespace lasius::tool
