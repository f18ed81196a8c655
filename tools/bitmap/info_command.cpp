#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/bitmap/map_record.h"
#include "tools/bitmap/reasons.h"
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

/// Whether two places are joined, and with how wide a radius they would be: by a disc's curves, and
/// by walks over cells.
void add_joined(Json& json, LoadedMap& map, const InfoCommand& command) {
  if (!command.start) return;
  const Place start = to_place(map, *command.start, command.frame);
  const Place goal = to_place(map, *command.goal, command.frame);
  const Route cells{.corners = command.corners};
  json["start"] = cell_json(start);
  json["goal"] = cell_json(goal);
  json["joined"] =
      (map.grown() ? Route{.curved = true} : cells).joined(*map.planner, start.cell, goal.cell);
  const auto add = [&](const std::string& key, const Route& route) {
    const auto widest = widest_of(map, start.cell, goal.cell, route, {}).widest_radius;
    json[key] = optional_number(widest);
    if (map.frame) json[key + "_m"] = widest ? number(metres_within(map, *widest)) : Json(nullptr);
  };
  add("widest_radius", {.curved = true});
  add("widest_radius_grown", cells);
}

Json info_json(const LoadedMap& map, Corners corners) {
  const Grid& grid = map.grid();
  const bool eight = corners == Corners::allow;
  const auto footprint = map.planner->footprint();
  const double cells = static_cast<double>(map.width) * map.height;
  const auto free = grid.count_free();
  const auto bytes =
      footprint.bitmap + footprint.components + footprint.visibility_graph + footprint.disc;

  Json json = Json::object();
  json["format"] = "lasius-info/1";
  json["file"] = map.file;
  json["hash"] = hash_text(map.hash);
  json["width"] = map.width;
  json["height"] = map.height;
  json["radius"] = number(map.radius);
  json["free_cells"] = free;
  json["free_share"] = number(static_cast<double>(free) / cells);
  json["unknown_cells"] = nullptr;
  json["unknown_share"] = nullptr;
  if (map.unknown) {
    const double unknown = cells - static_cast<double>(map.unknown->count_free());
    json["unknown_cells"] = static_cast<std::int64_t>(unknown);
    json["unknown_share"] = number(unknown / cells);
  }
  json["connectivity"] = eight ? 8 : 4;
  json["components"] = map.planner->components(corners);
  json["frame"] = frame_json(map.frame);
  if (map.frame) json["extent_m"] = {number(map.metres(map.width)), number(map.metres(map.height))};
  json["read_ms"] = number(map.read_ms);
  json["prepare_ms"] = number(map.ready_ms);
  json["preparation"] = preparation_json(map);
  json["memory"] = {{"bitmap", footprint.bitmap},
                    {"components", footprint.components},
                    {"corners", footprint.visibility_graph},
                    {"total", bytes},
                    {"disc", footprint.disc},
                    {"bits_per_cell", number(8.0 * static_cast<double>(bytes) / cells)}};
  return json;
}

std::string info_text(const Json& json, const LoadedMap& map, const InfoCommand& command) {
  const auto ms = [](const Json& value) { return printed("%.2f ms", value.get<double>()); };
  const auto& memory = json["memory"];
  std::string text;
  const auto row = [&text](const char* name, const std::string& value) {
    text += row_text(name, value);
  };
  const auto percent = [&json](const char* share) {
    return " cells, " + std::to_string(std::lround(100 * json[share].get<double>())) + "%";
  };
  row("size", dumped(json["width"]) + " x " + dumped(json["height"]) + " cells" +
                  (map.frame ? ", " + rounded_text(map.metres(map.width), 3) + " x " +
                                   length_text(map, Frame::world, map.height)
                             : ""));
  row("hash", json["hash"].get<std::string>());
  row("free", dumped(json["free_cells"]) + percent("free_share"));
  if (map.unknown)
    row("unknown", dumped(json["unknown_cells"]) + percent("unknown_share") +
                       (map.unknown_is_free ? ", counted as free" : ", counted as blocked"));
  row("components",
      dumped(json["components"]) + " (" + dumped(json["connectivity"]) + "-connected)");
  if (!json["frame"].is_null()) {
    const auto& origin = json["frame"]["origin"];
    row("frame", to_text(json["frame"]["resolution"].get<double>()) + " m a cell, origin " +
                     to_text(origin[0].get<double>()) + "," + to_text(origin[1].get<double>()) +
                     " m, yaw " + to_text(origin[2].get<double>()));
  }
  if (command.start) {
    std::string joined = json["joined"].get<bool>() ? "yes" : "no";
    const auto add = [&](const char* before, const char* key) {
      if (!json[key].is_null())
        joined += before + length_text(map, command.frame, json[key].get<double>(), 3, true);
    };
    add(", up to --radius ", "widest_radius");
    add(" for exact, for the others up to ", "widest_radius_grown");
    row("joined", joined);
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
                    dumped(memory["corners"]) + ", a disc's free space " + dumped(memory["disc"]) +
                    ")");
  return text;
}

}  // namespace

int run_command(const InfoCommand& command) {
  LoadedMap map = load_map(command.map, command.frame);
  Json json = info_json(map, command.corners);
  add_joined(json, map, command);
  print(command.json ? line(json) : info_text(json, map, command));
  return kFound;
}

}  // namespace lasius::tool
