#include "report.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "lasius/params.h"
#include "lasius/path.h"
#include "lasius/version.h"
#include "parameters.h"
#include "values.h"

namespace lasius::tool {
namespace {

Json optional_number(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json points(const std::vector<Point>& path) {
  if (path.empty()) return nullptr;
  Json list = Json::array();
  for (const Point p : path) list.push_back(Json::array({number(p.x), number(p.y)}));
  return list;
}

/// All that decides a result beside map, question and seed: enough to replay it.
Json parameters(const PreparedMap& map, const RunOptions& run) {
  Json object = Json::object();
  for (const auto& parameter : find_algorithm(run.params.algorithm).parameters)
    object[std::string(parameter.name)] = parameter_json(get_parameter(run.params, parameter.name));
  object["target_gap"] = number(run.target_gap);
  object["time_limit"] = optional_number(run.time_limit);
  object["radius"] = number(map.radius);
  object["unknown"] = map.unknown_is_free ? "free" : "blocked";
  object["frame"] = run.frame == Frame::world ? "world" : "cell";
  return object;
}

/// (length - optimum) / optimum; 0 at length 0; null where either is missing.
Json true_gap(const Answer& answer) {
  const double length = answer.result.length;
  if (!answer.optimum || std::isnan(length)) return nullptr;
  return number(*answer.optimum > 0 ? (length - *answer.optimum) / *answer.optimum : 0.0);
}

}  // namespace

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json parameter_json(const std::string& text) {
  if (const auto integer = parse_integer(text)) return *integer;
  if (const auto real = parse_real(text)) return *real;
  return text;
}

std::string parameter_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? to_text(value.get<double>()) : value.dump();
}

std::string hash_text(std::uint64_t hash) {
  std::array<char, 17> digits;
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
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
  json["algorithm"] = run.params.algorithm;
  json["start"] = {answer.start.x, answer.start.y};
  json["goal"] = {answer.goal.x, answer.goal.y};
  json["seed"] = run.params.seed;
  json["threads"] = run.params.threads;
  json["parameters"] = parameters(map, run);
  json["status"] = to_string(result.status);
  const bool failed = result.status == Status::invalid || result.status == Status::unreachable;
  json["error"] = failed ? Json(explain(map, run, answer)) : Json(nullptr);
  json["length"] = number(result.length);
  json["path"] = points(result.path);
  if (run.frame == Frame::world) {
    json["length_m"] = number(map.metres(result.length));
    json["path_world"] = points(map.to_world(result.path));
  }
  json["iterations"] = result.iterations;
  json["best"] = numbers(result.best);
  json["mean"] = numbers(result.mean);
  json["arrived"] = result.arrived;
  json["lower_bound"] = optional_number(result.lower_bound);
  json["gap"] = optional_number(result.gap());
  json["optimal"] = result.optimal;
  if (run.with_optimum) {
    json["optimum"] = optional_number(answer.optimum);
    json["optimum_gap"] = true_gap(answer);
    json["grid_optimum"] = optional_number(answer.grid_optimum);
  }
  json["elapsed_ms"] = number(answer.elapsed_ms);
  return json;
}

std::string line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json range_json(const Parameter& parameter) {
  Json json = {{"type", parameter.type}};
  const std::string_view range = parameter.range;
  if (const auto dots = range.find(" .. "); dots != std::string_view::npos) {
    json["minimum"] = parameter_json(std::string(range.substr(0, dots)));
    json["maximum"] = parameter_json(std::string(range.substr(dots + 4)));
    return json;
  }
  json["values"] = Json::array();
  for (std::size_t from = 0; from <= range.size();) {
    const auto bar = std::min(range.find('|', from), range.size());
    json["values"].push_back(parameter_json(std::string(range.substr(from, bar - from))));
    from = bar + 1;
  }
  return json;
}

}  // namespace lasius::tool
