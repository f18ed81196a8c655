#include <nlohmann/json.hpp>

#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/polygon/polygon_answer.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

Json optional_point(const std::optional<Point>& p) { return p ? point(*p) : Json(nullptr); }

std::size_t corners(const std::vector<polygon::Polygon>& polygons) {
  std::size_t count = 0;
  for (const auto& p : polygons) {
    count += p.outer.size();
    for (const auto& hole : p.holes) count += hole.size();
  }
  return count;
}

Json info_json(const LoadedWorld& loaded) {
  const polygon::Planner& planner = loaded.planner;
  const polygon::World& world = planner.world();
  const Point low = loaded.low(), high = loaded.high();
  Json json = Json::object();
  json["format"] = "lasius-info/1";
  json["file"] = loaded.options.file;
  json["hash"] = hash_text(loaded.hash);
  json["width"] = number(high.x - low.x);
  json["height"] = number(high.y - low.y);
  json["origin"] = {number(low.x), number(low.y)};
  json["margin"] = number(planner.margin());
  json["join"] = to_string(planner.join());
  json["boundary"] = to_string(planner.boundary());
  json["obstacles"] = world.obstacles.size();
  json["corners"] = corners(world.obstacles);
  json["walls"] = world.walls.size();
  json["grown_obstacles"] = planner.grown_obstacles().size();
  json["free_corners"] = corners(planner.free_space());
  json["components"] = planner.components();
  json["lines"] = planner.maklink().lines.size();
  json["regions"] = planner.maklink().regions.size();
  json["start"] = optional_point(world.start);
  json["goal"] = optional_point(world.goal);
  json["notes"] = world.notes;
  json["read_ms"] = number(loaded.read_ms);
  json["prepare_ms"] = number(loaded.ready_ms);
  return json;
}

std::string info_text(const Json& json) {
  std::string text;
  const auto row = [&text](const char* name, const std::string& value) {
    text += row_text(name, value);
  };
  const auto ms = [](const Json& value) { return printed("%.2f ms", value.get<double>()); };
  const auto count = [&json](const char* key, const char* thing) {
    return counted(json[key].get<std::int64_t>(), thing);
  };
  const auto place = [](const Json& p) {
    return p.is_null() ? std::string("none") : dumped(p[0]) + "," + dumped(p[1]);
  };
  row("size",
      dumped(json["width"]) + " x " + dumped(json["height"]) + " from " + place(json["origin"]));
  row("hash", json["hash"].get<std::string>());
  row("margin", dumped(json["margin"]) + ", " + json["join"].get<std::string>() +
                    " joins, boundary: " + json["boundary"].get<std::string>());
  row("obstacles", dumped(json["obstacles"]) + " with " + count("corners", "corner") + ", " +
                       (json["walls"] == 0 ? "" : count("walls", "wall") + ", ") +
                       dumped(json["grown_obstacles"]) + " grown and merged");
  row("free space", count("components", "component") + ", " + count("free_corners", "corner"));
  row("maklink", count("lines", "line") + ", " + count("regions", "convex region"));
  row("start", place(json["start"]));
  row("goal", place(json["goal"]));
  row("read", ms(json["read_ms"]));
  row("made ready", ms(json["prepare_ms"]));
  return text;
}

}  // namespace

int run_command(const WorldInfoCommand& command) {
  const LoadedWorld world = load_world(command.world);
  for (const auto& note : world.planner.world().notes) message(command.world.file + ": " + note);
  const Json json = info_json(world);
  print(command.json ? line(json) : info_text(json));
  return kFound;
}

}  // namespace lasius::tool
