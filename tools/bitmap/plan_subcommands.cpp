// lasius plan, lasius batch.
#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <utility>

#include "tools/bitmap/bitmap_problem.h"
#include "tools/command_line/map_options.h"
#include "tools/console/crew.h"
#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/options/commands.h"
#include "tools/record/outputs.h"

namespace lasius::tool {
namespace {

constexpr std::array<std::string_view, 8> kPlanEndings{".json", ".csv",  ".svg", ".png",
                                                       ".html", ".yaml", ".yml", ".proof.cbor"};
constexpr std::span<const std::string_view> kBatchEndings = std::span(kPlanEndings).first(4);

constexpr const char* kOutputs =
    "Write a file, by its ending (repeatable):\n"
    ".json  what --json prints\n"
    ".csv  iteration,best,mean,arrived by iteration; x,y of the path for algorithms without "
    "iterations, with --spacing x,y,yaw of its poses; for batch a line a query; with --frame world "
    "in metres: best_m, x_m, ...\n"
    ".svg, .png  map, tracks, pheromone, path and convergence; for batch all paths; for polygon "
    "worlds MAKLINK lines, midpoints, Dijkstra's path, path and convergence\n"
    ".html  one page that plays the run, opens from disk and needs no network; not for batch\n"
    ".yaml, .yml  the poses along the path as ROS nav_msgs/Path, in metres of a ROS map's frame, "
    "else in cells, y down; not for batch";

constexpr SearchHelp kRunHelp = {
    .seed =
        "Seed, from 0 to 2^53-1 (default 1). A-B or A..B: every query with each of these seeds, "
        "a JSON object a line, from plan too, which ends with 0 where any of them returned a path",
    .time_limit =
        "Stop after this time, counted once the map is prepared; for batch by query. "
        "Each optimum of --gap may take as long again",
    .target_gap = "Stop at this certified gap, for algorithms that certify one (1 means 1%)",
    .json = "Print one JSON object (batch always does, one a query)",
    .outputs = kOutputs,
    .endings = kPlanEndings};

/// Of `plan` and `batch`, not of drives.
void add_tracks(OptionTable& table, RunOptions& to) {
  table.add("--tracks",
            "Iterations of which a picture shows the tracks (default: 1, the critical time, 50, "
            "the last)",
            "N,N,...",
            [&to](const auto& text) { to.track_iterations = list_value("--tracks", text); });
}

/// Of `plan` and `batch`, not of drives.
void add_islands(OptionTable& table, RunOptions& to) {
  add_parameter(table, "--islands", to,
                "Split a colony into so many islands (alone: 8), each with its share of the ants, "
                "that learn by each other's best tours (parameter exchange_every)",
                "N");
  add_parameter(table, "--exchange", to,
                "By which tour an island learns: scheduled, by that of the island before it; "
                "asynchronous, by the best that has arrived: no thread or rank waits for another, "
                "and two runs may differ",
                "scheduled|asynchronous");
}

/// Of `plan` and `batch`, not of drives.
void add_costs(OptionTable& table, CostLayers& to) {
  add_cost_options(table, to);
  table.add("--moves",
            "With costs 8: the cheapest walk by moves to eight neighbours, from centre to centre, "
            "to compare with other planners",
            "8", [&to](const auto& text) {
              (void)integer_value("--moves", text, 8, 8);
              to.eight_moves = true;
            });
}

/// How a plan over costs is asked for. @throws UsageError
void finish_costs(RunOptions& run, bool batch) {
  CostLayers& costs = run.map.costs;
  const bool proof = std::ranges::any_of(run.outputs, is_proof);
  const std::string option = !costs.layers.empty() ? "--cost"
                             : costs.inflation     ? "--inflation"
                             : costs.eight_moves   ? "--moves"
                                                   : "";
  if (option.empty()) {
    if (proof) throw UsageError("-o of a proof is for plans over --cost or --inflation");
    return;
  }
  const Algorithm::Kind kind = find_algorithm(run.params.algorithm()).kind;
  if (kind == Algorithm::Kind::genetic)
    throw UsageError(option + " is for exact and colonies; " + std::string(run.params.algorithm()) +
                     " plans by length alone");
  if (kind == Algorithm::Kind::colony && (proof || costs.eight_moves))
    throw UsageError(std::string(proof ? "-o of a proof" : "--moves") +
                     " is for exact; leave --algorithm out");
  if (kind == Algorithm::Kind::colony && run.params.corners == Corners::allow)
    throw UsageError("--corners allow: paths over costs squeeze nowhere; use forbid or one-side");
  if (run.map.radius > 0 && (proof || costs.eight_moves))
    throw UsageError(std::string(proof ? "-o of a proof" : "--moves") +
                     " is for a point; leave --radius out");
  if (proof && !run.via.empty())
    throw UsageError("-o of a proof is for one plan: leave --via out, or prove each part");
  if (kind == Algorithm::Kind::exact && std::exchange(run.with_optimum, false))
    run.notes.push_back("--gap has no effect over costs: `gap` is certified");
  if (proof && (costs.eight_moves || batch))
    throw UsageError("-o of a proof is for one plan of any angle");
  if (run.map.prepare) {
    run.notes.push_back(run.map.unprepared_note());
    run.map.prepare = run.map.labels = false;
    run.map.prepared.clear();
  }
  for (const auto& layer : costs.layers) run.inputs.push_back(layer.file);
  costs.proof = proof;
}

void add_spacing(OptionTable& table, RunOptions& to) {
  constexpr double kLeast = 1e-4;
  table.real("--spacing", to.spacing, kLeast, kNoLimit,
             "Add poses to the JSON: x, y and yaw of places along the path that are at most S "
             "apart, its vertices among them; in cells, metres with --frame world (a file of poses "
             "takes half a cell without)",
             "S");
}

void add_alternatives(OptionTable& table, RunOptions& to) {
  table.add("--alternatives",
            "Add N other ways at most that differ from the shortest one, each at most 1.3 times as "
            "long (exact, for a point)",
            "N", [&to](const auto& text) {
              to.alternatives = static_cast<int>(
                  integer_value("--alternatives", text, 1, Request::kMostAlternatives));
            });
}

/// @throws UsageError where there are none to be had.
void check_alternatives(const RunOptions& run) {
  if (run.alternatives == 0) return;
  const auto refuse = [](const std::string& why) {
    throw UsageError("--alternatives are ways beside a shortest path: " + why);
  };
  if (find_algorithm(run.params.algorithm()).kind != Algorithm::Kind::exact)
    refuse("they are exact's; leave --algorithm out");
  if (run.map.radius > 0) refuse("a disc has none; leave --radius out");
  if (run.map.costs.asked()) refuse("over costs there are none; leave --cost and --inflation out");
  if (!run.via.empty()) refuse("leave --via out, or ask for those of each part");
  if (run.target_gap > 0) refuse("leave --target-gap out");
}

/// What is typed of `plan` and `batch`, on bitmaps and among polygons.
struct PlanText {
  RunOptions run;
  WorldOptions world;
  VehicleCommand vehicle;
  std::string start, queries;
  std::vector<std::string> goals;  ///< several for a vehicle alone
  std::vector<std::string> via;

