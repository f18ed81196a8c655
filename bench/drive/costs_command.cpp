// lasius_bench drive-costs: replanning over costs that change, against a search from anew.
#include <algorithm>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/cost/planner.h"
#include "lasius/drive/drive.h"

namespace lasius::bench {
namespace {

struct CostDriveOptions {
  MapOptions maps = {};
  std::size_t count = 3;
  double sense = 40;
  int people = 8;
  int every = 25;
};

constexpr Inflation kInflation{.radius = 11, .scaling = 0.5, .weight = 4, .inscribed = 4};

/// Squares of 8 cells that go to and fro across the way: each beside another of its points.
Changes people_on(const Grid& grid, const std::vector<Cell>& way, int count) {
  constexpr int kSide = 8, kAside = 24;
  Changes changes;
  for (int i = 0; i < count; ++i) {
    const Cell at = way[(way.size() - 1) * static_cast<std::size_t>(i + 1) / (count + 1)];
    const auto inside = [](int v, int side) { return std::clamp(v, 0, side - kSide); };
    const int x = inside(at.x - kSide / 2, grid.width());
    const int y = inside(at.y - kSide / 2, grid.height());
    changes.obstacles.push_back(
        {.width = kSide,
         .height = kSide,
         .speed = 0.6,
         .track = {{inside(x - kAside, grid.width()), inside(y - kAside, grid.height())},
                   {inside(x + kAside, grid.width()), inside(y + kAside, grid.height())}}});
  }
  return changes;
}

/// Of one drive, milliseconds and ratios.
struct Figures {
  std::vector<double> ticks, first, anew, dearer;
};

void drive_one(const QuerySet& set, const Query& query, const CostDriveOptions& options,
               Figures& figures) {
  Navigator navigator(Grid(set.grid), query.goal, {.inflation = kInflation});
  const ThreadStopwatch watch;
  const auto cells = [&] {
    std::vector<Cell> way;
    for (const Point p : navigator.step(query.start).path)
      way.push_back({static_cast<int>(p.x), static_cast<int>(p.y)});
    return way;
  }();
  figures.first.push_back(1000 * watch.seconds());
  if (cells.size() < 2) return;
  const Changes changes = people_on(set.grid, cells, options.people);
  const DriveObserver compare = [&](const DriveTick& tick) {
    if (tick.way == nullptr || tick.way->path.empty() || tick.tick % options.every != 0) return;
    CostField costs(set.grid.width(), set.grid.height());
    costs.add(navigator.map(), kInflation);
    const CostPlanner planner(Planner(Grid(navigator.map())), costs);
    const ThreadStopwatch again;
    const CostResult walk =
        planner.plan({.start = tick.robot, .goal = query.goal}, {.eight_moves = true});
    figures.anew.push_back(1000 * again.seconds());
    if (walk.cost > 0) figures.dearer.push_back(tick.way->cost / walk.cost);
  };
  const ThreadTime time;
  const DriveResult driven = drive(
      navigator, set.grid, query.start, changes,
      {.sense = options.sense, .max_ticks = 20'000, .stop = {.time = &time}, .observer = compare});
  for (const Replan& replan : driven.replans)
    if (replan.tick > 0) figures.ticks.push_back(replan.ms);
}

void run_drive_costs(const CostDriveOptions& options) {
  Table table("Drives over the inflation of maps and of " + std::to_string(options.people) +
                  " people (8 x 8 cells) who cross the way, a sensor of " +
                  std::to_string(static_cast<int>(options.sense)) + " cells, " +
                  std::to_string(options.count) +
                  " queries a map. Milliseconds of processor time: of a tick that plans, of the "
                  "first plan, and of the cheapest walk sought from anew (its costs ready made); "
                  "the way's cost to that walk's.",
              {"map", "ticks", "p50", "p99", "max", "first", "anew", "cost"});
  for (const QuerySource& source : sources_of(options.maps)) {
    const QuerySet set = load(source, options.count);
    Figures f;
    for (const Query& query : set.queries) drive_one(set, query, options, f);
    if (f.ticks.empty() || f.anew.empty()) continue;
    table.row(set.name,
              {static_cast<double>(f.ticks.size()), median(f.ticks), quantile(f.ticks, 0.99),
               largest(f.ticks), median(f.first), median(f.anew), median(f.dearer)});
  }
  table.close("");
}

}  // namespace

void add_drive_costs_command(CLI::App& app) {
  auto [command, options] = add_command<CostDriveOptions>(
      app, "drive-costs", "replanning over costs that change", run_drive_costs);
  add_map_options(command, options.maps);
  add_number(command, "--queries", options.count, "queries a map", 1);
  add_number(command, "--sense", options.sense, "cells that the robot sees", 1);
  add_number(command, "--people", options.people, "who cross the way", 0, 100);
  add_number(command, "--every", options.every, "ticks between two searches from anew", 1);
}

}  // namespace lasius::bench
