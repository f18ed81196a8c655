#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "tools/bitmap/map_ends.h"
#include "tools/bitmap/reasons.h"
#include "tools/command_line/map_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/console/streams.h"
#include "tools/console/threads.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

constexpr std::array<std::string_view, 3> kCornerRules{"forbid", "one-side", "allow"};

/// What is asked.
struct InfoCommand {
  MapOptions map;
  Frame frame = Frame::cell;
  std::optional<Point> start, goal;  ///< both or none
  Corners corners = Corners::forbid;
  bool json = false;
};

Json frame_json(const std::optional<WorldFrame>& frame) {
  if (!frame) return nullptr;
  return {{"resolution", number(frame->resolution)},
          {"origin", {number(frame->origin_x), number(frame->origin_y), number(frame->yaw)}}};
}

Json preparation_json(const LoadedMap& map) {
  if (!map.prepare) return nullptr;
  const Preparation& prepared = map.planner->preparation();
  Json labels;
  if (map.labels)
    labels = {{"state", to_string(prepared.labels.state)},
              {"entries", prepared.labels.entries},
              {"bytes", prepared.labels.bytes},
              {"ms", number(1000 * prepared.labels.seconds)}};
  return {{"state", to_string(prepared.state)},
          {"corners", prepared.vertices},
          {"edges", prepared.edges},
          {"bytes", prepared.bytes},
          {"ms", number(1000 * prepared.seconds)},
          {"labels", std::move(labels)}};
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
  // Of a disc cells that are joined prove no way.
  json["joined"] =
      map.grown() ? map.planner->joined(start.cell, goal.cell) &&
                        !map.planner->plan({.start = start.cell, .goal = goal.cell}).path.empty()
                  : cells.joined(*map.planner, start.cell, goal.cell);
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

std::string ms_text(const Json& value) { return printed("%.2f ms", value.get<double>()); }

std::string preparation_text(const Json& made) {
  const bool ready = made["state"] == to_string(Preparation::State::ready);
  std::string text = row_text(
      "--prepare", dumped(made["corners"]) + " vertices, " +
                       (ready ? dumped(made["edges"]) + " edges, " + dumped(made["bytes"]) +
                                    " bytes, " + ms_text(made["ms"])
                              : "not made: it would take more than " +
                                    std::to_string(PrepareOptions{}.max_bytes) + " bytes"));
  if (const Json& labels = made["labels"]; !labels.is_null())
    text += row_text(
        "labels", labels["state"] == to_string(Preparation::State::ready)
                      ? dumped(labels["entries"]) + " entries, " + dumped(labels["bytes"]) +
                            " bytes, " + ms_text(labels["ms"])
                      : "not made after " + ms_text(labels["ms"]) + ": there would be more than " +
                            std::to_string(PrepareOptions{}.max_label_entries) +
                            " entries a vertex");
  return text;
}

std::string info_text(const Json& json, const LoadedMap& map, const InfoCommand& command) {
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
  row("read", ms_text(json["read_ms"]));
  row("made ready", ms_text(json["prepare_ms"]));
  if (const Json& made = json["preparation"]; !made.is_null()) text += preparation_text(made);
  row("memory", dumped(memory["total"]) + " bytes, " +
                    printed("%.3f", memory["bits_per_cell"].get<double>()) +
                    " bits a cell (bitmap " + dumped(memory["bitmap"]) + ", components " +
                    dumped(memory["components"]) + ", visibility graph " +
                    dumped(memory["corners"]) + ", a disc's free space " + dumped(memory["disc"]) +
                    ")");
  return text;
}

}  // namespace

Subcommand add_info(CLI::App& app) {
  struct Text : InfoCommand {
    std::string start_text, goal_text;
    WorldOptions world;
  };
  auto text = std::make_shared<Text>();
  OptionTable table(app, "info", "Describe a map or a polygon world");
  table.file("MAP", text->map.file, kMapHelp, map_endings(true))->required();
  table.choice("--corners", text->corners, kCornerRules, "Rule by which components are joined",
               "forbid|one-side|allow");
  table.real("--radius", text->map.radius, 0, kNoLimit,
             "Of a disc as plan --radius has it, in cells (metres with --frame world)", "R");
  table.choice("--frame", text->frame, kFrames, "Of --radius, --start and --goal, as plan has it",
               "cell|world");
  table.text("--start", text->start_text,
             "With --goal: tell whether both are joined, and up to which radius they are", "X,Y");
  table.text("--goal", text->goal_text, "The other end", "X,Y");
  table.flag("--unknown-free", text->map.unknown_is_free,
             "Unknown cells of a ROS map count as free");
  add_prepare(table, text->map,
              "Show the visibility graph that plan --prepare makes for exact, or its labels as "
              "well, and their cost");
  add_world_options(table, text->world);
  table.flag("--json", text->json, "Print one JSON object");
  return table.command(
      {.examples = {{"lasius info maps/fan400x200.map --prepare",
                     "size, components, and what the visibility graph costs"},
                    {"lasius info maps/fan400x200.map --start 14,14 --goal 380,179",
                     "how wide a robot may be that is to go there"}},
       .exits = {{kBadFile, "the map is missing or broken"}}},
      [=](const Call&) {
        InfoCommand& info = *text;
        const std::string& file = info.map.file;
        if (is_polygon_file(file)) {
          table.refuse({"--prepare", "--frame", "--start", "--goal"}, " of info is for bitmaps");
          refuse_radius(table);
          text->world.file = file;
          return run_command(WorldInfoCommand{text->world, info.json});
        }
        refuse_world_options(table);
        info.map.radius_metres = info.frame == Frame::world;
        if (text->start_text.empty() != text->goal_text.empty())
          throw UsageError("info takes --start and --goal together");
        if (!text->start_text.empty()) {
          info.start = end_value("--start", text->start_text, info.frame);
          info.goal = end_value("--goal", text->goal_text, info.frame);
        }
        LoadedMap map = load_map(info.map, info.frame, Corners::forbid, thread_count(""));
        Json json = info_json(map, info.corners);
        add_joined(json, map, info);
        print(info.json ? line(json) : info_text(json, map, info));
        if (const std::string hint = radius_hint(map, info.frame); !hint.empty()) message(hint);
        return static_cast<int>(kFound);
      });
}

}  // namespace lasius::tool