  /// @throws UsageError where there are several
  std::string goal() const {
    if (goals.size() > 1)
      throw UsageError("--goal is given more than once; several goals are for --vehicle");
    return goals.empty() ? "" : goals.front();
  }
};

void add_via(OptionTable& table, PlanText& to) {
  table.repeatable("--via", to.via,
                   "Go through this cell or point on the way (repeatable, in order)", "X,Y");
}

void add_vehicle(OptionTable& table, VehicleCommand& to) {
  table.file("--vehicle", to.file,
             "The robot has this footprint and smallest turn (YAML or JSON, see lasius help "
             "vehicles): its motions touch nothing over their whole sweep; start and goal are "
             "X,Y,YAW, YAW in radians or, as in 90deg, degrees, from +x towards +y",
             kDocuments);
  table.add("--heading-tolerance",
            "Of a vehicle: the path may end turned so far from the goal's YAW (radians, or as in "
            "15deg; 180deg: any heading); --goal-tolerance is of its point",
            "ANGLE", [&to](const auto& text) {
              to.heading_tolerance = angle_value("--heading-tolerance", text, 0, std::numbers::pi);
            });
}

/// `plan` and `batch` of a vehicle. @throws UsageError for what is of points and discs.
VehicleCommand vehicle_command(const OptionTable& table, const PlanText& text) {
  VehicleCommand command = text.vehicle;
  command.run = text.run;
  command.queries = text.queries;
  RunOptions& run = command.run;
  if (is_polygon_file(run.map.file))
    throw UsageError("--vehicle is for bitmaps; a polygon world's robot is a disc, --margin");
  constexpr const char* kLattice = "lattice";
  if (!run.algorithm.empty() && run.algorithm != kLattice)
    throw UsageError("--algorithm " + run.algorithm +
                     ": vehicles are planned by lattice alone; leave it out");
  run.algorithm.clear();
  refuse_world_options(table);
  const auto refuse = [&](std::initializer_list<const char*> options, const std::string& why) {
    table.refuse(options, " with --vehicle: " + why + "; leave it out");
  };
  refuse({"--radius"}, "a vehicle's footprint is in its file");
  refuse({"--moves"}, "a vehicle's motions are its lattice's");
  refuse({"--via"}, "plan a vehicle from one pose to the next");
  refuse({"--alternatives"}, "they are of points");
  refuse({"--gap"}, "a vehicle's plan always tells its certified gap");
  refuse({"--ants", "--iterations", "--tracks", "--islands", "--exchange"}, "it is of colonies");
  refuse({"--set", "--preset", "--neighbours", "--corners"}, "it is of algorithms on cells");
  refuse({"--prepare", "--prepared"}, "a vehicle's map is prepared without");
  if (table.given("--polish")) {
    constexpr std::array<std::string_view, 2> kPolish{"none", "taut"};
    command.smooth = choice_value("--polish", table.in_order("--polish").front().second, kPolish);
    run.named.clear();
  }
  finish_run(run);
  run.inputs.push_back(command.file);
  if (run.ranged) table.refuse({"--seed"}, ": a vehicle's plan draws nothing; leave it out");
  if (run.target_gap > 0) run.notes.emplace_back("--target-gap has no effect with --vehicle");
  if (const auto proof = std::ranges::find_if(run.outputs, is_proof); proof != run.outputs.end())
    throw UsageError("-o " + *proof + ": a vehicle's bound is not written as a proof");
  if (!command.queries.empty()) {
    run.inputs.push_back(command.queries);
    return command;
  }
  require("", "--start", text.start);
  require("", "--goal", text.goals.empty() ? "" : text.goals.front());
  command.start = pose_value("--start", text.start, run);
  for (const std::string& goal : text.goals)
    command.goals.push_back(pose_value("--goal", goal, run));
  return command;
}

/// `plan` among polygons.
PolygonCommand polygon_command(const OptionTable& table, const PlanText& text) {
  PolygonCommand command{text.run, text.world, {}, {}, text.queries};
  finish_search(command);
  command.world.file = text.run.map.file;
  command.inputs = {command.world.file, command.preset_file, text.queries};
  if (!text.start.empty()) command.start = pair_value("--start", text.start, false);
  if (!text.goal().empty()) command.goal = pair_value("--goal", text.goal(), false);
  command.with_optimum = true;  // it is found beside
  if (text.run.frame == Frame::world)
    throw UsageError("--frame world: " + command.world.file +
                     " gives no frame, a polygon world is in its own coordinates; leave it out");
  refuse_radius(table);
  table.refuse({"--cost", "--inflation", "--moves", "--via", "--alternatives", "--spacing"},
               " is for bitmaps, and " + command.world.file + " is a polygon world; leave it out");
  if (const auto file = std::ranges::find_if(command.outputs, is_yaml);
      file != command.outputs.end())
    throw UsageError("-o " + *file + ": poses are for paths on bitmaps; write .json or .csv");
  for (const char* option : {"--frame", "--unknown-free", "--prepare", "--prepared", "--tracks"})
    if (table.given(option))
      command.notes.push_back(option + std::string(" has no effect") +
                              (option == std::string_view("--unknown-free")
                                   ? ": a polygon world has no unknown part"
                                   : " on a polygon world"));
  return command;
}

int run_plan(const OptionTable& table, PlanText& text, const Call& call) {
  RunOptions& asked = text.run;
  asked.called = call.line;
  const bool on_bitmap = text.vehicle.file.empty() && !is_polygon_file(asked.map.file);
  const bool one_search = text.queries.empty() && !asked.ranged;
  if (one_search && !on_bitmap) leave_to_leader();
  if (!text.vehicle.file.empty()) return run_command(vehicle_command(table, text));
  if (is_polygon_file(asked.map.file)) return run_command(polygon_command(table, text));
  refuse_world_options(table);
  table.refuse({"--heading-tolerance"}, " is for --vehicle; leave it out");
  asked.via.clear();
  for (const std::string& via : text.via)
    asked.via.push_back(point_value("--via", via, asked.frame));
  if (!text.queries.empty()) {
    finish_run(asked);
    check_alternatives(asked);
    finish_costs(asked, true);
    asked.inputs.push_back(text.queries);
    return run_bitmap_batch({asked, {}, {}, text.queries});
  }
  PlanCommand plan = plan_command(asked, text.start, text.goal());
  check_alternatives(plan.run);
  finish_costs(plan.run, plan.run.ranged);
  if (plan.run.ranged) return run_bitmap_batch(plan);
  if (!shares_islands(plan.run)) leave_to_leader();
  BitmapProblem problem(plan);
  return run(problem);
}

// What plans and batches both take.
void add_planning(OptionTable& table, PlanText& text, const SearchHelp& help) {
  add_run_options(table, text.run, help);
  add_islands(table, text.run);
  add_costs(table, text.run.map.costs);
  add_tracks(table, text.run);
  add_spacing(table, text.run);
  add_via(table, text);
  add_alternatives(table, text.run);
  add_vehicle(table, text.vehicle);
  add_world_options(table, text.world);
}

}  // namespace

Subcommand add_plan(CLI::App& app) {
  auto text = std::make_shared<PlanText>();
  OptionTable table(app, "plan", "Plan one path");
  table.text("--start", text->start,
             "Where the path starts: a cell, whole numbers, at its centre; with a decimal point a "
             "point; a polygon world may say",
             "X,Y");
  table.repeatable("--goal", text->goals,
                   "Where it ends; likewise. Of a vehicle repeatable: one of them is met", "X,Y");
  table.file("MAP", text->run.map.file, kMapHelp, map_endings(true))->required();
  add_planning(table, *text, kRunHelp);
  return table.command(
      {.examples = {{"lasius plan maps/fan400x200.map --start 14,14 --goal 380,179",
                     "the shortest path: status, length, vertices"},
                    {"lasius plan maps/fan400x200.map --start 14,14 --goal 380,179 "
                     "--algorithm mmas --iterations 20 --gap -o run.json -o run.png",
                     "a colony, its gap to the optimum, a result to verify and a picture"},
                    {"lasius plan maps/fan400x200.map --start 14,14 --goal 380,179 "
                     "--alternatives 2",
                     "the shortest path and two other ways"},
                    {"lasius plan maps/fan400x200.map --start 14,14 --goal 380,179 "
                     "--algorithm acs --islands 4 --ants 40 --iterations 20",
                     "a colony of four islands, each of ten ants"},
                    {"lasius plan maps/grid20a.map --start 0,0 --goal 19,19 --algorithm as "
                     "--set persistence=0.7 --seed 1-5",
                     "five seeds: a JSON object each"},
                    {"lasius plan world.map --start 1,2 --goal 36,25 --cost 'world.pfm*0.5' "
                     "--inflation 4,0.5,3 -o world.proof.json",
                     "the cheapest path over costs, with the proof of its bound"},
                    {"lasius plan world.map --vehicle car.yaml --start 4,4,0 --goal 33,25,90deg "
                     "-o drive.png",
                     "a car's motion from pose to pose, certified over its whole sweep"},
                    {"lasius plan maps/maklink200.geojson --algorithm maklink-acs",
                     "among polygons, whose file names start and goal"}},
       .exits = {{kFound, "a path was returned"},
                 {kBadFile, "a map is missing or broken"},
                 {kInvalidQuery, "start or goal outside or blocked"},
                 {kUnreachable, "proven unreachable"},
                 {kNoPath, "no path: limit or iterations spent"},
                 kOutput,
                 {kInterrupted, "interrupted, best so far written"}},
       .json = "program/JSON of a plan"},
      [=](const Call& call) { return run_plan(table, *text, call); });
}

Subcommand add_batch(CLI::App& app) {
  auto text = std::make_shared<PlanText>();
  OptionTable table(app, "batch", "Plan many paths on one map: JSON, one object a line");
  table.file("MAP", text->run.map.file, kMapHelp, map_endings(true))->required();
  SearchHelp help = kRunHelp;
  help.endings = kBatchEndings;
  add_planning(table, *text, help);
  table
      .file("QUERIES", text->queries,
            "A TSV or CSV with columns sx sy gx gy, with --vehicle syaw and gyaw too; of a bitmap "
            "also a MovingAI .scen",
            {".scen", ".tsv", ".csv", ".txt"})
      ->required();
  add_part(table, text->run.part,
           "Answer the I-th of N parts of the queries; `lasius merge` joins the parts' outputs");
  return table.command(
      {.examples = {{"lasius batch maps/fan400x200.map queries.tsv --prepare",
                     "a JSON object for each line of queries.tsv, which begins with sx sy gx gy"}},
       .exits = {{kFound,
                  "every query was answered, be it by status invalid, unreachable or no_path"},
                 {kBadFile, "map or queries are missing or broken, nothing printed"},
                 kOutput,
                 {kInterrupted, "interrupted, whole lines only"}},
       .json = "program/JSON of a plan"},
      [=](const Call& call) { return run_plan(table, *text, call); });
}

}  // namespace lasius::tool
