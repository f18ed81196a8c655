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
    return invalid_text() + metres_hint(map(), frame, at_start() ? start() : goal());
  std::string text = result().error;
  if (result().status != Status::unreachable) return text;
  if (remedy() && in_metres())
    text = "start " + place_text(start(), frame) + " and goal " + place_text(goal(), frame) +
           " lie in different regions of free cells";
  if (map().radius > 0)  // why cells that look free are not
    text += (curved() ? " (for a disc of radius " : " (obstacles grown by ") +
            length_text(map(), frame, map().radius, 6) + ")";
  return remedy() ? text + remedy_text(map(), frame, *remedy()) : text;
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

std::string MapTask::name_of(Cell cell) const {
  const std::string name = printed("(%d, %d)", cell.x, cell.y);
  if (!in_metres()) return name;
  const Point metres = map().to_world(centre(cell));
  return name + ", its centre at " + decimal_text(metres.x, 3) + "," + decimal_text(metres.y, 3) +
         " m";
}

void MapTask::add_findings(Json& json) const {
  if (result().status == Status::invalid) {
    const auto why = obstruction_of(map(), (at_start() ? start() : goal()).cell, curved());
    json["blocked_by"] = why.by.empty() ? "obstacle" : why.by;  // that a drive's map has not
    if (why.by == "radius") json["clearance"] = number(why.clearance);
  }
  if (remedy() && remedy()->searched)
    json["widest_radius"] = optional_number(remedy()->widest_radius);
}

void MapTask::remark() const {
  if (options().json || !has_path() || !goal_reached() || *goal_reached() == goal().cell) return;
  const Point end = centre(*goal_reached()), asked{goal().number.x + 0.5, goal().number.y + 0.5};
  message("the path ends at " + name_of(*goal_reached()) + ", " +
          to_text(shown(std::hypot(end.x - asked.x, end.y - asked.y))) +
          (in_metres() ? " m" : " cells") + " from the goal, which cannot be reached");
}

void MapTask::add_goal_reached(Json& json) const {
  if (!(options().goal_tolerance > 0)) return;
  json["goal_reached"] = goal_reached() ? Json{goal_reached()->x, goal_reached()->y} : Json();
  if (in_metres())
    json["goal_reached_world"] =
        goal_reached() ? point(map().to_world(centre(*goal_reached()))) : Json();
}

std::pair<Json, Json> MapTask::ends() const { return {cell_json(start()), cell_json(goal())}; }

void MapTask::add_settings(Json& json) const {
  add_limits(json);
  add_map_settings(json, map(), options().frame);
  if (options().goal_tolerance > 0)
    json["goal_tolerance"] =
        number(request_of(map(), options(), start().cell, goal().cell).goal_tolerance);
}

}  // namespace lasius::tool
