#include "tools/command_line/subcommands.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <string_view>

#include "tools/command_line/option_kinds.h"
#include "tools/command_line/run_text.h"
#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/console/threads.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

constexpr const char* kPrepare =
    "Make the map's visibility graph for exact (at most 1 GB): worth it for many queries. Answers "
    "are as short as without; lasius info MAP --prepare shows what it costs";

constexpr const char* kMapHelp =
    "Map: .map, PBM, PGM, PNG, BMP or ROS YAML; polygon world: .geojson, .json or .wkt";

constexpr const char* kOutputs =
    "Write a file, by its ending (repeatable):\n"
    ".json  what --json prints\n"
    ".csv  iteration,best,mean,arrived by iteration; x,y of the path for algorithms without "
    "iterations; for batch a line a query; with --frame world in metres: best_m, x_m, ...\n"
    ".svg, .png  map, tracks, pheromone, path and convergence; for batch all paths; for polygon "
    "worlds MAKLINK lines, midpoints, Dijkstra's path, path and convergence\n"
    ".html  one page that plays the run, opens from disk and needs no network; not for batch";

/// An option that was given an empty value was not left out.
std::string not_empty(const std::string& value) { return value.empty() ? "has no value" : ""; }

constexpr const char* kDriveOutputs =
    "Write a file, by its ending (repeatable):\n"
    ".json  what --json prints\n"
    ".csv  x,y of the track, one cell a tick; with --frame world x_m,y_m\n"
    ".svg, .png  the track over the world: what was seen when, where ways were planned\n"
    ".gif  a film of at most 301 pictures\n"
    ".html  one page that plays the drive tick by tick";

constexpr SearchHelp kRunHelp = {
    .seed =
        "Seed, from 0 to 2^53-1 (default 1). A-B or A..B: every query with each of these seeds, "
        "a JSON object a line, from plan too, which ends with 0 where any of them returned a path",
    .time_limit =
        "Stop after this time, counted once the map is prepared; for batch by query. "
        "Each optimum of --gap may take as long again",
    .target_gap = "Stop at this certified gap, for algorithms that certify one (1 means 1%)",
    .json = "Print one JSON object (batch always does, one a query)",
    .outputs = kOutputs};

void add_run_options(CLI::App& app, RunText& text, const char* map_help,
                     const SearchHelp& help = kRunHelp) {
  const AddOption option = option_adder(app);
  option("MAP", text.map, map_help, "FILE")->required();
  add_search_options(app, text, help);
  option("--neighbours", text.value_of("neighbours"), "Moves from a cell", "4|8|16|16k|24|32");
  option("--corners", text.value_of("corners"), "Diagonal steps past blocked cells",
         "forbid|one-side|allow");
  option("--preset", text.preset,
         "Numbers to start with: usual, or the textbook's of algorithms that have them (see lasius "
         "algorithms), or a file's, as tune writes it",
         "usual|book|FILE");
  option("--polish", text.value_of("polish"), "What is done with a path",
         "none|straight|taut|local");
  option("--frame", text.frame,
         "Coordinates in cells, or in metres of a ROS map's frame; a cell holds its left and lower "
         "edge there",
         "cell|world");
  option(
      "--radius", text.radius,
      "The robot is a disc: its centre keeps R cells (metres with --frame world) from what is "
      "blocked and from the map's edge. exact passes whatever such a disc can, R from 0.05 to 54 "
      "cells; other algorithms plan on cells all of whose points keep R",
      "R");
  option(
      "--goal-tolerance", text.goal_tolerance,
      "Where the goal cannot be reached, end at the free cell nearest to it that can be, at most "
      "R away from centre to centre; R in cells (metres with --frame world)",
      "R");
  add_switch(app, "--unknown-free", text.unknown_free, "Unknown cells of a ROS map count as free");
  add_switch(app, "--prepare", text.prepare, kPrepare);
  add_switch(app, "--gap", text.gap,
             "Add the exact optimum, the true gap, and the optimum of the algorithm's own moves; "
             "null where a time limit or a signal ended the search for it, or where --corners "
             "allow lets moves squeeze through where no path of the plane may");
  option("--tracks", text.tracks,
         "Iterations of which a picture shows the tracks (default: 1, the critical time, 50, the "
         "last)",
         "N,N,...");
}

void add_world_options(CLI::App& app, WorldText& text) {
  const AddOption option = option_adder(app);
  option("--margin", text.margin,
         "Polygon worlds: obstacles grow by this in place of theirs, and the boundary shrinks",
         "R");
  option("--join", text.join,
         "Polygon worlds: corners of grown obstacles (default round, the margin and at most 0.5% "
         "more; mitre reaches farther and may close passages, bevel keeps less, chords 99.5%)",
         "round|mitre|bevel|chords");
  option("--boundary", text.boundary,
         "Polygon worlds: whether the margin holds at the boundary, too (default shrink)",
         "shrink|keep");
  add_switch(app, "--repair", text.repair, "Polygon worlds: repair geometry that is not valid");
}

