#include "tools/bitmap/map_record.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

/// A start or goal as it was given: a cell, or metres.
Point recorded_end(const Json& result, const std::string& key, Frame frame) {
  if (frame == Frame::world) return recorded_point(result, key + "_world");
  const Point cell = recorded_point(result, key);
  if (cell.x != std::floor(cell.x) || cell.y != std::floor(cell.y))
    throw UsageError("\"" + key + "\" is no cell");
  return cell;
}

}  // namespace

Json map_json(const LoadedMap& map) {
  return {{"file", map.file},
          {"hash", hash_text(map.hash)},
          {"width", map.width},
          {"height", map.height}};
}

Json cell_json(const Place& place) {
  const auto [x, y] = place.number;
  return Json::array({json::parameter(whole_text(x)), json::parameter(whole_text(y))});
}

void add_map_settings(Json& json, const LoadedMap& map, Frame frame) {
  json["radius"] = number(map.radius);
  json["unknown"] = map.unknown_is_free ? "free" : "blocked";
  if (map.prepare) json["prepare"] = true;
  json["frame"] = kFrames[frame == Frame::world ? 1 : 0];
}

PlanCommand recorded_plan(const Recorded& from) {
  const Json& result = from.result;
  PlanCommand command;
  RunOptions& run = command.run;
  const auto name = recorded<std::string>(result, "algorithm");
  read_recorded(from, find_algorithm(algorithm_of(bitmaps(), name)), run);
  run.params = make_params<Params>(run, bitmaps());
  run.map.file = from.map_file();
  run.map.radius = recorded<double>(result, "parameters/radius");
  run.map.unknown_is_free = recorded<std::string>(result, "parameters/unknown") == "free";
  if (result["parameters"].contains("prepare"))
    run.map.prepare = recorded<bool>(result, "parameters/prepare");
  if (recorded<std::string>(result, "parameters/frame") == kFrames[1]) run.frame = Frame::world;
  command.start = recorded_end(result, "start", run.frame);
  command.goal = recorded_end(result, "goal", run.frame);
  return command;
}

}  // namespace lasius::tool
