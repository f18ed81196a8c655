// lasius_bench polygons: the source's run against a textbook's, preparation of large worlds, paths
// checked over many random worlds, the same at every scale, and margins against a swept disc.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/peers/textbook_crossings.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "tests/worlds/disc_bitmap.h"
#include "tests/worlds/random_world.h"

namespace lasius::bench {
namespace {

using polygon::Dice;
using polygon::Params;
using polygon::Planner;
using polygon::scaled;
using polygon::World;

struct PolygonsOptions {
  int rounds = 50;
  int worlds = 200;
  int scaled = 100;
};

/// 10 ants, 200 iterations, 9 lines, 11 values; both in turns, processor time.
std::vector<Figure> measure_source_run(int rounds) {
  const Planner planner(polygon::read_world(LASIUS_MAPS_DIR "/maklink200.geojson"));
  Params parameters = polygon::Params("maklink-acs");
  parameters.values = 11;
  parameters.initial_pheromone = 0.0002;
  parameters.routes = 1;
  parameters.greedy = 0.85;
  std::vector<double> ours, none, textbook, ratios;
  int optimal = 0, textbook_optimal = 0;
  for (int i = 0; i < rounds; ++i) {
    parameters.seed = static_cast<std::uint64_t>(i + 1);
    const auto timed = [&](int iterations, std::vector<double>& times) {
      parameters.iterations = iterations;
      const ThreadStopwatch watch;
      auto result = planner.plan({}, parameters);
      times.push_back(1e3 * watch.seconds());
      return result;
    };
    const auto result = timed(200, ours);
    timed(0, none);
    std::vector<std::pair<Point, Point>> lines;
    for (const int line : result.crossing.lines) {
      lines.emplace_back(planner.maklink().lines[line].a, planner.maklink().lines[line].b);
    }
    const ThreadStopwatch watch;
    peers::TextbookCrossings plain(*planner.world().start, *planner.world().goal, lines,
                                   {.seed = static_cast<std::uint32_t>(i + 1)});
    for (int q = 0; q < 200; ++q) plain.iterate();
    textbook.push_back(1e3 * watch.seconds());
    ratios.push_back(textbook.back() / (ours.back() - none.back()));
    const double optimum = result.discrete_optimum->length * (1 + 1e-12);
    optimal += result.length <= optimum ? 1 : 0;
    textbook_optimal += plain.best_length() <= optimum ? 1 : 0;
  }
  const auto share = [&](int count) {
    return std::to_string(count) + " of " + std::to_string(rounds);
  };
  return {{"the source's run, milliseconds: plan with graph search and optima",
           short_number(median(ours)), "<= 1"},
          {"of these the ants' 200 iterations", short_number(median(ours) - median(none)), ""},
          {"200 iterations in textbook code", short_number(median(textbook)), ""},
          {"ratio, median of pairs", short_number(median(ratios)), ">= 10"},
          {"runs that reach the optimum of lines and values", share(optimal), "95%"},
          {"runs of the textbook code that reach it", share(textbook_optimal), ""}};
}

std::size_t corner_count(const World& world) {
  std::size_t count = world.boundary.outer.size();
  for (const auto& obstacle : world.obstacles) count += obstacle.outer.size();
  return count;
}

std::vector<Figure> measure_preparation(int rounds) {
  const auto world = polygon::random_world(5, 182);
  std::vector<double> prepare, exact;
  for (int i = 0; i < rounds; ++i) {
    const Stopwatch watch;
    const Planner planner(world);
    prepare.push_back(1e3 * watch.seconds());
    Dice dice(static_cast<std::uint64_t>(i));
    const Point start = polygon::free_point(planner, dice);
    const Point goal = polygon::free_point(planner, dice);
    const Stopwatch search;
    planner.plan({.start = start, .goal = goal});
    exact.push_back(1e3 * search.seconds());
  }
  const std::string which =
      " of " + std::to_string(corner_count(world)) + " vertices, milliseconds";
  return {{"MAKLINK graph of a world" + which, short_number(median(prepare)), "< 1000"},
          {"`exact` in it", short_number(median(exact)), ""}};
}

/// Paths that come nearer to an obstacle than the margin, or without one enter it, by more than
/// 1e-9 of the world's size, as GEOS says.
std::vector<Figure> check_paths(int worlds, int& faults) {
  int paths = 0, unreachable = 0, optimal = 0;
  std::vector<double> gaps;
  for (int i = 0; i < worlds; ++i) {
    Dice dice(static_cast<std::uint64_t>(i) + 1'000'000);
    auto world = polygon::random_world(static_cast<std::uint64_t>(i), dice.whole(5, 200),
                                       i % 4 == 0 ? 2 : 0);
    world.margin = i % 2 == 0 ? 0 : dice.real(0, 1);
    const Planner planner(world);
    const bool grown = world.margin > 0;
    const polygon::Referee referee(grown ? world.obstacles : planner.grown_obstacles());
    const auto clear = [&](const std::vector<Point>& path) {
      constexpr double kSlack = 200 * 1e-9;
      if (!grown) return referee.clear(path, kSlack);
      return path.size() < 2 || referee.distance(path) >= world.margin - kSlack;
    };
    const polygon::Request request{.start = polygon::free_point(planner, dice),
                                   .goal = polygon::free_point(planner, dice)};
    for (const auto& algorithm : polygon::algorithms()) {
      Params parameters = polygon::Params(algorithm.name);
      if (algorithm.name == "real-ga") parameters.iterations = 50;
      const auto result = planner.plan(request, parameters);
      if (result.path.empty()) {
        ++unreachable;
        if (result.status != Status::unreachable) ++faults;
        continue;
      }
      ++paths;
      faults += clear(result.path) ? 0 : 1;
      if (algorithm.name != "maklink-acs") continue;
      gaps.push_back(result.length / result.discrete_optimum->length - 1);
      optimal += gaps.back() <= 1e-12 ? 1 : 0;
    }
  }
  return {{"paths in " + std::to_string(worlds) + " random worlds of 5 to 200 obstacles",
           std::to_string(paths), ""},
          {"that come nearer than the margin by 1e-9 of the world", std::to_string(faults), "0"},
          {"plans proven unreachable", std::to_string(unreachable), ""},
          {"`maklink-acs` at the optimum of its lines and values",
           std::to_string(optimal) + " of " + std::to_string(gaps.size()), ""},
          {"its gap to it, median, %", gaps.empty() ? "" : short_number(100 * median(gaps)), ""}};
}

constexpr std::uint64_t kFirstWorld = 9000;  // none that defaults were chosen on

/// A world of 5 to 500 obstacles, small counts as often as large ones.
World world_of(int number, Dice& dice) {
  const int obstacles = static_cast<int>(5 * std::pow(100.0, dice.real(0, 1)));
  return polygon::random_world(kFirstWorld + static_cast<std::uint64_t>(number), obstacles);
}

struct Case {
  World world;
  Point start, goal;

