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
  const Frame frame = options().frame;
  if (result().status == Status::invalid)
    return invalid_text() + metres_hint(map(), frame, at_start() ? start() : goal());
  std::string text = result().error;
  if (result().status != Status::unreachable) return text;
  if (remedy() && in_metres())
    text = "start " + place_text(start(), frame) + " and goal " + place_text(goal(), frame) +
           " lie in different regions of free cells";
  if (map().radius > 0)  // why cells that look free are not
    text += " (obstacles grown by " + length_text(map(), frame, map().radius, 6) + ")";
  return remedy() ? text + remedy_text(map(), frame, *remedy()) : text;
}

bool MapTask::at_start() const {
  return result().fault == Fault::start_blocked || result().fault == Fault::start_outside;
}

std::string MapTask::invalid_text() const {
  const Place& place = at_start() ? start() : goal();
  std::string text = (at_start() ? "start " : "goal ") + place_text(place, options().frame) +
                     obstruction_text(map(), options().frame, obstruction_of(map(), place.cell));
  if (!nearest_free())
    return map().grid().count_free() == 0 ? text + "; the map has no free cell" : text;
  const Cell free = *nearest_free();
  text += printed("; the nearest free cell is (%d, %d)", free.x, free.y);
  if (!in_metres()) return text;
  const Point metres = map().to_world(centre(free));
  return text + ", its centre at " + decimal_text(metres.x, 3) + "," + decimal_text(metres.y, 3) +
         " m";
}

void MapTask::add_findings(Json& json) const {
  if (result().status == Status::invalid && (map().unknown || map().radius > 0)) {
    const auto why = obstruction_of(map(), (at_start() ? start() : goal()).cell);
    json["blocked_by"] = why.by.empty() ? "obstacle" : why.by;  // that a drive's map has not
    if (why.by == "radius") json["clearance"] = number(why.clearance);
  }
  if (remedy() && remedy()->searched)
    json["widest_radius"] = optional_number(remedy()->widest_radius);
}

std::pair<Json, Json> MapTask::ends() const { return {cell_json(start()), cell_json(goal())}; }

void MapTask::add_settings(Json& json) const {
  add_limits(json);
  add_map_settings(json, map(), options().frame);
}

}  // namespace lasius::tool
