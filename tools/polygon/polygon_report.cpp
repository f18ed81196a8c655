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
  if (!newest_.path || progress.best_length != best_) {
    best_ = progress.best_length;
    newest_.path = std::make_shared<const Path>(progress.path());
  }
  newest_.iteration = progress.iteration + 1;
  if (frames_.wants(progress.iteration)) frames_.add(newest_);
}

Json PolygonFrames::json() const {
  if (newest_.iteration == 0) return nullptr;
  auto frames = frames_.all();
  if (frames.empty() || frames.back().iteration != newest_.iteration) frames.push_back(newest_);
  Json json = {{"iterations", Json::array()}, {"paths", Json::array()}, {"path_of", Json::array()}};
  const Path* last = nullptr;
  for (const Frame& frame : frames) {
    json["iterations"].push_back(frame.iteration);
    if (frame.path.get() != last) json["paths"].push_back(points(*frame.path));
    last = frame.path.get();
    json["path_of"].push_back(json["paths"].size() - 1);
  }
  return json;
}

void write_polygon_report(std::ostream& out, const Task& task, const LoadedWorld& world,
                          const PolygonAnswer& answer, const PolygonFrames* frames) {
  Json content = run_json(task, "polygon", polygon_title(world, answer.parameters));
  content["world"] = world_json(world);
  const auto& dijkstra = answer.result.dijkstra;
  content["dijkstra"] = dijkstra ? points(dijkstra->path) : Json(nullptr);
  content["frames"] = frames != nullptr ? frames->json() : Json(nullptr);
  write_report_page(out, content);
}

}  // namespace lasius::tool
