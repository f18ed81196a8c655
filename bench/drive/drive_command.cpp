// lasius_bench drive: replanning under way against D* Lite and A*.
#include <algorithm>
#include <iostream>
#include <span>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/peers/bucket_astar.h"
#include "bench/peers/dstar_pilot.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/drive.h"
#include "lasius/shortest_walk.h"

namespace lasius::bench {
namespace {

struct CourseOptions : QueryOptions {
  CourseOptions() : QueryOptions{.count = 5, .rounds = 3} {}
  double sense = 20;
  bool prepare = false;
};

/// One drive by one planner: every tick sees, then plans.
struct Course {
  double planning_ms = 0;  // seeing is not planning
  double travelled = 0;
  std::vector<double> ticks_ms;  // of ticks in which a way was planned
  bool arrived = false;
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

Navigator navigator_of(const QuerySet& set, const Query& query, const CourseOptions& options) {
  NavigatorOptions how;
  if (options.prepare) how.prepare.emplace();
  return {unknown(set), query.goal, how};
}

DriveResult drive_with(Pilot& pilot, const QuerySet& set, const Query& query,
                       const CourseOptions& options, const DriveObserver& observer = {}) {
  return drive(pilot, set.grid, query.start, {}, {.sense = options.sense}, {}, observer);
}

Course course_of(Pilot& pilot, const QuerySet& set, const Query& query,
                 const CourseOptions& options) {
  const DriveResult driven = drive_with(pilot, set, query, options);
  Course course{.planning_ms = driven.planning_ms,
                .travelled = driven.length,
                .ticks_ms = {},
                .arrived = driven.status == Status::solved};
  for (const Replan& replan : driven.replans) course.ticks_ms.push_back(replan.ms);
  return course;
}

Course drive_navigator(const QuerySet& set, const Query& query, const CourseOptions& options) {
  Navigator navigator = navigator_of(set, query, options);
  return course_of(navigator, set, query, options);
}

Course drive_dstar(const QuerySet& set, const Query& query, const CourseOptions& options) {
  peers::DStarPilot pilot(unknown(set), query.start, query.goal);
  return course_of(pilot, set, query, options);
}

Course drive_astar(const QuerySet& set, const Query& query, const CourseOptions& options) {
  AStarPilot pilot(unknown(set), query.goal);
  Course course = course_of(pilot, set, query, options);
  course.planning_ms = pilot.searching_ms();
  return course;
}

/// Lengths of the ways that were planned, to those of the shortest walks from the same cells on
/// what was known: what D* Lite finds there.
std::vector<double> ways(const QuerySet& set, const Query& query, const CourseOptions& options) {
  constexpr int kEvery = 8;  // a search from anew for each is long
  std::vector<double> ratios;
  int replans = 0;
  Navigator navigator = navigator_of(set, query, options);
  (void)drive_with(navigator, set, query, options, [&](const DriveTick& tick) {
    if (!tick.replanned || tick.way == nullptr || replans++ % kEvery != 0) return;
    const auto walk =
        shortest_walk(tick.robot_knows->map(), tick.robot, query.goal, Neighbours::eight);
    if (walk && *walk > 0) ratios.push_back(tick.way->length / *walk);
  });
  return ratios;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// What the queries of a map came to.
struct MapFigures {
  double lasius_ms = 0, dstar_ms = 0, astar_ms = 0;
  std::vector<double> ticks, dstar_ticks, travelled, ways;
};

/// Each planner in turn, several times: the least total counts, since noise only adds.
template <class Drive>
Course best_of(int rounds, const Drive& drive) {
  Course best = drive();
  for (int i = 1; i < rounds; ++i) {
    const Course course = drive();
    if (course.planning_ms < best.planning_ms) best = course;
  }
  return best;
}

MapFigures measure(const QuerySet& set, const CourseOptions& options) {
  MapFigures figures;
  for (const Query& query : set.queries) {
    const Course own =
        best_of(options.rounds, [&] { return drive_navigator(set, query, options); });
    const Course dstar = best_of(options.rounds, [&] { return drive_dstar(set, query, options); });
    const Course astar = best_of(options.rounds, [&] { return drive_astar(set, query, options); });
    if (!own.arrived || !dstar.arrived || !astar.arrived) {
      std::cout << set.name << ": a drive did not arrive\n";
      throw CLI::RuntimeError(1);
    }
    figures.lasius_ms += own.planning_ms;
    figures.dstar_ms += dstar.planning_ms;
    figures.astar_ms += astar.planning_ms;
    figures.ticks.insert(figures.ticks.end(), own.ticks_ms.begin(), own.ticks_ms.end());
    figures.dstar_ticks.insert(figures.dstar_ticks.end(), dstar.ticks_ms.begin(),
                               dstar.ticks_ms.end());
    figures.travelled.push_back(own.travelled / dstar.travelled);
    const auto more = ways(set, query, options);
    figures.ways.insert(figures.ways.end(), more.begin(), more.end());
  }
  return figures;
}

void run_drive(const CourseOptions& options) {
  std::cout
      << machine_line() << ". Unknown maps, a sensor of " << options.sense << " cells, at most "
      << options.count << " queries a map; the least of " << options.rounds
      << " drives. Planning time of all drives: `exact` in a Navigator, as a share of D* "
         "Lite's and of A*'s from anew; milliseconds of a tick that plans; travelled, to D* "
         "Lite's (mean over queries); the ways planned, to the shortest walks there (mean)."
         "\n\n| map | ms | / D* Lite | / A* | p50 | p99 | max | D* Lite p99 | max | travelled "
         "| ways |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
      << std::endl;
  int sooner = 0, maps = 0;
  std::vector<double> travelled, ways;
  for (const QuerySource& source : sources_of(options.maps)) {
    const QuerySet set = load(source, options.count);
    const MapFigures f = measure(set, options);
    std::cout << "| " << set.name << " | " << short_number(f.lasius_ms) << " | "
              << short_number(f.lasius_ms / f.dstar_ms) << " | "
              << short_number(f.lasius_ms / f.astar_ms) << " | " << short_number(median(f.ticks))
              << " | " << short_number(quantile(f.ticks, 0.99)) << " | "
              << short_number(largest(f.ticks)) << " | "
              << short_number(quantile(f.dstar_ticks, 0.99)) << " | "
              << short_number(largest(f.dstar_ticks)) << " | " << short_number(mean(f.travelled))
              << " | " << short_number(mean(f.ways)) << " |" << std::endl;
    ++maps;
    sooner += f.lasius_ms < f.dstar_ms ? 1 : 0;
    travelled.push_back(mean(f.travelled));
    ways.push_back(mean(f.ways));
  }
  std::cout << "\nLess planning time than D* Lite on " << sooner << " of " << maps
            << " maps; travelled " << short_number(mean(travelled)) << ", ways "
            << short_number(mean(ways)) << " in the mean over maps.\n";
}

}  // namespace

void add_drive_command(CLI::App& app) {
  auto [command, options] = add_command<CourseOptions>(
      app, "drive", "replanning under way against D* Lite and A*", run_drive);
  add_query_options(command, options);
  add_number(command, "--sense", options.sense, "cells that the robot sees", 1);
  command.add_flag("--prepare", options.prepare, "plan on the prepared map");
}

}  // namespace lasius::bench
