#include "tools/bitmap/map_task.h"

#include <nlohmann/json.hpp>

#include "tools/bitmap/map_record.h"
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
  const Cell free = *nearest_free();
  text += printed("; the nearest free cell is (%d, %d)", free.x, free.y);
  if (!in_metres()) return text;
  const Point metres = map().to_world(centre(free));
  return text + ", its centre at " + decimal_text(metres.x, 3) + "," + decimal_text(metres.y, 3) +
         " m";
}

std::pair<Json, Json> MapTask::ends() const { return {cell_json(start()), cell_json(goal())}; }

void MapTask::add_settings(Json& json) const {
  add_limits(json);
  add_map_settings(json, map(), options().frame);
}

}  // namespace lasius::tool
