#include "bench/polygon_scales.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/report.h"
#include "bench/statistics.h"
#include "tests/worlds/disc_bitmap.h"
#include "tests/worlds/random_world.h"

namespace lasius::bench {
namespace {

using polygon::Dice;
using polygon::Planner;
using polygon::World;

constexpr std::uint64_t kFirstWorld = 9000;  // none that defaults were chosen on

/// A world of 5 to 500 obstacles, small counts as often as large ones.
World world_of(int number, Dice& dice) {
  const int obstacles = static_cast<int>(5 * std::pow(100.0, dice.real(0, 1)));
  return polygon::random_world(kFirstWorld + static_cast<std::uint64_t>(number), obstacles);
}

Point scaled(Point p, double by) { return {p.x * by, p.y * by}; }

World scaled(World world, double by) {
  for (Point& p : world.boundary.outer) p = scaled(p, by);
  for (polygon::Polygon& obstacle : world.obstacles)
    for (Point& p : obstacle.outer) p = scaled(p, by);
  world.margin *= by;
  return world;
}

struct Case {
  World world;
  Point start, goal;

  /// What each algorithm answers in the world at a scale.
  std::vector<polygon::Result> answers(double by) const {
    const Planner planner(scaled(world, by));
    std::vector<polygon::Result> results;
    for (const auto& algorithm : polygon::algorithms()) {
      polygon::Params parameters = polygon::Params(algorithm.name);
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
  const polygon::Result& ants = first[1];
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
          {"the same, worst, %", gaps.empty() ? "" : short_number(100 * gaps.back()), "<= 6"}};
}

}  // namespace

std::vector<Figure> measure_scales(int worlds, int& faults) {
  auto figures = scale_figures("worlds without a margin", worlds, 0, faults);
  const auto more = scale_figures("worlds with a margin", worlds, 6, faults);
  figures.insert(figures.end(), more.begin(), more.end());
  return figures;
}

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

}  // namespace lasius::bench
