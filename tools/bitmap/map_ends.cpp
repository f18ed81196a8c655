#include "tools/bitmap/map_ends.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/nearest_text.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/poses_file.h"
#include "tools/bitmap/reasons.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

/// An invalid end is the start.
bool at_start(const MapEnds& ends) {
  return ends.fault == Fault::start_blocked || ends.fault == Fault::start_outside;
}

const Place& invalid_end(const MapEnds& ends) { return at_start(ends) ? ends.start : ends.goal; }

/// A cell, with its metres where those are in use.
std::string name_of(const MapEnds& ends, Cell cell) {
  return spot_text(ends.map, ends.run.frame, centre(cell));
}

/// How far a place is from the goal, in cells.
double from_goal(const MapEnds& ends, Point at) {
  const Point goal = ends.goal.at();
  return std::hypot(at.x - goal.x, at.y - goal.y);
}

/// In cells.
double goal_tolerance(const MapEnds& ends) {
  return request_of(ends.map, ends.run, ends.start, ends.goal).goal_tolerance;
}

/// Of a goal that is out of reach and what is out of its tolerance.
std::string tolerance_text(const MapEnds& ends) {
  const auto& nearest = ends.nearest_reachable;
  if (!(ends.run.goal_tolerance > 0) || !nearest || at_start(ends)) return {};
  const auto length = [&](double cells) { return length_text(ends.map, ends.run.frame, cells); };
  return "; the nearest cell that can be reached, " + name_of(ends, *nearest) + ", is " +
         length(from_goal(ends, centre(*nearest))) + " from the goal, the tolerance is " +
         length(goal_tolerance(ends));
}

std::string invalid_text(const MapEnds& ends) {
  const LoadedMap& map = ends.map;
  const Frame frame = ends.run.frame;
  const bool bad_start = at_start(ends);
  const Place& place = invalid_end(ends);
  const std::string text = (bad_start ? "start " : "goal ") + place_text(place, frame) +
                           obstruction_text(map, frame, obstruction_of(map, place, ends.curved()));
  if (!ends.nearest_free)
    return map.grid().count_free() == 0 ? text + "; the map has no free cell" : text;
  const auto& reachable = ends.nearest_reachable;
  return text +
         nearest_text(bad_start, name_of(ends, *ends.nearest_free),
                      reachable ? std::optional(name_of(ends, *reachable)) : std::nullopt) +
         (bad_start || ends.run.goal_tolerance > 0 || !reachable
              ? ""
              : "; --goal-tolerance lets a path end near the goal");
}

std::string error_text(const MapEnds& ends) {
  const Frame frame = ends.run.frame;
  if (!ends.run.via.empty() && (ends.bad_via || ends.status != Status::invalid)) return ends.error;
  if (ends.status == Status::invalid)
    return invalid_text(ends) + tolerance_text(ends) +
           (ends.remedy != nullptr ? remedy_text(ends.map, frame, *ends.remedy) : "") +
           metres_hint(ends.map, frame, invalid_end(ends));
  std::string text = ends.error;
  if (ends.status != Status::unreachable) return text;
  if (ends.remedy != nullptr)
    text = "start " + place_text(ends.start, frame) + " and goal " + place_text(ends.goal, frame) +
           " lie in different regions of free cells";
  if (ends.map.radius > 0)  // why cells that look free are not
    text += (ends.curved() ? " (for a disc of radius "
                           : " (by walks over cells, for a disc of radius ") +
            length_text(ends.map, frame, ends.map.radius, 6) + ")";
  if (ends.remedy == nullptr) return text;
  return text + remedy_text(ends.map, frame, *ends.remedy) + tolerance_text(ends);
}

/// Where a path leads first, of a start that is too near to what is blocked.
std::string way_out_text(const MapEnds& ends) {
  const Frame frame = ends.run.frame;
  const Point from = ends.start.at(), out = *ends.way_out;
  return "start " + place_text(ends.start, frame) +
         obstruction_text(ends.map, frame, obstruction_of(ends.map, ends.start, ends.curved())) +
         "; the path first leads straight out to " + spot_text(ends.map, frame, out) + ", " +
         length_text(ends.map, frame, std::hypot(out.x - from.x, out.y - from.y)) + " away";
}

