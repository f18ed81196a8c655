// lasius drive.
#include <memory>
#include <numbers>
#include <utility>

#include "tools/bitmap/cost_layers.h"
#include "tools/command_line/map_options.h"
#include "tools/console/kinds.h"
#include "tools/console/parameters.h"
#include "tools/drive/drive_kind.h"
#include "tools/options/commands.h"
#include "tools/vehicle/vehicle_answer.h"

namespace lasius::tool {
namespace {

constexpr std::array<std::string_view, 6> kDriveEndings{".json", ".csv", ".svg",
                                                        ".png",  ".gif", ".html"};

constexpr const char* kDriveOutputs =
    "Write a file, by its ending (repeatable):\n"
    ".json  what --json prints\n"
    ".csv  x,y of the track, one cell a tick; with --frame world x_m,y_m\n"
    ".svg, .png  the track over the world: what was seen when, where ways were planned\n"
    ".gif  a film of at most 301 pictures\n"
    ".html  one page that plays the drive tick by tick";

/// How a drive over costs is asked for. @throws UsageError
void finish_costs(RunOptions& run) {
  const char* const option = run.map.costs.layers.empty() ? "--inflation" : "--cost";
  if (find_algorithm(run.params.algorithm()).kind != Algorithm::Kind::exact)
    throw UsageError(std::string(option) +
                     ": drives over costs are for exact; leave --algorithm out");
  if (run.target_gap > 0)
    throw UsageError("--target-gap: nothing is certified in a drive over costs; leave it out");
  if (std::exchange(run.map.prepare, false)) run.notes.push_back(run.map.unprepared_note());
  for (const auto& layer : run.map.costs.layers) run.inputs.push_back(layer.file);
}

/// How a vehicle's drive is asked for. @throws UsageError for what is of points and discs.
void finish_vehicle(const OptionTable& table, DriveCommand& drive, const std::string& start,
                    const std::vector<std::string>& goals) {
  RunOptions& run = drive.run;
  if (!run.algorithm.empty() && run.algorithm != lattice_algorithm().name)
    throw UsageError("--algorithm " + run.algorithm +
                     ": vehicles are planned by lattice alone; leave it out");
  run.algorithm.clear();
  VehicleCommand& vehicle = *drive.vehicle;
  if (table.given("--polish")) {
    constexpr std::array<std::string_view, 2> kPolish{"none", "taut"};
    vehicle.smooth = choice_value("--polish", table.in_order("--polish").front().second, kPolish);
    run.named.clear();
  }
  table.refuse({"--radius", "--set", "--ants", "--iterations", "--preset", "--neighbours",
                "--corners", "--prepare", "--prepared", "--target-gap"},
               " with --vehicle: it is of drives from cell to cell; leave it out");
  require("", "--start", start);
  require("", "--goal", goals.empty() ? "" : goals.front());
  finish_run(run);
  vehicle.start = pose_value("--start", start, run);
  for (const std::string& goal : goals) vehicle.goals.push_back(pose_value("--goal", goal, run));
  run.inputs.push_back(vehicle.file);
}

struct DriveText : DriveCommand {
  std::string start_text, sense_text;
  std::vector<std::string> goals;
  VehicleCommand driven;
};

void add_drive_options(OptionTable& table, const std::shared_ptr<DriveText>& text) {
  table.text("--start", text->start_text, "Where the robot starts", "X,Y");
  table.repeatable("--goal", text->goals,
                   "Where it is to go. Of a vehicle repeatable: one of them is met", "X,Y");
  table.file("--world", text->world,
             "What is really there, as large as MAP (default as MAP has it)", map_endings(false));
  table.file("--changes", text->changes,
             "What changes under way, a line each: TICK X Y [W H] blocked|free, or "
             "TICK move W H SPEED X Y [X Y]... for an obstacle that moves",
             {});
  table.text("--sense", text->sense_text,
             "How far the robot sees, in cells (metres with --frame world; default 20 cells)", "R");
  table.file("--vehicle", text->driven.file,
             "A vehicle drives, of this footprint and smallest turn (see lasius help vehicles), by "
             "motions whose sweep meets nothing; start and goal are X,Y,YAW",
             kDocuments);
  table.add("--heading-tolerance",
            "Of a vehicle: it may end turned so far from the goal's YAW (radians, or as in 15deg; "
            "180deg: any heading)",
            "ANGLE", [=](const auto& angle) {
              text->driven.heading_tolerance =
                  angle_value("--heading-tolerance", angle, 0, std::numbers::pi);
            });
  table.integer("--max-ticks", text->max_ticks, 0, DriveCommand::kMostTicks,
                "Moves and waits at most (default 1000000)", "N");
  table
      .file("MAP", text->run.map.file,
            "Map that the robot knows: .map, PBM, PGM, PNG, BMP or ROS YAML", map_endings(false))
      ->required();
  add_run_options(table, text->run,
                  {.seed = "Seed, from 0 to 2^53-1 (default 1)",
                   .time_limit = "Stop the drive after this time",
                   .target_gap = "Plan no further than to this certified gap (1 means 1%)",
                   .json = "Print one JSON object",
                   .outputs = kDriveOutputs,
                   .endings = kDriveEndings});
  add_cost_options(table, text->run.map.costs);
  table["--gap"]->description("No effect: a drive always tells the optimum of its moves");
  table["--prepared"]->group(kRefused);
  const auto refuse = [](const std::string&) {
    throw UsageError("--tracks: a drive's picture shows the robot's track; leave it out");
  };
  table.add("--tracks", "", "N,N,...", refuse)->group(kRefused);
}

/// What was asked, or a UsageError.
DriveCommand drive_asked(const OptionTable& table, const DriveText& text, const Call& call) {
  DriveCommand drive = text;
  RunOptions& run = drive.run;
  run.called = call.line;
  if (is_polygon_file(run.map.file))
    throw UsageError(run.map.file + ": drives are on bitmaps only");
  const bool prepare = run.map.prepare;
  if (!text.driven.file.empty()) {
    drive.vehicle = text.driven;
    finish_vehicle(table, drive, text.start_text, text.goals);
  } else {
    const std::string goal = text.goals.empty() ? "" : text.goals.back();
    if (text.goals.size() > 1)
      throw UsageError("--goal is given more than once; several goals are for --vehicle");
    table.refuse({"--heading-tolerance"}, " is for --vehicle; leave it out");
    static_cast<PlanCommand&>(drive) = plan_command(run, text.start_text, goal);
    drive.start = {end_value("--start", text.start_text, run.frame)};  // it goes from cell to cell
    drive.goal = {end_value("--goal", goal, run.frame)};
  }
  if (run.ranged) table.refuse({"--seed"}, ": one drive has one seed; a range is for plan");
  if (run.with_optimum)
    run.notes.emplace_back("--gap has no effect: a drive always tells the optimum of its moves");
  run.map.prepare = prepare && !moves_on_cells(run.params);
  if (run.map.costs.asked()) finish_costs(run);
  if (!run.map.prepared.empty())
    throw UsageError("--prepared is for plan and batch: a drive changes its map");
  run.inputs.insert(run.inputs.end(), {drive.world, drive.changes});
  if (!text.sense_text.empty())
    drive.sense =
        real_value("--sense", text.sense_text,
                   run.map.radius_metres ? 0 : DriveCommand::kLeastSense, DriveCommand::kMostSense);
  return drive;
}

}  // namespace

Subcommand add_drive(CLI::App& app) {
  auto text = std::make_shared<DriveText>();
  OptionTable table(app, "drive",
                    "Drive a robot through a world that is not as its map has it, and changes");
  add_drive_options(table, text);
  return table.command(
      {.examples =
           {{"lasius drive maps/grid30a.map --start 0,0 --goal 29,29 --sense 3 -o run.png",
             "a robot that sees three cells far, and a picture of its way"},
            {"lasius drive maps/free-space-simple.map --start 0,0 --goal 9,9 --sense 2 --world "
             "maps/free-space-average.map --json",
             "a world that is not as the map has it"}},
       .exits = {{kFound, "the robot arrived"},
                 {kBadFile, "map, world or changes are missing or broken"},
                 {kInvalidQuery, "start or goal outside or blocked"},
                 {kUnreachable, "proven unreachable on what is known at last"},
                 {kNoPath, "not arrived: trapped, or a limit spent"},
                 kOutput,
                 {kInterrupted, "interrupted, the drive so far written"}},
       .json = "driving/JSON of a drive"},
      [=](const Call& call) { return run_command(drive_asked(table, *text, call)); });
}

}  // namespace lasius::tool