  /// What each algorithm answers in the world at a scale.
  std::vector<polygon::Result> answers(double by) const {
    const Planner planner(scaled(world, by));
    std::vector<polygon::Result> results;
    for (const auto& algorithm : polygon::algorithms()) {
      Params parameters(algorithm.name);
      if (algorithm.name == "real-ga") parameters.iterations = 20;
      results.push_back(
          planner.plan({.start = scaled(start, by), .goal = scaled(goal, by)}, parameters));
    }
    return results;
  }
};

/// Whether all algorithms go the same way at all scales, bit for bit; the gap of `maklink-acs`.
bool same_at_all_scales(const Case& one, std::vector<double>& gaps) {
  const auto first = one.answers(1);
  const auto known = polygon::algorithms();
  const auto ants_at = std::ranges::find(known, "maklink-acs", &Algorithm::name) - known.begin();
  const polygon::Result& ants = first[static_cast<std::size_t>(ants_at)];
  if (ants.optimum && ants.length > 0) gaps.push_back(ants.length / *ants.optimum - 1);
  bool same = true;
  for (const int exponent : {-10, 7, 20}) {
    const double by = std::ldexp(1.0, exponent);
    const auto others = one.answers(by);
    for (std::size_t i = 0; i < first.size(); ++i) {
      same = same && std::ranges::equal(first[i].path, others[i].path,
                                        [by](Point a, Point b) { return scaled(a, by) == b; });
    }
  }
  return same;
}

std::vector<Figure> scale_figures(const std::string& which, int worlds, double most_margin,
                                  int& faults) {
  std::vector<double> gaps;
  int same = 0;
  for (int i = 0; i < worlds; ++i) {
    Dice dice(kFirstWorld + static_cast<std::uint64_t>(i));
    Case one{.world = world_of(i, dice), .start = {}, .goal = {}};
    one.world.margin = dice.real(0, most_margin) / std::sqrt(one.world.obstacles.size());
    const Planner planner(one.world);
    one.start = polygon::free_point(planner, dice);
    one.goal = polygon::free_point(planner, dice);
    same += same_at_all_scales(one, gaps) ? 1 : 0;
  }
  faults += worlds - same;
  std::ranges::sort(gaps);
  return {{which + ", of 5 to 500 obstacles, scaled by 2^-10 to 2^20: same paths, bit for bit",
           std::to_string(same) + " of " + std::to_string(worlds), "all"},
          {"`maklink-acs` above the true shortest path there, median, %",
           gaps.empty() ? "" : short_number(100 * median(gaps)), "<= 1.8"},
          {"`maklink-acs` above the true shortest path there, worst, %",
           gaps.empty() ? "" : short_number(100 * gaps.back()), "<= 6"}};
}

/// `faults` counts paths that change with the scale.
std::vector<Figure> measure_scales(int worlds, int& faults) {
  auto figures = scale_figures("worlds without a margin", worlds, 0, faults);
  const auto more = scale_figures("worlds with a margin", worlds, 6, faults);
  figures.insert(figures.end(), more.begin(), more.end());
  return figures;
}

/// `faults` counts plans that say unreachable or blocked where a disc passes, which is swept over a
/// fine bitmap.
std::vector<Figure> check_discs(int worlds, int& faults) {
  constexpr double kMostExcess = 0.005;  // of the margin, what round joins take at corners
  constexpr double kCell = 0.1;
  int asked = 0, wrong = 0;
  for (int i = 0; i < worlds; ++i) {
    Dice dice(kFirstWorld + static_cast<std::uint64_t>(i));
    World world = world_of(i, dice);
    world.margin = dice.real(0.1, 12) / std::sqrt(world.obstacles.size());
    const polygon::DiscBitmap discs(world, world.margin * (1 + kMostExcess), kCell);
    const Planner planner(world);
    for (int k = 0; k < 10; ++k) {
      const Point start = discs.free_near({dice.real(0, 200), dice.real(0, 200)});
      const Point goal = discs.free_near({dice.real(0, 200), dice.real(0, 200)});
      if (!discs.joined(start, goal)) continue;
      ++asked;
      wrong += planner.plan({.start = start, .goal = goal}).path.empty() ? 1 : 0;
    }
  }
  faults += wrong;
  return {
      {"questions with a margin that a disc answers on a bitmap of cells of 1/2000 of the world",
       std::to_string(asked), ""},
      {"of these told unreachable or blocked", std::to_string(wrong), "0"}};
}

void run_polygons(const PolygonsOptions& options) {
  Table table = Table::of_figures("Worlds of maps/ and random ones.");
  int faults = 0;
  table.add(measure_source_run(options.rounds));
  table.add(measure_preparation(std::max(1, options.rounds / 10)));
  table.add(check_paths(options.worlds, faults));
  table.add(measure_scales(options.scaled, faults));
  table.add(check_discs(options.scaled, faults));
  if (faults > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_polygons_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "polygons", "Planning among polygons: speed and validity", run_polygons);
  add_number(command, "--rounds", options.rounds, "Runs that are timed", 1, 10000);
  add_number(command, "--worlds", options.worlds, "Random worlds that are checked", 0, 1000000);
  add_number(command, "--scaled", options.scaled,
             "Random worlds that are scaled, and in which discs are swept", 0, 1000000);
}

}  // namespace lasius::bench
