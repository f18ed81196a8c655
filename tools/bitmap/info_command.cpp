#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/bitmap/map_file.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

Json frame_json(const std::optional<WorldFrame>& frame) {
  if (!frame) return nullptr;
  return {{"resolution", number(frame->resolution)},
          {"origin", {number(frame->origin_x), number(frame->origin_y), number(frame->yaw)}}};
}

Json preparation_json(const LoadedMap& map) {
  if (!map.prepare) return nullptr;
  const Preparation& prepared = map.planner->preparation();
  return {{"state", to_string(prepared.state)},
          {"corners", prepared.vertices},
          {"edges", prepared.edges},
          {"bytes", prepared.bytes},
          {"ms", number(1000 * prepared.seconds)}};
}

Json info_json(const LoadedMap& map, Corners corners) {
  const Grid& grid = map.grid();
  const bool eight = corners == Corners::allow;
  const auto footprint = map.planner->footprint();
  const double cells = static_cast<double>(map.width) * map.height;
  const auto free = grid.count_free();
  const auto bytes = footprint.bitmap + footprint.components + footprint.visibility_graph;

  Json json = Json::object();
  json["format"] = "lasius-info/1";
  json["file"] = map.file;
  json["hash"] = hash_text(map.hash);
  json["width"] = map.width;
  json["height"] = map.height;
  json["radius"] = number(map.radius);
  json["free_cells"] = free;
  json["free_share"] = number(static_cast<double>(free) / cells);
  json["connectivity"] = eight ? 8 : 4;
  json["components"] = map.planner->components(corners);
  json["frame"] = frame_json(map.frame);
  json["read_ms"] = number(map.read_ms);
  json["prepare_ms"] = number(map.ready_ms);
  json["preparation"] = preparation_json(map);
  json["memory"] = {{"bitmap", footprint.bitmap},
                    {"components", footprint.components},
                    {"corners", footprint.visibility_graph},
                    {"total", bytes},
                    {"bits_per_cell", number(8.0 * static_cast<double>(bytes) / cells)}};
  return json;
}

std::string info_text(const Json& json) {
  const auto ms = [](const Json& value) { return printed("%.2f ms", value.get<double>()); };
  const auto& memory = json["memory"];
  std::string text;
  const auto row = [&text](const char* name, const std::string& value) {
    text += row_text(name, value);
  };
  row("size", dumped(json["width"]) + " x " + dumped(json["height"]) + " cells");
  row("hash", json["hash"].get<std::string>());
  row("free", dumped(json["free_cells"]) + " cells, " +
                  std::to_string(std::lround(100 * json["free_share"].get<double>())) + "%");
  row("components",
      dumped(json["components"]) + " (" + dumped(json["connectivity"]) + "-connected)");
  if (!json["frame"].is_null()) {
    const auto& origin = json["frame"]["origin"];
    row("frame", to_text(json["frame"]["resolution"].get<double>()) + " m a cell, origin " +
                     to_text(origin[0].get<double>()) + "," + to_text(origin[1].get<double>()) +
                     " m, yaw " + to_text(origin[2].get<double>()));
  }
  row("read", ms(json["read_ms"]));
  row("made ready", ms(json["prepare_ms"]));
  if (const Json& more = json["preparation"]; !more.is_null()) {
    const bool ready = more["state"] == to_string(Preparation::State::ready);
    row("--prepare", dumped(more["corners"]) + " vertices, " +
                         (ready ? dumped(more["edges"]) + " edges, " + dumped(more["bytes"]) +
                                      " bytes, " + ms(more["ms"])
                                : "not made: it would take more than " +
                                      std::to_string(PrepareOptions{}.max_bytes) + " bytes"));
  }
  row("memory", dumped(memory["total"]) + " bytes, " +
                    printed("%.3f", memory["bits_per_cell"].get<double>()) +
                    " bits a cell (bitmap " + dumped(memory["bitmap"]) + ", components " +
                    dumped(memory["components"]) + ", visibility graph " +
                    dumped(memory["corners"]) + ")");
  return text;
}

}  // namespace

int run_command(const InfoCommand& command) {
  const LoadedMap map = load_map(command.map);
  const Json json = info_json(map, command.corners);
  print(command.json ? line(json) : info_text(json));
  return kFound;
}

}  // namespace lasius::tool
