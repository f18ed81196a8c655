// lasius_bench drive: replanning under way against D* Lite and A*.
#include <algorithm>
#include <iostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/peers/bucket_astar.h"
#include "bench/peers/dstar_pilot.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/number_text.h"
#include "lasius/drive/drive.h"
#include "lasius/path/shortest_walk.h"

namespace lasius::bench {
namespace {

struct DriveOptions : QueryOptions {
  DriveOptions() : QueryOptions{.count = 5, .rounds = 3} {}
  double sense = 20;
  bool prepare = false;
};

/// A* from anew where the walk is blocked. It cannot be stopped; what has become free is not asked
/// whether it shortens the walk.
class AStarPilot final : public peers::GridPilot {
 public:
  using GridPilot::GridPilot;

  const Way& step(Cell robot, const StopCondition&) override {
    const bool kept = holds(robot);
    if (!kept) {
      peers::BucketAStar search(map());
      const Stopwatch watch;
      length_ = search.plan_cells(robot, goal(), walk_);
      searching_ms_ += 1000 * watch.seconds();
    }
    return tell(length_, walk_, !kept);
  }
  /// Spent on searches alone: looking up the moves of the changed map is left out.
  double searching_ms() const noexcept { return searching_ms_; }

 private:
  void changed(std::span<const Cell>, bool) override {}
  bool holds(Cell robot) {
    walk_.erase(walk_.begin(), std::find(walk_.begin(), walk_.end(), robot));
    for (std::size_t i = 1; i < walk_.size(); ++i) {
      const Cell a = walk_[i - 1], b = walk_[i];
      if (map().blocked(b) || map().blocked({a.x, b.y}) || map().blocked({b.x, a.y})) return false;
    }
    return !walk_.empty();
  }