/// How far a path ends from its goal.
std::string short_of_goal(const MapEnds& ends) {
  const Frame frame = ends.run.frame;
  return "the path ends at " + spot_text(ends.map, frame, *ends.end) + ", " +
         length_text(ends.map, frame, from_goal(ends, *ends.end)) +
         " from the goal, which cannot be reached";
}

}  // namespace

Json map_json(const LoadedMap& map) {
  return {{"file", map.file},
          {"hash", hash_text(map.hash)},
          {"width", map.width},
          {"height", map.height}};
}

Json cell_json(const Place& place, bool in_metres) {
  if (place.point && !in_metres) return point(*place.point);
  const auto [x, y] = place.number;
  return Json::array({json::parameter(whole_text(x)), json::parameter(whole_text(y))});
}

bool MapEnds::curved() const { return route_of(map, run).curved; }

Record map_record(const MapEnds& ends, const SearchResult& result) {
  return map_record(ends, result, find_algorithm(ends.run.params.algorithm()));
}

Record map_record(const MapEnds& ends, const SearchResult& result, const Algorithm& algorithm) {
  const RunOptions& run = ends.run;
  Record record{.options = run,
                .algorithm = algorithm,
                .start = cell_json(ends.start, ends.in_metres()),
                .goal = cell_json(ends.goal, ends.in_metres()),
                .parameters = {},
                .result = result,
                .error = error_text(ends),
                .unit = ends.in_metres() ? "m" : "",
                .scale = ends.map.length_in(run.frame, 1)};
  Json& json = record.parameters = parameters_json(record.algorithm, run);
  add_limits(json, run);
  json["radius"] = number(ends.map.radius);
  json["unknown"] = ends.map.unknown_is_free ? "free" : "blocked";
  if (ends.map.prepare) json["prepare"] = ends.map.labels ? Json("labels") : Json(true);
  json["frame"] = kFrames[ends.in_metres() ? 1 : 0];
  if (ends.in_metres() && ends.start.point) json["ends"] = "points";
  if (run.goal_tolerance > 0) json["goal_tolerance"] = number(goal_tolerance(ends));
  if (run.spacing) json["spacing"] = number(spacing_of(ends.map, run));
  if (run.alternatives > 0) json["alternatives"] = run.alternatives;
  if (run.json || !record.has_path()) return record;
  if (auto hint = radius_hint(ends.map, run.frame); !hint.empty())
    record.remarks.push_back(std::move(hint));
  if (ends.way_out) record.remarks.push_back(way_out_text(ends));
  if (ends.end && *ends.end != ends.goal.at()) record.remarks.push_back(short_of_goal(ends));
  return record;
}

Json end_findings(const MapEnds& ends) {
  Json json = Json::object();
  if (ends.status == Status::invalid && !ends.bad_via &&
      (ends.map.unknown || ends.map.radius > 0)) {
    const auto why = obstruction_of(ends.map, invalid_end(ends), ends.curved());
    json["blocked_by"] = why.by.empty() ? "obstacle" : why.by;  // that a drive's map has not
    if (why.by == "radius") json["clearance"] = number(why.clearance);
  }
  if (ends.remedy != nullptr && ends.remedy->searched)
    json["widest_radius"] = optional_number(ends.remedy->widest_radius);
  return json;
}

void add_goal_reached(Json& json, const MapEnds& ends) {
  if (!(ends.run.goal_tolerance > 0)) return;
  const auto& cell = ends.reached;
  const auto& end = ends.end;
  const bool middle = cell && *end == centre(*cell);
  json["goal_reached"] = middle ? Json{cell->x, cell->y} : end ? point(*end) : Json();
  if (ends.in_metres()) json["goal_reached_world"] = end ? point(ends.map.to_world(*end)) : Json();
}