Subcommand add_plan(CLI::App& app) {
  struct Raw {
    RunText run;
    PolygonText polygon;
  };
  auto raw = std::make_shared<Raw>();
  auto* plan = app.add_subcommand("plan", "Plan one path");
  const AddOption option = option_adder(*plan);
  option("--start", raw->polygon.ends.start, "Where the path starts; a polygon world may say",
         "X,Y");
  option("--goal", raw->polygon.ends.goal, "Where it ends; likewise", "X,Y");
  add_run_options(*plan, raw->run, kMapHelp);
  add_world_options(*plan, raw->polygon.world);
  return {plan, [raw]() -> Command {
            const PolygonText& text = raw->polygon;
            if (is_world(raw->run.map)) {
              auto polygon = make_polygon(raw->run, text, kPlanEndings);
              if (polygon.ranged) return PolygonBatchCommand{std::move(polygon), ""};
              return polygon;
            }
            refuse_world_options(text.world);
            auto query = make_plan(text.ends, make_run(raw->run, kPlanEndings));
            if (query.run.ranged)
              return BatchCommand{std::move(query.run), "", query.start, query.goal};
            return query;
          }};
}

Subcommand add_drive(CLI::App& app) {
  auto raw = std::make_shared<DriveText>();
  auto* drive = app.add_subcommand(
      "drive", "Drive a robot through a world that is not as its map has it, and changes");
  const AddOption option = option_adder(*drive);
  option("--start", raw->ends.start, "Where the robot starts", "X,Y");
  option("--goal", raw->ends.goal, "Where it is to go", "X,Y");
  option("--world", raw->world, "What is really there, as large as MAP (default as MAP has it)",
         "FILE");
  option("--changes", raw->changes,
         "What changes under way, a line each: TICK X Y [W H] blocked|free, or "
         "TICK move W H SPEED X Y [X Y]... for an obstacle that moves",
         "FILE");
  option("--sense", raw->sense,
         "How far the robot sees, in cells (metres with --frame world; default 20 cells)", "R");
  option("--max-ticks", raw->max_ticks, "Moves and waits at most (default 1000000)", "N");
  add_run_options(*drive, *raw, "Map that the robot knows: .map, PBM, PGM, PNG, BMP or ROS YAML",
                  {.seed = "Seed, from 0 to 2^53-1 (default 1)",
                   .time_limit = "Stop the drive after this time",
                   .target_gap = "Plan no further than to this certified gap (1 means 1%)",
                   .json = "Print one JSON object",
                   .outputs = kDriveOutputs});
  drive->get_option("--gap")->description(
      "No effect: a drive always tells the optimum of its moves");
  drive->get_option("--tracks")->group(kRefused);
  return {drive, [raw]() -> Command { return make_drive(*raw); }};
}

Subcommand add_batch(CLI::App& app) {
  struct Raw {
    RunText run;
    WorldText world;
    std::string queries;
  };
  auto raw = std::make_shared<Raw>();
  auto* batch = app.add_subcommand("batch", "Plan many paths on one map: JSON, one object a line");
  add_run_options(*batch, raw->run, kMapHelp);
  add_world_options(*batch, raw->world);
  option_adder (*batch)("QUERIES", raw->queries,
                        "A TSV with columns sx sy gx gy; of a bitmap also a MovingAI .scen", "FILE")
      ->required();
  return {batch, [raw]() -> Command {
            if (is_world(raw->run.map)) {
              auto plan = make_polygon(raw->run, {raw->world, {}});
              plan.inputs.push_back(raw->queries);
              return PolygonBatchCommand{std::move(plan), raw->queries};
            }
            refuse_world_options(raw->world);
            auto run = make_run(raw->run);
            run.inputs.push_back(raw->queries);
            return BatchCommand{.run = std::move(run), .queries = raw->queries};
          }};
}

Subcommand add_info(CLI::App& app) {
  struct Raw {
    std::string map, corners, radius, frame, start, goal;
    WorldText world;
    bool unknown_free = false, prepare = false, json = false;
  };
  auto raw = std::make_shared<Raw>();
  auto* info = app.add_subcommand("info", "Describe a map or a polygon world");
  const AddOption option = option_adder(*info);
  option("MAP", raw->map, kMapHelp, "FILE")->required();
  option("--corners", raw->corners, "Rule by which components are joined", "forbid|one-side|allow");
  option("--radius", raw->radius,
         "Of a disc as plan --radius has it, in cells (metres with --frame world)", "R");
  option("--frame", raw->frame, "Of --radius, --start and --goal, as plan has it", "cell|world");
  option("--start", raw->start,
         "With --goal: tell whether both are joined, and up to which radius they are", "X,Y");
  option("--goal", raw->goal, "The other end", "X,Y");
  add_switch(*info, "--unknown-free", raw->unknown_free,
             "Unknown cells of a ROS map count as free");
  add_switch(*info, "--prepare", raw->prepare,
             "Show the visibility graph that plan --prepare makes for exact, and its cost");
  add_world_options(*info, raw->world);
  add_switch(*info, "--json", raw->json, "Print one JSON object");
  return {info, [raw]() -> Command {
            static constexpr std::string_view kRules[] = {"forbid", "one-side", "allow"};
            auto corners = Corners::forbid;
            if (!raw->corners.empty())
              corners = static_cast<Corners>(choice_value("--corners", raw->corners, kRules));
            if (is_world(raw->map)) {
              if (raw->prepare) throw UsageError("--prepare is for bitmaps");
              if (!raw->frame.empty() || !raw->start.empty() || !raw->goal.empty())
                throw UsageError("--frame, --start and --goal of info are for bitmaps");
              refuse_radius(raw->radius);
              return WorldInfoCommand{make_world_options(raw->map, raw->world), raw->json};
            }
            refuse_world_options(raw->world);
            InfoCommand options{.map = {.file = raw->map,
                                        .unknown_is_free = raw->unknown_free,
                                        .prepare = raw->prepare,
                                        .threads = thread_count("")},
                                .frame = frame_of(raw->frame),
                                .start = {},
                                .goal = {},
                                .corners = corners,
                                .json = raw->json};
            options.map.radius_metres = options.frame == Frame::world;
            if (!raw->radius.empty())
              options.map.radius = real_value("--radius", raw->radius, 0, kNoLimit);
            if (raw->start.empty() != raw->goal.empty())
              throw UsageError("info takes --start and --goal together");
            if (!raw->start.empty()) {
              options.start = end_value("--start", raw->start, options.frame, raw->map);
              options.goal = end_value("--goal", raw->goal, options.frame, raw->map);
            }
            return options;
          }};
}

