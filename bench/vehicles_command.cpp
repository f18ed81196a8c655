// lasius_bench vehicles: what plans of a vehicle cost and come to, on pairs of poses.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/pose_pairs.h"
#include "bench/report.h"
#include "core/vehicle/lattice.h"
#include "core/vehicle/sweep.h"
#include "lasius/grid/generate.h"
#include "lasius/grid/map_io.h"
#include "lasius/vehicle/planner.h"
#include "tests/oracle/vehicle/motions.h"

namespace lasius::bench {
namespace {

using vehicle::Pose;

struct VehicleOptions : Reported {
  std::string folder, maps, graph;
  std::vector<double> world = {0.05, 0, 0, 0.25};
  std::vector<double> size = {12, 8};
  double radius = 8;
  std::string kind = "reversing";
  double limit = 5;
  double cusp_cost = 0;
  double reverse_cost = 2;
  double inflation = 0;
  double curvature_rate = 0;
  bool smooth = true, optimum = false;
  int generated = 0;
};

vehicle::Vehicle vehicle_of(const VehicleOptions& options) {
  const double half = options.size[0] / 2;
  vehicle::Vehicle made =
      vehicle::car(vehicle::rectangle(half, half, options.size[1] / 2), options.radius);
  made.reverse = options.kind == "reversing";
  made.rotate_in_place = options.kind == "in-place";
  made.cusp_cost = options.cusp_cost;
  made.reverse_cost = options.reverse_cost;
  made.curvature_rate = options.curvature_rate;
  return made;
}

// Millions of the lattice's masks looked at in a second, at cells where the footprint fits.
double million_checks(const vehicle::Space& space) {
  const vehicle::Space::Impl& map = space.impl();
  const vehicle::Lattice lattice(space.vehicle(), map.outline());
  std::mt19937_64 random(1);
  std::vector<std::pair<Cell, int>> asked;
  for (int tries = 0; asked.size() < 50000 && tries < 5000000; ++tries) {
    const Cell cell{static_cast<int>(random() % map.width()),
                    static_cast<int>(random() % map.height())};
    const int edge = static_cast<int>(random() % lattice.edges().size());
    const int heading = lattice.edges()[edge].from;
    if (lattice.masks().free(lattice.footprint(heading), map.bits(), cell.x, cell.y))
      asked.emplace_back(cell, edge);
  }
  constexpr int kRounds = 20;
  int free = 0;
  const ThreadStopwatch watch;
  for (int round = 0; round < kRounds; ++round) {
    for (const auto& [cell, edge] : asked)
      free += lattice.masks().free(lattice.edges()[edge].mask, map.bits(), cell.x, cell.y) ? 1 : 0;
  }
  const double seconds = watch.seconds();
  return free < 0 ? 0 : 1e-6 * kRounds * static_cast<double>(asked.size()) / seconds;
}

// What plans on one map come to.
struct VehicleTally {
  VehicleTally(const Grid& map, const vehicle::Space& of)
      : grid(map), space(of), judge(map, of.vehicle().footprint) {}

  void add(const vehicle::Result& result) {
    ++found;
    length += result.length;
    cost += result.cost;
    cusps += result.cusps;
    corners += result.corners;
    gaps.push_back(100 * result.gap().value_or(0));
    touching += judge.first_touch(oracle::motions_of(result.segments)) ? 1 : 0;
    misjudged += space.first_contact(result.segments) ? 1 : 0;
    plant(result.segments);
  }

  const Grid& grid;
  const vehicle::Space& space;
  oracle::FootprintJudge judge;
  std::mt19937_64 random{1};
  std::vector<double> times, gaps;
  int open = 0, found = 0, touching = 0, planted = 0, misjudged = 0, compared = 0;
  double length = 0, cusps = 0, cost = 0, corners = 0, above = 0;