namespace {

/// A start, goal or stop: `in_cells` is a point where it has decimals, else a cell; `told` is how
/// it was given, which has the name `keys`.
End recorded_end(const Json& result, const Json& in_cells, const Json& told,
                 const std::string& keys) {
  const auto is_real = [](const Json& number) {  // cells that no map holds are told so, too
    return number.is_number_float() &&
           std::abs(number.get<double>()) < static_cast<double>(kMaxExactInteger);
  };
  // Before 0.4.0 metres were of centres of cells.
  const bool is_point = result["parameters"].contains("ends") ||
                        (in_cells.is_array() && std::ranges::any_of(in_cells, is_real));
  const Point p = recorded_point(Json{{keys, told}}, keys);
  if (!is_point && !keys.ends_with("_world") && (p.x != std::floor(p.x) || p.y != std::floor(p.y)))
    throw UsageError("\"" + keys + "\" is no cell");
  return {p, is_point};
}

bool in_metres(const Json& result) {
  return value_at(result, "parameters").contains("frame") &&  // a polygon world has none
         recorded<std::string>(result, "parameters/frame") == kFrames[1];
}
/// The key of what a place was given as.
std::string as_given(const Json& result, const std::string& key) {
  return in_metres(result) ? key + "_world" : key;
}

}  // namespace

End recorded_end(const Json& result, const std::string& key) {
  const std::string keys = as_given(result, key);
  return recorded_end(result, value_at(result, key), value_at(result, keys), keys);
}

std::vector<End> recorded_ends(const Json& result, const std::string& key) {
  const std::string keys = as_given(result, key);
  const Json &cells = value_at(result, key), &told = value_at(result, keys);
  for (const auto& [name, list] : {std::pair(&key, &cells), {&keys, &told}})
    if (!list->is_array()) throw UsageError("\"" + *name + "\" is no list");
  std::vector<End> ends;
  for (std::size_t i = 0; i < cells.size() && i < told.size(); ++i)
    ends.push_back(recorded_end(result, cells[i], told[i], keys));
  return ends;
}

RunOptions recorded_run(const Recorded& from) {
  const auto name = recorded<std::string>(from.result, "algorithm");
  return recorded_run(from, find_algorithm(algorithm_of(bitmaps(), name)));
}

RunOptions recorded_run(const Recorded& from, const Algorithm& algorithm) {
  const Json& result = from.result;
  RunOptions run;
  read_recorded(from, algorithm, run);
  run.params = make_params<Params>(run, bitmaps());
  run.map.file = from.map_file();
  run.map.radius = recorded<double>(result, "parameters/radius");
  run.map.unknown_is_free = recorded<std::string>(result, "parameters/unknown") == "free";
  if (result["parameters"].contains("prepare")) {
    run.map.labels = result["parameters"]["prepare"] == "labels";
    run.map.prepare = run.map.labels || recorded<bool>(result, "parameters/prepare");
  }
  if (result.contains("via")) run.via = recorded_ends(result, "via");
  if (result["parameters"].contains("spacing"))
    run.spacing = recorded_real(result, "parameters/spacing", 0, kNoLimit);
  if (result["parameters"].contains("alternatives"))
    run.alternatives = static_cast<int>(
        recorded_integer(result, "parameters/alternatives", 1, Request::kMostAlternatives));
  if (in_metres(result)) run.frame = Frame::world;
  run.map.costs = recorded_costs(from);
  return run;
}

CostLayers recorded_costs(const Recorded& from) {
  const Json& result = from.result;
  CostLayers costs;
  if (!result.contains("layers")) return costs;
  for (const Json& layer : result["layers"])
    costs.layers.push_back({.file = from.found(recorded<std::string>(layer, "file")),
                            .factor = recorded_real(layer, "factor", 0, CostField::kMost)});
  const Json& parameters = result["parameters"];
  if (parameters.contains("inflation"))
    costs.inflation = recorded<std::array<double, 3>>(result, "parameters/inflation");
  costs.eight_moves = parameters.contains("moves");
  return costs;
}

PlanCommand recorded_plan(const Recorded& from) {
  PlanCommand command;
  command.run = recorded_run(from);
  command.start = recorded_end(from.result, "start");
  command.goal = recorded_end(from.result, "goal");
  return command;
}

}  // namespace lasius::tool
