#include "tools/polygon/polygon_report.h"

#include <nlohmann/json.hpp>

#include "tools/report/report.h"

namespace lasius::tool {
namespace {

/// Most corners of a world that a page draws; the rest of its polygons are left out.
constexpr std::size_t kMostCorners = 60'000;

Json polygons_json(const std::vector<polygon::Polygon>& polygons, std::size_t& left) {
  Json list = Json::array();
  for (const auto& shape : polygons) {
    std::size_t corners = shape.outer.size();
    for (const auto& hole : shape.holes) corners += hole.size();
    if (corners > left) break;
    left -= corners;
    Json rings = Json::array({points(shape.outer)});
    for (const auto& hole : shape.holes) rings.push_back(points(hole));
    list.push_back(std::move(rings));
  }
  return list;
}

Json world_json(const LoadedWorld& world) {
  std::size_t left = kMostCorners;
  Json json = {{"low", point(world.low())},
               {"high", point(world.high())},
               {"margin", world.planner.margin()},
               {"free", polygons_json(world.planner.free_space(), left)}};
  json["obstacles"] = polygons_json(world.planner.world().obstacles, left);
  json["walls"] = Json::array();
  for (const auto& wall : world.planner.world().walls) {
    if (left < wall.size()) break;
    left -= wall.size();
    json["walls"].push_back(points(wall));
  }
  json["lines"] = Json::array();
  for (const auto& line : world.planner.maklink().lines) {
    if (left < 2) break;
    left -= 2;
    json["lines"].push_back({point(line.a), point(line.b)});
  }
  return json;
}

}  // namespace

void PolygonFrames::observe(const polygon::PlanProgress& progress) {
  newest_.observe(progress);
  if (frames_.wants(progress.iteration)) frames_.add(newest_);
}

Json PolygonFrames::json() const {
  if (newest_.iteration == 0) return nullptr;
  auto frames = frames_.all();
  if (frames.empty() || frames.back().iteration != newest_.iteration) frames.push_back(newest_);
  Json json;
  set_paths(json, frames);
  return json;
}

void write_polygon_report(std::ostream& out, const Record& run, const LoadedWorld& world,
                          const PolygonAnswer& answer, const PolygonFrames* frames) {
  Json content = run_json(run, "polygon", polygon_title(world, answer.parameters));
  content["world"] = world_json(world);
  const auto& dijkstra = answer.result.dijkstra;
  content["dijkstra"] = dijkstra ? points(dijkstra->path) : Json(nullptr);
  content["frames"] = frames != nullptr ? frames->json() : Json(nullptr);
  write_report_page(out, content);
}

}  // namespace lasius::tool
