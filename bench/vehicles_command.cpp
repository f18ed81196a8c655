// lasius_bench vehicles: what plans of a vehicle cost and come to, on pairs of poses.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/report.h"
#include "core/vehicle/lattice.h"
#include "core/vehicle/sweep.h"
#include "lasius/error.h"
#include "lasius/generate.h"
#include "lasius/map_io.h"
#include "lasius/vehicle/planner.h"
#include "tests/oracle/vehicle/footprint_judge.h"

namespace lasius::bench {
namespace {

using vehicle::Pose;

struct VehicleOptions {
  std::string folder, maps;
  std::string kind = "reversing";
  double limit = 5;
  double cusp_cost = 0;
  double reverse_cost = 2;
  double inflation = 0;
  double curvature_rate = 0;
  bool smooth = true;
  int generated = 0;
  std::string markdown;
};

using PosePairs = std::vector<std::pair<Pose, Pose>>;

PosePairs read_pairs(const std::filesystem::path& file) {
  std::ifstream in(file);
  PosePairs pairs;
  for (Pose a, b; in >> a.x >> a.y >> a.yaw >> b.x >> b.y >> b.yaw;) pairs.emplace_back(a, b);
  if (pairs.empty() || !in.eof())
    throw Error(ErrorCode::file_broken, {.file = file.string()}, "a line is not x y yaw x y yaw",
                "give six numbers a line");
  return pairs;
}

PosePairs random_pairs(const vehicle::Space& space, const Grid& grid, int count) {
  std::mt19937_64 random(1);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto draw = [&] {
    Pose pose;
    for (int tries = 0; tries < 100000; ++tries) {
      pose = {grid.width() * unit(), grid.height() * unit(), 6.28 * unit()};
      if (space.free(pose)) break;
    }
    return pose;
  };
  PosePairs pairs;
  for (int i = 0; i < count; ++i) {
    const Pose start = draw();
    pairs.emplace_back(start, draw());
  }
  return pairs;
}

vehicle::Vehicle vehicle_of(const VehicleOptions& options) {
  vehicle::Vehicle made = vehicle::car(vehicle::rectangle(6, 6, 4), 8);
  made.reverse = options.kind == "reversing";
  made.rotate_in_place = options.kind == "in-place";
  made.cusp_cost = options.cusp_cost;
  made.reverse_cost = options.reverse_cost;
  made.curvature_rate = options.curvature_rate;
  return made;
}

// Masks of the lattice that are looked at in a second, in millions, at cells where the footprint
// fits.
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

void measure_vehicle(const std::string& name, const Grid& grid, const PosePairs* given,
                     const VehicleOptions& options, Table& table) {
  const ThreadStopwatch preparing;
  CostField costs(grid.width(), grid.height());
  // As Nav2's default has it, at 0.05 m a cell.
  if (options.inflation > 0)
    costs.add(grid, {.radius = 14, .scaling = 0.15, .weight = options.inflation, .inscribed = 4});
  const vehicle::Planner planner = *vehicle::Planner::make(
      grid, vehicle_of(options), {}, options.inflation > 0 ? &costs : nullptr);
  const double prepared = 1e3 * preparing.seconds();
  const PosePairs pairs = given != nullptr ? *given : random_pairs(planner.space(), grid, 10);
  std::vector<double> times, gaps;
  oracle::FootprintJudge judge(grid, planner.space().vehicle().footprint);
  int found = 0, touching = 0;
  double length = 0, cusps = 0, cost = 0, corners = 0;
  for (const auto& [start, goal] : pairs) {
    vehicle::Request request{.start = start, .goals = {goal}};
    request.smooth = options.smooth;
    request.stop.deadline = deadline_in(std::chrono::duration<double>(options.limit));
    const ThreadStopwatch watch;
    const vehicle::Result result = planner.plan(request);
    times.push_back(1e3 * watch.seconds());
    if (result.goal < 0) continue;
    ++found;
    length += result.length;
    cost += result.cost;
    cusps += result.cusps;
    corners += result.corners;
    gaps.push_back(100 * result.gap().value_or(0));
    std::vector<oracle::Motion> path;
    for (const vehicle::Segment& s : result.segments)
      path.push_back({s.begin.x, s.begin.y, s.begin.yaw, s.curvature, s.length, s.gear, s.angle,
                      s.curvature_rate});
    touching += judge.first_touch(path) ? 1 : 0;
  }
  double sum = 0;
  for (const double time : times) sum += time;
  const auto count = static_cast<double>(times.size());
  table.row(name + " (" + std::to_string(pairs.size()) + ")",
            {1.0 * found, 1.0 * touching, median(times), sum / count, quantile(times, 0.95),
             largest(times), length / std::max(1, found), cost / std::max(1, found),
             gaps.empty() ? 0 : median(gaps), cusps / std::max(1, found),
             corners / std::max(1, found), prepared, million_checks(planner.space())});
}

void run_vehicles(const VehicleOptions& options) {
  namespace fs = std::filesystem;
  Table table("A rectangle of 12 x 8 cells, radius 8, " + options.kind +
                  "; milliseconds of processor time a plan, bound included" +
                  (options.smooth ? ", smoothed" : ", not smoothed") +
                  "; touching: by separating axes every 0.05 cells.",
              {"map (pairs)", "found", "touching", "median", "mean", "95%", "most", "length",
               "cost", "gap %, median", "cusps", "corners", "prepared, ms", "motions / us"},
              options.markdown);
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
    const PosePairs pairs = read_pairs(file);
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
  add_output(command, options.markdown);
}

}  // namespace lasius::bench