 private:
  // Blocks a cell somewhere under the sweep: is it found, and not behind where it is touched first?
  void plant(std::span<const vehicle::Segment> path) {
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const vehicle::Segment& segment = path[random() % path.size()];
    const Pose at = segment.pose(unit() * segment.extent());
    const std::vector<Point>& footprint = space.vehicle().footprint;
    const Point corner = footprint[random() % footprint.size()];
    const double share = unit(), c = share * std::cos(at.yaw), s = share * std::sin(at.yaw);
    Grid with = grid;
    with.set_blocked({static_cast<int>(at.x + c * corner.x - s * corner.y),
                      static_cast<int>(at.y + s * corner.x + c * corner.y)});
    const auto touch =
        oracle::FootprintJudge(with, footprint).first_touch(oracle::motions_of(path));
    if (!touch) return;
    ++planted;
    const auto met = vehicle::Space(with, space.vehicle()).first_contact(path);
    misjudged += met && met->segment <= static_cast<int>(touch->motion) ? 0 : 1;
  }
};

void measure_vehicle(const std::string& name, const Grid& grid, const PosePairs* given,
                     const VehicleOptions& options, Table& table) {
  CostField costs(grid.width(), grid.height());
  // As Nav2's default has it, at 0.05 m a cell.
  if (options.inflation > 0)
    costs.add(grid, {.radius = 14, .scaling = 0.15, .weight = options.inflation, .inscribed = 4});
  // What depends on the vehicle alone is made with the first map.
  const ThreadStopwatch starting;
  const vehicle::Planner first(Grid(1, 1), vehicle_of(options));
  const double started = 1e3 * starting.seconds();
  const ThreadStopwatch preparing;
  const vehicle::Planner planner = *first.on(grid, {}, options.inflation > 0 ? &costs : nullptr);
  const double prepared = 1e3 * preparing.seconds();
  const PosePairs pairs = given != nullptr ? *given : random_pose_pairs(planner.space(), grid, 10);
  VehicleTally tally(grid, planner.space());
  for (const auto& [start, goal] : pairs) {
    vehicle::Request request{.start = start, .goals = {goal}, .smooth = options.smooth};
    request.stop.deadline = deadline_in(std::chrono::duration<double>(options.limit));
    const ThreadStopwatch watch;
    const vehicle::Result result = planner.plan(request);
    tally.times.push_back(1e3 * watch.seconds());
    tally.open += planner.space().free(start) && planner.space().free(goal) ? 1 : 0;
    if (result.goal < 0) continue;
    tally.add(result);
    if (!options.optimum) continue;
    request.weight = 1;
    request.smooth = request.bound = false;
    request.stop.deadline = deadline_in(std::chrono::duration<double>(options.limit));
    const vehicle::Result least = planner.plan(request);
    if (least.status != Status::solved) continue;
    ++tally.compared;
    tally.above += least.cost > 0 ? result.cost / least.cost : 1;
  }
  const double found = std::max(1, tally.found);
  const auto mean_time = std::accumulate(tally.times.begin(), tally.times.end(), 0.0) /
                         static_cast<double>(tally.times.size());
  table.row(
      name + " (" + std::to_string(pairs.size()) + ")",
      {1.0 * tally.open, 1.0 * tally.found, 1.0 * tally.touching, median(tally.times), mean_time,
       quantile(tally.times, 0.95), largest(tally.times), tally.length / found, tally.cost / found,
       tally.gaps.empty() ? 0 : median(tally.gaps), tally.cusps / found, tally.corners / found,
       started, prepared, million_checks(planner.space()), 1.0 * tally.planted,
       1.0 * tally.misjudged, 1.0 * tally.compared, tally.above / std::max(1, tally.compared)});
}

void run_vehicles(const VehicleOptions& options) {
  namespace fs = std::filesystem;
  Table table("A rectangle of " + short_number(options.size[0]) + " x " +
                  short_number(options.size[1]) + " cells, radius " + short_number(options.radius) +
                  ", " + options.kind + "; milliseconds of processor time a plan, bound included" +
                  (options.smooth ? ", smoothed" : ", not smoothed") +
                  "; open: both ends touch nothing; touching: by separating axes every 0.05 cells; "
                  "misjudged: paths, or contacts planted on them, that the certificate has wrong.",
              {"map (pairs)",   "open",    "found",     "touching",    "median",
               "mean",          "95%",     "most",      "length",      "cost",
               "gap %, median", "cusps",   "corners",   "vehicle, ms", "map, ms",
               "motions / us",  "planted", "misjudged", "weight 1's",  "cost to these"},
              options.markdown);
  if (!options.graph.empty()) {
    const auto& world = options.world;
    const Grid grid = read_map(options.maps, {.free_below = world[3]}).grid;
    const PosePairs pairs = pairs_of_graph(
        options.graph, {.resolution = world[0], .origin_x = world[1], .origin_y = world[2]},
        grid.height());
    measure_vehicle(fs::path(options.graph).stem().string(), grid, &pairs, options, table);
    return;
  }
  if (options.folder.empty()) {
    const int side = options.generated > 0 ? options.generated : 256;
    measure_vehicle("blobs", generate(MapKind::blobs, {.width = side, .height = side, .seed = 1}),
                    nullptr, options, table);
    return;
  }
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(options.folder)) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    const std::string map = file.stem().string() + ".map";
    fs::path from = fs::path(options.folder) / map;
    if (!fs::exists(from)) from = fs::path(options.maps) / map;
    const PosePairs pairs = read_pose_pairs(file);
    measure_vehicle(file.stem().string(), read_map(from.string()).grid, &pairs, options, table);
  }
}

}  // namespace

void add_vehicles_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "vehicles", "Plans of a vehicle on pairs of poses", run_vehicles);
  command.add_option("folder", options.folder,
                     "Pairs: NAME.txt, a line x y yaw x y yaw each; none: a generated map");
  command.add_option("--maps", options.maps, "Where a NAME.map is that the folder has not");
  command.add_option("--graph", options.graph,
                     "In place of a folder: a route graph in GeoJSON, whose nodes face the next; "
                     "its map is --maps");
  command.add_option("--world", options.world, "Of that: resolution, origin, free below")
      ->expected(4)
      ->capture_default_str();
  command.add_option("--size", options.size, "Length and width of the rectangle, cells")
      ->expected(2)
      ->capture_default_str();
  add_number(command, "--radius", options.radius, "Of the smallest turn, cells", 0.1, 1000);
  command.add_flag("--optimum", options.optimum, "Plan once more with weight 1, not smoothed");
  command.add_option("--kind", options.kind, "What it may do")
      ->check(CLI::IsMember({"reversing", "forward", "in-place"}))
      ->capture_default_str();
  add_number(command, "--limit", options.limit, "Seconds for a plan", 0.001, 1000);
  add_number(command, "--cusp-cost", options.cusp_cost, "Cells for a change of gear", 0, 1000);
  add_number(command, "--reverse-cost", options.reverse_cost, "Price of a reversed cell", 1, 1000);
  add_number(command, "--curvature-rate", options.curvature_rate,
             "By how much the curvature may change a cell, 1 / cells^2; 0: without limit", 0, 1000);
  add_number(command, "--inflation", options.inflation,
             "How much dearer a cell is beside what is blocked; 0: no costs", 0, 1000);
  add_number(command, "--generated", options.generated, "Side of the generated map", 64, 4096);
  command.add_flag("!--no-smooth", options.smooth, "Leave paths as the search has them");
}

}  // namespace lasius::bench
