#include "tools/bitmap/map_task.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_record.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"

namespace lasius::tool {

const Algorithm& MapTask::algorithm() const { return find_algorithm(options().params.algorithm()); }

std::string MapTask::parameter(std::string_view name) const {
  return get_parameter(options().params, name);
}

std::string MapTask::error() const {
  const Frame frame = options().frame;
  if (result().status == Status::invalid)
    return invalid_text() + tolerance_text() +
           metres_hint(map(), frame, at_start() ? start() : goal());
  std::string text = result().error;
  if (result().status != Status::unreachable) return text;
  if (remedy())
    text = "start " + place_text(start(), frame) + " and goal " + place_text(goal(), frame) +
           " lie in different regions of free cells";
  if (map().radius > 0)  // why cells that look free are not
    text +=
        (curved() ? " (for a disc of radius " : " (by walks over cells, for a disc of radius ") +
        length_text(map(), frame, map().radius, 6) + ")";
  return remedy() ? text + remedy_text(map(), frame, *remedy()) + tolerance_text() : text;
}

bool MapTask::curved() const { return route_of(map(), options()).curved; }

bool MapTask::at_start() const {
  return result().fault == Fault::start_blocked || result().fault == Fault::start_outside;
}

std::string MapTask::invalid_text() const {
  const bool bad_start = at_start();
  const Place& place = bad_start ? start() : goal();
  std::string text =
      (bad_start ? "start " : "goal ") + place_text(place, options().frame) +
      obstruction_text(map(), options().frame, obstruction_of(map(), place.cell, curved()));
  if (!nearest_free())
    return map().grid().count_free() == 0 ? text + "; the map has no free cell" : text;
  const auto& [free, reachable] = std::pair(*nearest_free(), nearest_reachable());
  const std::string nearest = "; the nearest free cell ";
  if (!reachable || *reachable == free) return text + nearest + "is " + name_of(free);
  return text + nearest + (bad_start ? "from which the goal" : "that") + " can be reached" +
         (bad_start ? "" : " from the start") + " is " + name_of(*reachable) + "; " +
         name_of(free) + " is nearer, but " +
         (bad_start ? "does not lead there" : "cannot be reached");
}

/// Of a goal that is out of reach and what is out of its tolerance.
std::string MapTask::tolerance_text() const {
  if (!(options().goal_tolerance > 0) || !nearest_reachable() || at_start()) return {};
  return "; the nearest cell that can be reached, " + name_of(*nearest_reachable()) + ", is " +
         length_text(map(), options().frame, from_goal(centre(*nearest_reachable()))) +
         " from the goal, the tolerance is " +
         length_text(map(), options().frame, goal_tolerance());
}

std::string MapTask::name_of(Cell cell) const {
  return spot_text(map(), options().frame, centre(cell));
}

double MapTask::from_goal(Point at) const {
  return std::hypot(at.x - goal().number.x - 0.5, at.y - goal().number.y - 0.5);
}

double MapTask::goal_tolerance() const {
  return request_of(map(), options(), start().cell, goal().cell).goal_tolerance;
}

void MapTask::add_findings(Json& json) const {
  if (result().status == Status::invalid && (map().unknown || map().radius > 0)) {
    const auto why = obstruction_of(map(), (at_start() ? start() : goal()).cell, curved());
    json["blocked_by"] = why.by.empty() ? "obstacle" : why.by;  // that a drive's map has not
    if (why.by == "radius") json["clearance"] = number(why.clearance);
  }
  if (remedy() && remedy()->searched)
    json["widest_radius"] = optional_number(remedy()->widest_radius);
}

void MapTask::remark() const {
  if (options().json || !has_path()) return;
  const Frame frame = options().frame;
  if (const auto out = way_out()) {
    const Point from = centre(start().cell);
    message("start " + place_text(start(), frame) +
            obstruction_text(map(), frame, obstruction_of(map(), start().cell, curved())) +
            "; the path first leads straight out to " + spot_text(map(), frame, *out) + ", " +
            length_text(map(), frame, std::hypot(out->x - from.x, out->y - from.y)) + " away");
  }
  if (!goal_reached() || path_end() == centre(goal().cell)) return;
  message("the path ends at " + spot_text(map(), frame, path_end()) + ", " +
          length_text(map(), frame, from_goal(path_end())) +
          " from the goal, which cannot be reached");
}

void MapTask::add_goal_reached(Json& json) const {
  if (!(options().goal_tolerance > 0)) return;
  const auto& cell = goal_reached();
  const bool middle = cell && path_end() == centre(*cell);
  json["goal_reached"] = middle ? Json{cell->x, cell->y} : cell ? point(path_end()) : Json();
  if (in_metres()) json["goal_reached_world"] = cell ? point(map().to_world(path_end())) : Json();
}

std::pair<Json, Json> MapTask::ends() const { return {cell_json(start()), cell_json(goal())}; }

void MapTask::add_settings(Json& json) const {
  add_limits(json);
  add_map_settings(json, map(), options().frame);
  if (options().goal_tolerance > 0) json["goal_tolerance"] = number(goal_tolerance());
}

}  // namespace lasius::tool
