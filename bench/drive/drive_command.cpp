// lasius_bench drive: replanning under way against D* Lite and A*, and what an edit costs.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/peers/bucket_astar.h"
#include "bench/peers/dstar_lite.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/drive/sensor.h"
#include "lasius/drive.h"
#include "lasius/shortest_walk.h"

namespace lasius::bench {
namespace {

struct Options {
  MapOptions maps;
  std::size_t queries = 5;
  double sense = 20;
  int rounds = 3;
  bool prepare = false;
  std::vector<int> edit_sides;
  int edits = 1000;
};

/// One drive by one planner: every tick sees, then plans.
struct Course {
  double planning_ms = 0;  // seeing is not planning
  double travelled = 0;
  std::vector<double> ticks_ms;  // of ticks in which a way was planned
  bool arrived = false;
};

DriveOptions drive_options(const Options& options) {
  DriveOptions drive{.sense = options.sense};
  if (options.prepare) drive.navigator.prepare.emplace();
  return drive;
}

Course drive_navigator(const QuerySet& set, const Query& query, const Options& options) {
  const Grid unknown(set.grid.width(), set.grid.height());
  const DriveResult driven =
      drive(unknown, set.grid, query.start, query.goal, {}, drive_options(options));
  Course course;
  course.planning_ms = driven.planning_ms;
  course.travelled = driven.length;
  for (const Replan& replan : driven.replans) course.ticks_ms.push_back(replan.ms);
  course.arrived = driven.status == Status::solved;
  return course;
}

/// Drives by D* Lite, with the same sensor.
Course drive_dstar(const QuerySet& set, const Query& query, const Options& options) {
  Grid known(set.grid.width(), set.grid.height());
  const Growth point(known, 0);
  peers::DStarLite search(known, query.start, query.goal);
  Course course;
  News news;
  for (Cell robot = query.start; robot != query.goal;) {
    sense(set.grid, known, robot, options.sense, point, news);
    for (const Cell cell : news.blocked) known.set_blocked(cell);
    const bool changed = !news.blocked.empty() || course.ticks_ms.empty();
    const Stopwatch watch;
    if (!news.blocked.empty()) search.observe(news.blocked, true);
    const double length = search.plan(robot);
    const double ms = 1000 * watch.seconds();
    course.planning_ms += ms;
    if (changed) course.ticks_ms.push_back(ms);
    if (std::isinf(length)) return course;
    const Cell to = search.next();
    course.travelled += std::hypot(to.x - robot.x, to.y - robot.y);
    robot = to;
  }
  course.arrived = true;
  return course;
}

/// Drives by A* from anew where the walk is blocked. Looking up the moves of the changed map is not
/// counted, so that its time is that of the searches alone.
Course drive_astar(const QuerySet& set, const Query& query, const Options& options) {
  Grid known(set.grid.width(), set.grid.height());
  const Growth point(known, 0);
  Course course;
  News news;
  std::vector<Cell> walk;
  std::size_t at = 0;
  for (Cell robot = query.start; robot != query.goal; robot = walk[++at]) {
    sense(set.grid, known, robot, options.sense, point, news);
    for (const Cell cell : news.blocked) known.set_blocked(cell);
    bool holds = !walk.empty();
    for (std::size_t i = at; holds && i + 1 < walk.size(); ++i) {
      const Cell a = walk[i], b = walk[i + 1];
      holds = known.free(b) && known.free({a.x, b.y}) && known.free({b.x, a.y});
    }
    if (!holds) {
      peers::BucketAStar search(known);
      const Stopwatch watch;
      const double length = search.plan_cells(robot, query.goal, walk);
      course.ticks_ms.push_back(1000 * watch.seconds());
      course.planning_ms += course.ticks_ms.back();
      if (std::isinf(length)) return course;
      at = 0;
    }
    const Cell to = walk[at + 1];
    course.travelled += std::hypot(to.x - robot.x, to.y - robot.y);
  }
  course.arrived = true;
  return course;
}

/// Lengths of the ways that were planned, to those of the shortest walks from the same cells on
/// what was known: what D* Lite finds there.
std::vector<double> ways(const QuerySet& set, const Query& query, const Options& options) {
  constexpr int kEvery = 8;  // a search from anew for each is long
  std::vector<double> ratios;
  int replans = 0;
  const Grid unknown(set.grid.width(), set.grid.height());
  (void)drive(unknown, set.grid, query.start, query.goal, {}, drive_options(options), {},
              [&](const DriveTick& tick) {
                if (!tick.replanned || tick.way == nullptr || replans++ % kEvery != 0) return;
                const auto walk = shortest_walk(tick.robot_knows->map(), tick.robot, query.goal,
                                                Neighbours::eight);
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

MapFigures measure(const QuerySet& set, const Options& options) {
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

void compare(const Options& options) {
  std::cout
      << machine_line() << ". Unknown maps, a sensor of " << options.sense << " cells, at most "
      << options.queries << " queries a map; the least of " << options.rounds
      << " drives. Planning time of all drives: `exact` in a Navigator, as a share of D* "
         "Lite's and of A*'s from anew; milliseconds of a tick that plans; travelled, to D* "
         "Lite's (mean over queries); the ways planned, to the shortest walks there (mean)."
         "\n\n| map | ms | / D* Lite | / A* | p50 | p99 | max | D* Lite p99 | max | travelled "
         "| ways |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
      << std::endl;
  int sooner = 0, maps = 0;
  std::vector<double> travelled, ways;
  for (const QuerySource& source : sources_of(options.maps)) {
    const QuerySet set = load(source, options.queries);
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

/// Time of edits of ten cells, until it is known again what is joined to what.
void edit(const QuerySource& source, const Options& options) {
  const QuerySet set = load(source, 1);
  NavigatorOptions how;
  if (options.prepare) how.prepare.emplace();
  Navigator navigator(set.grid, set.queries[0].goal, how);
  (void)navigator.connected(set.queries[0].start, set.queries[0].goal);
  std::mt19937_64 engine(options.maps.seed);
  const auto below = [&](int limit) {
    return static_cast<int>(engine() % static_cast<std::uint64_t>(limit));
  };
  const std::int64_t before = navigator.bytes();
  std::vector<double> times;
  for (int i = 0; i < options.edits; ++i) {
    const Rectangle part{below(set.grid.width() - 5), below(set.grid.height() - 2), 5, 2};
    const bool blocked = below(2) == 0;
    const ThreadStopwatch watch;
    navigator.observe(part, blocked);
    (void)navigator.connected(set.queries[0].start, set.queries[0].goal);
    times.push_back(1e6 * watch.seconds());
  }
  std::cout << "| " << set.name << " | " << short_number(median(times)) << " | "
            << short_number(quantile(times, 0.99)) << " | " << short_number(largest(times)) << " | "
            << short_number(static_cast<double>(navigator.bytes() - before) / options.edits) << " |"
            << std::endl;
}

void measure_edits(const Options& options) {
  std::cout
      << machine_line() << ". " << options.edits << " edits of 5 x 2 cells, seed "
      << options.maps.seed << (options.prepare ? ", prepared" : "")
      << ": microseconds of processor time until the map can be asked again, and bytes that it "
         "holds more "
         "after each in the mean.\n\n| map | median | p99 | max | bytes |\n|---|--:|--:|--:|--:|"
      << std::endl;
  for (const QuerySource& source : generated_sources(options.edit_sides, options.maps.seed)) {
    const bool wanted = source.kind == MapKind::blobs || source.kind == MapKind::city ||
                        (source.kind == MapKind::random && source.options.density == 0.2);
    if (wanted) edit(source, options);
  }
}

void run(const Options& options) {
  if (!options.edit_sides.empty()) {
    measure_edits(options);
  } else {
    compare(options);
  }
}

}  // namespace

void add_drive_command(CLI::App& app) {
  auto [command, options] = add_command<Options>(
      app, "drive", "replanning under way against D* Lite and A*; what an edit costs", run);
  add_map_options(command, options.maps);
  add_number(command, "--queries", options.queries, "queries a map");
  add_number(command, "--sense", options.sense, "cells that the robot sees", 1);
  add_number(command, "--rounds", options.rounds, "drives of each planner", 1);
  command.add_flag("--prepare", options.prepare, "plan on the prepared map");
  command.add_option("--edit-sides", options.edit_sides,
                     "measure edits of generated maps of these sides instead");
  add_number(command, "--edits", options.edits, "how many", 1);
}

}  // namespace lasius::bench