  std::vector<Cell> walk_;
  double length_ = 0;  // of the walk when it was planned
  double searching_ms_ = 0;
};

Grid unknown(const QuerySet& set) { return {set.grid.width(), set.grid.height()}; }

Navigator navigator_of(const QuerySet& set, const Query& query, const DriveOptions& options) {
  NavigatorOptions how;
  if (options.prepare) how.prepare.emplace();
  return {unknown(set), query.goal, how};
}

DriveResult drive_navigator(const QuerySet& set, const Query& query, const DriveOptions& options) {
  Navigator navigator = navigator_of(set, query, options);
  return drive(navigator, set.grid, query.start, {}, {.sense = options.sense});
}

DriveResult drive_dstar(const QuerySet& set, const Query& query, const DriveOptions& options) {
  peers::DStarPilot pilot(unknown(set), query.start, query.goal);
  return drive(pilot, set.grid, query.start, {}, {.sense = options.sense});
}

DriveResult drive_astar(const QuerySet& set, const Query& query, const DriveOptions& options) {
  AStarPilot pilot(unknown(set), query.goal);
  DriveResult driven = drive(pilot, set.grid, query.start, {}, {.sense = options.sense});
  driven.planning_ms = pilot.searching_ms();
  return driven;
}

/// Lengths of the ways that were planned, to those of the shortest walks from the same cells on
/// what was known: what D* Lite finds there.
std::vector<double> ways(const QuerySet& set, const Query& query, const DriveOptions& options) {
  constexpr int kEvery = 8;  // a search from anew for each is long
  std::vector<double> ratios;
  int replans = 0;
  Navigator navigator = navigator_of(set, query, options);
  const auto look = [&](const DriveTick& tick) {
    if (!tick.replanned || tick.way == nullptr || replans++ % kEvery != 0) return;
    const auto walk =
        shortest_walk(tick.robot_knows->map(), tick.robot, query.goal, Neighbours::eight);
    if (walk && *walk > 0) ratios.push_back(tick.way->length / *walk);
  };
  (void)drive(navigator, set.grid, query.start, {}, {.sense = options.sense, .observer = look});
  return ratios;
}

/// What the queries of a map came to.
struct MapFigures {
  double lasius_ms = 0, dstar_ms = 0, astar_ms = 0;
  std::vector<double> ticks, dstar_ticks, travelled, ways;
};

/// A drive repeated `rounds` times: the least planning time counts, since noise only adds.
template <class Drive>
DriveResult best_of(int rounds, const Drive& drive) {
  DriveResult best = drive();
  for (int i = 1; i < rounds; ++i) {
    DriveResult driven = drive();
    if (driven.planning_ms < best.planning_ms) best = std::move(driven);
  }
  return best;
}

/// Of the ticks in which a way was planned.
void add_ticks(const DriveResult& driven, std::vector<double>& ticks) {
  for (const Replan& replan : driven.replans) ticks.push_back(replan.ms);
}

MapFigures measure(const QuerySet& set, const DriveOptions& options) {
  MapFigures figures;
  for (const Query& query : set.queries) {
    const auto best = [&](const auto& drive) {
      DriveResult driven = best_of(options.rounds, [&] { return drive(set, query, options); });
      if (driven.status == Status::solved) return driven;
      std::cerr << set.name << ": a drive from " << pair_text(query.start.x, query.start.y)
                << " to " << pair_text(query.goal.x, query.goal.y) << " did not arrive\n";
      throw CLI::RuntimeError(1);
    };
    const DriveResult own = best(drive_navigator), dstar = best(drive_dstar),
                      astar = best(drive_astar);
    figures.lasius_ms += own.planning_ms;
    figures.dstar_ms += dstar.planning_ms;
    figures.astar_ms += astar.planning_ms;
    add_ticks(own, figures.ticks);
    add_ticks(dstar, figures.dstar_ticks);
    figures.travelled.push_back(own.length / dstar.length);
    const auto more = ways(set, query, options);
    figures.ways.insert(figures.ways.end(), more.begin(), more.end());
  }
  return figures;
}

void run_drive(const DriveOptions& options) {
  Table table("Unknown maps, a sensor of " + number_text(options.sense) + " cells, at most " +
                  std::to_string(options.count) + " queries a map; the least of " +
                  std::to_string(options.rounds) +
                  " drives. Planning time of all drives: `exact` in a Navigator, as a share of D* "
                  "Lite's and of A*'s from anew; milliseconds of a tick that plans; travelled, to "
                  "D* Lite's (mean over queries); the ways planned, to the shortest walks there "
                  "(mean).",
              {"map", "ms", "/ D* Lite", "/ A*", "p50", "p99", "max", "D* Lite p99", "max",
               "travelled", "ways"});
  int sooner = 0, maps = 0;
  std::vector<double> travelled, ways;
  for (const QuerySource& source : sources_of(options.maps)) {
    const QuerySet set = load(source, options.count);
    const MapFigures f = measure(set, options);
    table.row(set.name,
              {f.lasius_ms, f.lasius_ms / f.dstar_ms, f.lasius_ms / f.astar_ms, median(f.ticks),
               quantile(f.ticks, 0.99), largest(f.ticks), quantile(f.dstar_ticks, 0.99),
               largest(f.dstar_ticks), mean(f.travelled), mean(f.ways)});
    ++maps;
    sooner += f.lasius_ms < f.dstar_ms ? 1 : 0;
    travelled.push_back(mean(f.travelled));
    ways.push_back(mean(f.ways));
  }
  table.close("Less planning time than D* Lite on " + std::to_string(sooner) + " of " +
              std::to_string(maps) + " maps; travelled " + short_number(mean(travelled)) +
              ", ways " + short_number(mean(ways)) + " in the mean over maps.");
}

}  // namespace

void add_drive_command(CLI::App& app) {
  auto [command, options] = add_command<DriveOptions>(
      app, "drive", "replanning under way against D* Lite and A*", run_drive);
  add_query_options(command, options);
  add_number(command, "--sense", options.sense, "cells that the robot sees", 1);
  command.add_flag("--prepare", options.prepare, "plan on the prepared map");
}

}  // namespace lasius::bench
