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
  const Status status = result().status;
  std::string text = status == Status::invalid ? invalid_text() : result().error;
  const bool refused = status == Status::invalid || status == Status::unreachable;
  if (refused && map().radius > 0)  // why a cell that looks free is not
    text.append(" (obstacles grown by ").append(to_text(map().radius)).append(" cells)");
  return text;
}

std::string MapTask::invalid_text() const {
  const Fault fault = result().fault;
  const bool at_start = fault == Fault::start_blocked || fault == Fault::start_outside;
  const bool outside = fault == Fault::start_outside || fault == Fault::goal_outside;
  const auto& [cell, number, asked] = at_start ? start() : goal();
  const std::string named = std::string("(")
                                .append(whole_text(number.x))
                                .append(", ")
                                .append(whole_text(number.y))
                                .append(")");
  std::string text = at_start ? "start " : "goal ";
  if (in_metres()) {
    text += to_text(asked.x) + "," + to_text(asked.y) + " m, in cell " + named + ",";
  } else {
    text += named;
  }
  text += outside ? " is outside the map" : " is blocked";
  if (!nearest_free())
    return map().grid().count_free() == 0 ? text + "; the map has no free cell" : text;
  const auto& [free, reachable] = std::pair(*nearest_free(), nearest_reachable());
  const std::string nearest = "; the nearest free cell ";
  if (!reachable || *reachable == free) return text + nearest + "is " + name_of(free);
  return text + nearest + (at_start ? "from which the goal" : "that") + " can be reached" +
         (at_start ? "" : " from the start") + " is " + name_of(*reachable) + "; " + name_of(free) +
         " is nearer, but " + (at_start ? "does not lead there" : "cannot be reached");
}

std::string MapTask::name_of(Cell cell) const {
  const std::string name = printed("(%d, %d)", cell.x, cell.y);
  if (!in_metres()) return name;
  const Point metres = map().to_world(centre(cell));
  return name + ", its centre at " + decimal_text(metres.x, 3) + "," + decimal_text(metres.y, 3) +
         " m";
}

void MapTask::remark() const {
  if (options().json || !has_path() || !goal_reached() || *goal_reached() == goal().cell) return;
  const Point end = centre(*goal_reached()), asked{goal().number.x + 0.5, goal().number.y + 0.5};
  message("the path ends at " + name_of(*goal_reached()) + ", " +
          to_text(std::round(1e3 * shown(std::hypot(end.x - asked.x, end.y - asked.y))) / 1e3) +
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