Subcommand add_algorithms(CLI::App& app) {
  auto raw = std::make_shared<AlgorithmsCommand>();
  auto* list =
      app.add_subcommand("algorithms", "List the algorithms, their formulas and parameters");
  option_adder (*list)("NAME", raw->name, "Only this one", "NAME");
  add_switch(*list, "--json", raw->json, "Print one JSON object");
  return {list, [raw]() -> Command { return *raw; }};
}

Subcommand add_generate(CLI::App& app) {
  struct Raw {
    std::string kind, size, density, seed, output;
  };
  auto raw = std::make_shared<Raw>();
  auto* make = app.add_subcommand("generate", "Make a map from a seed");
  const AddOption option = option_adder(*make);
  option("KIND", raw->kind, "Kind of map", "blobs|maze|rooms|city|random|open")->required();
  option("--size", raw->size, "Width and height in cells", "WxH")->required();
  option("--density", raw->density,
         "Share of blocked cells that is aimed at, from 0 to 1, or the most that the kind reaches; "
         "default: the kind's own",
         "D");
  option("--seed", raw->seed, "Seed, from 0 to 2^53-1 (default 1)", "N");
  option("-o,--output", raw->output, "Map to write: .map, .pbm or .png", "FILE")->required();
  return {make, [raw]() -> Command {
            GenerateCommand command;
            command.kind = static_cast<MapKind>(choice_value("KIND", raw->kind, map_kind_names()));
            const Cell size = size_value("--size", raw->size);
            command.options.width = size.x;
            command.options.height = size.y;
            if (!raw->density.empty())
              command.options.density = real_value("--density", raw->density, 0, 1);
            command.options.seed = seed_value(raw->seed);
            check_endings({raw->output}, kMapOutputEndings);
            command.output = raw->output;
            return command;
          }};
}

Subcommand add_verify(CLI::App& app) {
  struct Raw {
    std::string result, map, threads;
    bool quiet = false;
  };
  auto raw = std::make_shared<Raw>();
  auto* verify = app.add_subcommand("verify", "Replay saved results and compare");
  const AddOption option = option_adder(*verify);
  option("RESULT", raw->result, "A result of plan, drive or arm, or the lines of batch", "FILE")
      ->required();
  option("--map", raw->map, "The map, where it is no longer where it was", "FILE");
  option("--threads", raw->threads, "Threads of the replay", "N");
  add_switch(*verify, "-q,--quiet", raw->quiet, "Print differences only");
  return {verify, [raw]() -> Command {
            return VerifyCommand{raw->result, raw->map, thread_count(raw->threads), raw->quiet};
          }};
}

Subcommand add_help(CLI::App& app) {
  auto raw = std::make_shared<HelpCommand>();
  auto* help = app.add_subcommand("help", "Tell of a topic or a command");
  const AddOption option = option_adder(*help);
  option("TOPIC", raw->topic, "A topic, or a command; without it what there is", "TOPIC");
  add_switch(*help, "--json", raw->json,
             "All that there is to tell, of which the manual pages are made");
  return {help, [raw]() -> Command { return *raw; }};
}

}  // namespace

std::vector<Subcommand> add_subcommands(CLI::App& app) {
  std::vector<Subcommand> commands{add_plan(app),   add_drive(app),      add_batch(app),
                                   add_info(app),   add_algorithms(app), add_generate(app),
                                   add_verify(app), add_study(app),      add_tune(app),
                                   add_arm(app),    add_help(app)};
  for (auto& command : commands) {
    command.app->allow_extras();
    for (CLI::Option* option : command.app->get_options({}))
      if (option->get_items_expected_max() > 0) option->check(not_empty);
  }
  return commands;
}

}  // namespace lasius::tool
