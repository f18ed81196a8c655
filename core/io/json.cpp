#include "lasius/io/json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "core/base/special_values.h"
#include "core/io/json_values.h"
#include "lasius/base/error.h"

namespace lasius {
namespace {

using json::Json;

Error broken(const std::string& problem) {
  return Error(ErrorCode::file_broken, "the JSON text " + problem,
               "give what params_to_json or result_to_json wrote, or `lasius plan --json` printed");
}

Json read_object(std::string_view text) {
  Json object = json::read(text, "the JSON text");
  if (!object.is_object()) throw broken("is not an object");
  return object;
}

/// A whole number that the type holds?
template <class Whole>
bool fits(const Json& value) {
  if (value.is_number_unsigned()) return std::in_range<Whole>(value.get<std::uint64_t>());
  return value.is_number_integer() && std::in_range<Whole>(value.get<std::int64_t>());
}

/// Whole numbers, each as wide as the type.
template <class Integer = int>
std::vector<Integer> whole_numbers(const Json& object, const std::string& key) {
  const Json list = object.value(key, Json());
  const bool good = list.is_array() && std::ranges::all_of(list, fits<Integer>);
  if (!good) throw broken("holds \"" + key + "\": " + json::dumped(list));
  return list.get<std::vector<Integer>>();
}

/// A member as a value of C++.
template <class Value>
Value member(const Json& object, const std::string& key) {
  if (!object.contains(key)) throw broken("lacks \"" + key + "\"");
  constexpr bool kWhole = std::is_integral_v<Value> && !std::is_same_v<Value, bool>;
  const Json& value = object[key];
  try {
    if constexpr (kWhole) {
      if (fits<Value>(value)) return value.get<Value>();
    } else {
      return value.get<Value>();
    }
  } catch (const Json::exception&) {
  }
  throw broken("holds \"" + key + "\": " + json::dumped(value));
}

/// A member's value; `otherwise` where it is missing or null.
template <class Value>
Value member_or(const Json& object, const std::string& key, Value otherwise) {
  if (!object.contains(key) || object[key].is_null()) return otherwise;
  return member<Value>(object, key);
}

/// Numbers, of which some may be null: not a number.
std::vector<double> curve(const Json& object, const std::string& key) {
  std::vector<double> values;
  for (const Json& value : member<std::vector<Json>>(object, key)) {
    if (!value.is_null() && !value.is_number())
      throw broken("holds \"" + key + "\": " + json::dumped(value));
    values.push_back(value.is_null() ? kNaN : value.get<double>());
  }
  return values;
}

/// The path of a result or an alternative; none where it is null.
std::vector<Point> path_of(const Json& object) {
  std::vector<Point> path;
  for (const auto& point : member_or(object, "path", std::vector<std::vector<double>>())) {
    if (point.size() != 2) throw broken("holds a vertex of the path that is no point");
    path.push_back({point[0], point[1]});
  }
  return path;
}

/// The value of an enum that to_string names so.
template <class Enum>
Enum named(const Json& object, const std::string& key, Enum last) {
  const auto name = member<std::string>(object, key);
  for (int i = 0; i <= static_cast<int>(last); ++i)
    if (to_string(static_cast<Enum>(i)) == name) return static_cast<Enum>(i);
  throw broken("holds \"" + key + "\": \"" + name + "\"");
}

/// Of a question, which the program keeps beside the parameters.
bool is_setting(std::string_view name) {
  constexpr std::array<std::string_view, 12> kSettings{
      "target_gap", "time_limit", "radius", "spacing", "goal_tolerance", "unknown",
      "ends",       "inflation",  "moves",  "prepare", "frame",          "alternatives"};
  return std::ranges::find(kSettings, name) != kSettings.end();
}

}  // namespace

std::string params_to_json(const Params& params) {
  Json object = {
      {"algorithm", params.algorithm()}, {"seed", params.seed}, {"threads", params.threads}};
  object["parameters"] =
      json::parameters(find_algorithm(params.algorithm()),
                       [&](std::string_view name) { return get_parameter(params, name); });
  return json::line(object);
}

Params params_from_json(std::string_view text) {
  const Json object = read_object(text);
  Params params(member<std::string>(object, "algorithm"));
  params.seed = member_or(object, "seed", params.seed);
  params.threads = member_or(object, "threads", params.threads);
  const Json values = member_or(object, "parameters", Json(Json::object()));
  if (!values.is_object()) throw broken("holds \"parameters\": " + json::dumped(values));
  for (const auto& [name, value] : values.items())
    if (!is_setting(name)) set_parameter(params, name, json::parameter_text(value));
  validate(params);
  return params;
}

namespace {
/// Of a result: the cells that it may have.
constexpr std::pair<const char*, std::optional<Cell> Result::*> kCells[] = {
    {"goal_reached", &Result::goal_reached},
    {"nearest_free", &Result::nearest_free},
    {"nearest_reachable", &Result::nearest_reachable}};
}  // namespace

std::string result_to_json(const Result& result) {
  Json object = {{"status", to_string(result.status)},
                 {"error", json::text_or_null(result.error)},
                 {"length", json::number(result.length)},
                 {"path", json::points(result.path)}};
  json::add_convergence(object, result.curves);
  json::add_proof(object, result);
  if (result.fault != Fault::none) object["fault"] = to_string(result.fault);
  if (result.own_rules) object["own_rules"] = true;
  if (result.way_out) object["way_out"] = json::point(*result.way_out);
  for (const Alternative& other : result.alternatives)
    object["alternatives"].push_back(
        {{"length", json::number(other.length)}, {"path", json::points(other.path)}});
  for (const auto& [name, cell] : kCells)
    if (const auto& c = result.*cell) object[name] = {c->x, c->y};
  return json::line(object);
}

Result result_from_json(std::string_view text) {
  const Json object = read_object(text);
  Result result;
  result.status = named(object, "status", Status::invalid);
  if (result.status == Status::limit) result.limit = Limit::time;  // the only one on bitmaps
  result.error = member_or(object, "error", std::string());
  result.length = member_or(object, "length", result.length);
  result.path = path_of(object);
  for (const Json& other : member_or(object, "alternatives", std::vector<Json>())) {
    if (!other.is_object()) throw broken("holds an alternative that is no object");
    result.alternatives.push_back({path_of(other), member<double>(other, "length")});
  }
  result.curves.iterations = member<int>(object, "iterations");
  result.curves.best = curve(object, "best");
  result.curves.mean = curve(object, "mean");
  result.curves.arrived = whole_numbers(object, "arrived");
  if (object.contains("steps")) {  // a colony's
    result.curves.raw_best = curve(object, "raw_best");
    result.curves.cut_mean = curve(object, "cut_mean");
    result.curves.cut_best = curve(object, "cut_best");
    result.curves.steps = whole_numbers<std::int64_t>(object, "steps");
    result.curves.band = curve(object, "band");
    result.curves.trail_entropy = curve(object, "trail_entropy");
  }
  if (object.contains("iteration_best"))
    result.curves.iteration_best = curve(object, "iteration_best");
  if (!member<Json>(object, "lower_bound").is_null())
    result.lower_bound = member<double>(object, "lower_bound");
  result.optimal = member<bool>(object, "optimal");
  if (object.contains("fault")) result.fault = named(object, "fault", Fault::trapped);
  result.own_rules = member_or(object, "own_rules", false);
  const auto pair = [&](const std::string& name) -> std::optional<Point> {
    if (!object.contains(name) || object[name].is_null()) return std::nullopt;
    const auto numbers = member<std::vector<double>>(object, name);
    const auto on_a_map = [](double number) { return std::abs(number) < 0x1p31; };
    if (numbers.size() != 2 || !std::ranges::all_of(numbers, on_a_map))
      throw broken("holds \"" + name + "\" that is no place of a map");
    return Point{numbers[0], numbers[1]};
  };
  result.way_out = pair("way_out");
  for (const auto& [name, to] : kCells) {
    const auto at = pair(name);
    if (!at) continue;
    const Cell cell{static_cast<int>(std::floor(at->x)), static_cast<int>(std::floor(at->y))};
    const bool whole = cell.x == at->x && cell.y == at->y;
    if (!whole && to != &Result::goal_reached)  // which may be a point of its cell
      throw broken(std::string("holds \"") + name + "\" that is no cell");
    result.*to = cell;
  }
  return result;
}

}  // namespace lasius
