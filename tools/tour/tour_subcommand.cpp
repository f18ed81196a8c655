// lasius tour.
#include <algorithm>
#include <memory>
#include <utility>

#include "tools/bitmap/cost_layers.h"
#include "tools/command_line/map_options.h"
#include "tools/console/kinds.h"
#include "tools/console/parameters.h"
#include "tools/options/commands.h"
#include "tools/record/outputs.h"
#include "tools/tour/tour_kind.h"
#include "tools/tour/tsplib_problem.h"

namespace lasius::tool {
namespace {

constexpr std::array<std::string_view, 7> kTourEndings{".json", ".csv", ".svg", ".png",
                                                       ".yaml", ".yml", ".html"};

constexpr const char* kTourOutputs =
    "Write a file, by its ending (repeatable):\n"
    ".json  what --json prints\n"
    ".csv  x,y of the path along all legs; with --frame world x_m,y_m; of several robots with a "
    "column robot; of TSPLIB the order\n"
    ".svg, .png  the map, the tour, and its stops by their names or numbers\n"
    ".yaml, .yml  the poses along the tour as ROS nav_msgs/Path, as plan writes them; of several "
    "robots a document each\n"
    ".html  a page of the map, the tour, and its legs, that needs nothing else";

/// @throws UsageError where an option of maps is given with a problem of TSPLIB.
void check_tsplib(const OptionTable& table, const RunOptions& run) {
  table.refuse({"--stops", "--cover", "--start", "--goal", "--capacity", "--frame", "--radius",
                "--unknown-free", "--prepare", "--prepared", "--corners", "--cost", "--inflation",
                "--most-stops", "--spacing", "--vehicle"},
               " is for maps, and " + run.map.file + " is a problem of TSPLIB; leave it out");
  const auto picture = std::ranges::find_if(run.outputs, [](const auto& file) {
    return is_picture(file) || is_yaml(file) || is_page(file);
  });
  if (picture != run.outputs.end())
    throw UsageError("-o " + *picture +
                     ": pictures, poses and pages are of tours on maps; give .json or .csv");
}

/// @throws UsageError where an option of bitmaps is given with a polygon world.
void check_polygons(const OptionTable& table, const RunOptions& run) {
  refuse_radius(table);
  table.refuse({"--cover", "--vehicle", "--frame", "--unknown-free", "--prepare", "--prepared",
                "--corners", "--cost", "--inflation", "--spacing"},
               " is for bitmaps, and " + run.map.file + " is a polygon world; leave it out");
  const auto other = std::ranges::find_if(
      run.outputs, [](const auto& file) { return is_yaml(file) || is_page(file); });
  if (other != run.outputs.end())
    throw UsageError("-o " + *other +
                     ": poses and pages are of tours on bitmaps; give .json, .csv, .svg or .png");
}

/// @throws UsageError for what does not go with the number of robots.
void check_robots(const OptionTable& table, const TourCommand& tour) {
  if (tour.robots.size() < 2)
    return table.refuse({"--most-stops"},
                        " is for several robots; give each its --start, or leave it out");
  if (tour.goal)
    throw UsageError("--goal: " + std::to_string(tour.robots.size()) +
                     " robots end where they began, or with --open anywhere; leave it out");
  if (tour.ants.algorithm() != "exact")
    throw UsageError("--algorithm " + tour.ants.algorithm() +
                     ": ants know no tours of several robots; leave it out");
  table.refuse({"--capacity"}, ": tours of several robots have no loads; leave it out");
}

/// @throws UsageError where an option of stops is given with --cover.
void check_cover(const OptionTable& table, const RunOptions& run) {
  table.refuse({"--stops", "--goal", "--capacity", "--most-stops", "--cost", "--inflation",
                "--target-gap", "--preset"},
               " is for tours of stops; leave it or --cover out");
  if ((!run.algorithm.empty() && run.algorithm != kLegAlgorithm) || !run.settings.empty())
    throw UsageError("--algorithm and --set are for tours of stops; leave them or --cover out");
  const auto starts = table.in_order("--start").size();
  if (starts > 1)
    throw UsageError("--start is given " + std::to_string(starts) +
                     " times, and one robot covers the map; give one --start");
}

}  // namespace

Subcommand add_tour(CLI::App& app) {
  struct Text : TourCommand {
    std::string goal_text;
    std::vector<std::string> starts;
    int capacity_given = 0, most_given = 0;
    double cover_given = 0;
    VehicleCommand driven;
  };
  auto text = std::make_shared<Text>();
  OptionTable table(
      app, "tour",
      "Visit many stops of a map in a short order, with a bound that no order is below");
  table.file(
      "--stops", text->stops_file,
      "The stops: a TSV with columns x and y, JSON [[x, y], ...] or GeoJSON points; cells, points "
      "with decimals, or metres with --frame world; with \"name\", \"after\" (names that come "
      "before), \"load\" and \"group\" (of which one stop is visited)",
      {".tsv", ".json", ".geojson"});
  table.real("--cover", text->cover_given, 0, kNoLimit,
             "In place of stops: cover the map with a tool that works on WIDTH cells (metres with "
             "--frame world), by swaths side by side; its centre keeps --radius",
             "WIDTH");
  table.file("--vehicle", text->driven.file,
             "A vehicle goes, of this footprint and smallest turn (see lasius help vehicles), by "
             "motions whose sweep meets nothing; stops have a yaw (a column, or [x, y, yaw]), or "
             "the best of eight headings; start and goal are X,Y,YAW",
             kDocuments);
  table.flag("--open", text->open, "End at the last stop (default: back at the first)");
  table.repeatable("--start", text->starts,
                   "Where the tour begins: a stop, or one more; given several times a robot begins "
                   "at each, and all together go the shortest way",
                   "X,Y");
  table.text("--goal", text->goal_text,
             "Where it ends, open: a stop, or one more; the same as --start: closed", "X,Y");
  table.integer("--capacity", text->capacity_given, 0, TourCommand::kMostLoad,
                "The most that is carried at any time, by the stops' loads (default: any load)",
                "K");
  table.integer("--most-stops", text->most_given, 1, TourCommand::kMostLoad,
                "The most stops that one of several robots visits (default: any number)", "N");
  table.real("--spacing", text->run.spacing, 1e-4, kNoLimit,
             "How far apart the poses of a .yaml are at most; in cells, metres with --frame world "
             "(default half a cell)",
             "S");
  table.integer("--generations", text->generations, 0, TourCommand::kMostGenerations,
                "Generations of tours that recombine, above 12 stops (default 20)", "N");
  table
      .file("MAP", text->run.map.file,
            "Map: .map, PBM, PGM, PNG, BMP or ROS YAML; a polygon world; or a problem of TSPLIB, "
            ".tsp or .sop",
            [] {
              auto endings = map_endings(true);
              endings.emplace_back(".tsp");
              endings.emplace_back(".sop");
              return endings;
            }())
      ->required();
  add_run_options(table, text->run,
                  {.seed = "Seed, from 0 to 2^53-1 (default 1)",
                   .time_limit = "Stop the search after this time",
                   .target_gap = "Stop at this certified gap (1 means 1%)",
                   .json = "Print one JSON object",
                   .outputs = kTourOutputs,
                   .endings = kTourEndings});
  add_cost_options(table, text->run.map.costs);
  add_world_options(table, text->world);
  table["--gap"]->description("No effect: a tour always tells its certified gap");
  table["--goal-tolerance"]->group(kRefused);
  return table.command(
      {.examples = {{"lasius tour maps/grid30a.map --stops stops.tsv -o tour.png",
                     "a closed tour, and a picture of it"},
                    {"lasius tour maps/grid30a.map --stops stops.json --start 0,0 --open --json",
                     "from the depot to the last stop"},
                    {"lasius tour maps/grid30a.map --stops stops.tsv --start 0,0 --start 29,29 -o "
                     "tours.yaml",
                     "by two robots, and their poses for ROS"},
                    {"lasius tour maps/grid30a.map --stops stops.tsv --algorithm mmas --ants 10",
                     "by a published colony"},
                    {"lasius tour maps/grid30a.map --cover 2 --start 0,0 -o cover.png",
                     "cover the map in strips of two cells"}},
       .exits = {{kFound, "a tour was found; stops that it leaves out are named"},
                 {kBadFile, "map, stops or problem are missing or broken"},
                 {kInvalidQuery, "start or goal outside or blocked, or no stop is free"},
                 {kUnreachable,
                  "start, goal or a robot's start cannot be reached from another, or no order "
                  "keeps what "
                  "is given"},
                 {kNoPath, "no order was found that keeps the capacity"},
                 kOutput,
                 {kInterrupted, "interrupted, the best so far written"}},
       .json = "tours/JSON of a tour"},
      [=](const Call& call) {
        TourCommand& tour = *text;
        RunOptions& run = tour.run;
        run.called = call.line;
        const bool polygons = is_polygon_file(run.map.file);
        if (polygons)
          check_polygons(table, run);
        else
          refuse_world_options(table);
        table.refuse({"--goal-tolerance"},
                     ": a tour leaves out what it cannot reach; leave it out");
        if (is_tsplib(run.map.file))
          check_tsplib(table, run);
        else if (table.given("--cover"))
          check_cover(table, run);
        else
          require("", "--stops or --cover", tour.stops_file);
        if (table.given("--cover")) tour.cover = text->cover_given;
        if (table.given("--capacity")) tour.capacity = text->capacity_given;
        if (table.given("--most-stops")) tour.most_stops = text->most_given;
        const SearchOptions asked = run;
        run.algorithm = kLegAlgorithm;
        run.settings.clear();
        run.named.clear();
        finish_run(run);
        run.algorithm = asked.algorithm;
        run.settings = asked.settings;
        run.named = asked.named;
        refuse_repeats(run.settings);
        choose_ants(tour);
        if (run.ranged) table.refuse({"--seed"}, ": one tour has one seed; a range is for plan");
        if (std::exchange(run.with_optimum, false))
          run.notes.emplace_back("--gap has no effect: a tour always tells its certified gap");
        run.inputs.push_back(tour.stops_file);
        const CostLayers& costs = run.map.costs;
        for (const auto& layer : costs.layers) run.inputs.push_back(layer.file);
        if (run.map.prepare && (!costs.layers.empty() || costs.inflation)) {
          run.map.prepare = false;
          run.notes.push_back(run.map.unprepared_note());
        }
        const Frame frame = polygons ? Frame::world : run.frame;  // any numbers
        if (!text->driven.file.empty()) {
          take_vehicle(table, tour, text->driven, text->starts, text->goal_text);
          return run_command(tour);
        }
        if (run.spacing && std::ranges::none_of(run.outputs, is_yaml))
          run.notes.emplace_back("--spacing has no effect without --vehicle or -o FILE.yaml");
        for (const std::string& start : text->starts)
          tour.robots.push_back(point_value("--start", start, frame));
        if (!text->goal_text.empty())
          tour.goal = PoseEnd{point_value("--goal", text->goal_text, frame)};
        check_robots(table, tour);
        if (tour.robots.size() == 1) tour.start = PoseEnd{std::exchange(tour.robots, {}).front()};
        return run_command(tour);
      });
}

}  // namespace lasius::tool
