// Random polygon worlds, and what GEOS says of paths in them.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "lasius/polygon/plan.h"
#include "tests/worlds/areas.h"

namespace lasius::polygon {

/// Numbers that are the same with every standard library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  int whole(int low, int high) { return static_cast<int>(real(low, high + 1)); }

 private:
  std::mt19937_64 engine_;
};

/// Nothing but a boundary, from the origin to (width, height), and perhaps a question.
inline World empty_world(double width, double height, std::optional<Point> start = {},
                         std::optional<Point> goal = {}) {
  World world;
  world.boundary.outer = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  world.start = start;
  world.goal = goal;
  return world;
}

/// A square of 200 with `count` star-shaped obstacles of 3 to 8 corners, many of which overlap;
/// `step` > 0 puts corners on a coarse grid, so that they touch and line up.
inline World random_world(std::uint64_t seed, int count, double step = 0) {
  Dice dice(seed);
  const auto snapped = [&](double v) { return step > 0 ? std::round(v / step) * step : v; };
  World world = empty_world(200, 200);
  while (static_cast<int>(world.obstacles.size()) < count) {
    const Point centre{dice.real(0, 200), dice.real(0, 200)};
    const double reach = dice.real(12, 72) / std::sqrt(count);
    const int corners = dice.whole(3, 8);
    const double turn = dice.real(0, 2 * std::numbers::pi);
    World one;
    for (int i = 0; i < corners; ++i) {
      const double angle = turn + 2 * std::numbers::pi * i / corners, r = reach * dice.real(0.4, 1);
      one.boundary.outer.push_back(
          {snapped(centre.x + r * std::cos(angle)), snapped(centre.y + r * std::sin(angle))});
    }
    try {
      check(one);
    } catch (const std::exception&) {
      continue;  // snapped flat
    }
    world.obstacles.push_back(one.boundary);
  }
  return world;
}

inline Point scaled(Point p, double by) { return {p.x * by, p.y * by}; }

/// Boundary, obstacles without holes, and margin.
inline World scaled(World world, double by) {
  for (Point& p : world.boundary.outer) p = scaled(p, by);
  for (Polygon& obstacle : world.obstacles)
    for (Point& p : obstacle.outer) p = scaled(p, by);
  world.margin *= by;
  return world;
}

/// A free point of a planner's world.
inline Point free_point(const Planner& planner, Dice& dice) {
  return *planner.nearest_free({dice.real(0, 200), dice.real(0, 200)});
}

/// A question between two of them.
inline Request random_request(const Planner& planner, std::uint64_t seed) {
  Dice dice(seed);
  return {.start = free_point(planner, dice), .goal = free_point(planner, dice)};
}

/// Independent of the library but for obstacles that it has merged: GEOS decides.
class Referee {
 public:
  explicit Referee(const std::vector<Polygon>& obstacles) : obstacles_(areas_.all_of(obstacles)) {}

  /// Whether a path stays clear of the obstacles once they are shrunk.
  bool clear(const std::vector<Point>& path, double shrink) const {
    if (path.size() < 2) return true;
    const auto shrunk = areas_.grown(obstacles_, -shrink, true);
    const auto line = areas_.line(path);
    return GEOSIntersects_r(areas_.context(), line.get(), shrunk.get()) == 0;
  }

  /// From a path to the nearest obstacle.
  double distance(const std::vector<Point>& path) const {
    double least = 0;
    const auto line = areas_.line(path);
    const bool found = GEOSDistance_r(areas_.context(), line.get(), obstacles_.get(), &least) == 1;
    return found ? least : std::nan("");
  }

  /// Whether the segment misses the inside of every obstacle.
  bool sees(Point a, Point b) const {
    const auto line = areas_.line({a, b});
    return GEOSRelatePattern_r(areas_.context(), line.get(), obstacles_.get(), "T********") == 0;
  }

 private:
  Areas areas_;
  Areas::Area obstacles_;
};

}  // namespace lasius::polygon
