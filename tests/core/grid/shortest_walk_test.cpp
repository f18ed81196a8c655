#include "lasius/shortest_walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "lasius/path.h"
#include "tests/worlds/random_grid.h"

namespace lasius {
namespace {

const double kSqrt2 = std::sqrt(2.0);

TEST(ShortestWalk, ByHand) {
  Grid grid(5, 5);
  const auto length = [&](Neighbours neighbours) {
    return shortest_walk(grid, {0, 0}, {4, 2}, neighbours).value();
  };
  EXPECT_EQ(length(Neighbours::four), 6);
  EXPECT_DOUBLE_EQ(length(Neighbours::eight), 2 + 2 * kSqrt2);
  EXPECT_DOUBLE_EQ(length(Neighbours::sixteen), 2 + 2 * kSqrt2);  // longer, no new direction
  EXPECT_DOUBLE_EQ(length(Neighbours::sixteen_knight), 2 * std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(length(Neighbours::twenty_four), 2 * std::sqrt(5.0));
  EXPECT_EQ(shortest_walk(grid, {3, 3}, {3, 3}, Neighbours::eight), 0);
}

TEST(ShortestWalk, CornersCloseDiagonals) {
  Grid grid(2, 2);
  const auto diagonal = [&](Corners corners) {
    return shortest_walk(grid, {0, 0}, {1, 1}, Neighbours::eight, corners);
  };
  grid.set_blocked({1, 0});
  EXPECT_EQ(diagonal(Corners::forbid), 2);
  EXPECT_EQ(diagonal(Corners::one_side), kSqrt2);
  grid.set_blocked({0, 1});
  EXPECT_EQ(diagonal(Corners::allow), kSqrt2);
  EXPECT_FALSE(diagonal(Corners::one_side));
}

TEST(ShortestWalk, NothingWhereThereIsNone) {
  Grid grid(5, 5);
  for (int x = 0; x < 5; ++x) grid.set_blocked({x, 1});
  EXPECT_FALSE(shortest_walk(grid, {0, 0}, {4, 2}, Neighbours::eight, Corners::allow));
  EXPECT_FALSE(shortest_walk(grid, {0, 1}, {4, 2}, Neighbours::eight));
  EXPECT_FALSE(shortest_walk(grid, {0, 0}, {5, 0}, Neighbours::eight));
}

TEST(ShortestWalk, StopsWhenTold) {
  Grid grid(600, 600);
  for (int y = 0; y < 599; ++y) grid.set_blocked({300, y});
  std::stop_source source;
  source.request_stop();
  const StopCondition stop{.token = source.get_token()};
  EXPECT_TRUE(shortest_walk(grid, {0, 0}, {500, 3}, Neighbours::four));
  EXPECT_FALSE(shortest_walk(grid, {0, 0}, {500, 3}, Neighbours::four, Corners::forbid, stop));
}

struct Step {
  int dx, dy;
};

std::vector<Step> steps_of(Neighbours neighbours) {
  const bool square = neighbours >= Neighbours::twenty_four;
  std::vector<Step> steps;
  for (int dy = -3; dy <= 3; ++dy) {
    for (int dx = -3; dx <= 3; ++dx) {
      const int reach = std::max(std::abs(dx), std::abs(dy));
      const bool knight = std::abs(dx * dy) == 2;
      const bool straight = dx == 0 || dy == 0 || std::abs(dx) == std::abs(dy);
      if (neighbours == Neighbours::four
              ? std::abs(dx) + std::abs(dy) == 1
              : reach == 1 || (square && reach == 2) ||
                    (neighbours == Neighbours::sixteen && straight && reach == 2) ||
                    (neighbours == Neighbours::sixteen_knight && knight) ||
                    (neighbours == Neighbours::thirty_two && straight && reach == 3)) {
        steps.push_back({dx, dy});
      }
    }
  }
  return steps;
}

// Cell by cell along straight and diagonal moves; a knight's move needs sight.
bool passes(const Grid& grid, Cell at, Step step, Corners corners) {
  const int reach = std::gcd(step.dx, step.dy);
  const int dx = step.dx / reach, dy = step.dy / reach;
  if (dx * dx + dy * dy > 2) return visible(grid, at, {at.x + step.dx, at.y + step.dy});
  for (int i = 0; i < reach; ++i, at = {at.x + dx, at.y + dy}) {
    if (grid.blocked({at.x + dx, at.y + dy})) return false;
    if (dx == 0 || dy == 0) continue;
    const int sides = grid.free({at.x + dx, at.y}) + grid.free({at.x, at.y + dy});
    if (sides < (corners == Corners::forbid ? 2 : corners == Corners::one_side ? 1 : 0)) {
      return false;
    }
  }
  return true;
}

// Bellman and Ford: relaxes every move until nothing changes.
double relaxed(const Grid& grid, Cell start, Cell goal, Neighbours neighbours, Corners corners) {
  const auto steps = steps_of(neighbours);
  const int width = grid.width();
  std::vector<double> best(static_cast<std::size_t>(width) * grid.height(),
                           std::numeric_limits<double>::infinity());
  const auto at = [&](Cell c) -> double& {
    return best[static_cast<std::size_t>(c.y) * width + c.x];
  };
  at(start) = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < width; ++x) {
        if (at({x, y}) == std::numeric_limits<double>::infinity()) continue;
        for (const Step step : steps) {
          if (!passes(grid, {x, y}, step, corners)) continue;
          const double through = at({x, y}) + std::sqrt(step.dx * step.dx + step.dy * step.dy);
          double& known = at({x + step.dx, y + step.dy});
          if (through >= known - 1e-12) continue;
          known = through;
          changed = true;
        }
      }
    }
  }
  return at(goal);
}

TEST(ShortestWalk, EqualsBellmanFordOnRandomGrids) {
  std::mt19937 random(20260111);
  int reachable = 0, unreachable = 0;
  for (int i = 0; i < 360; ++i) {
    const auto neighbours = static_cast<Neighbours>(i % 6);
    const auto corners = static_cast<Corners>(i / 6 % 3);
    const Grid grid = random_grid(random_in(2, 24, random), random_in(2, 24, random),
                                  random_in(5, 45, random), random);
    const Cell start{random_in(0, grid.width() - 1, random),
                     random_in(0, grid.height() - 1, random)};
    const Cell goal{random_in(0, grid.width() - 1, random),
                    random_in(0, grid.height() - 1, random)};
    if (grid.blocked(start) || grid.blocked(goal)) continue;
    const double expected = relaxed(grid, start, goal, neighbours, corners);
    const auto length = shortest_walk(grid, start, goal, neighbours, corners);
    SCOPED_TRACE(i);
    ASSERT_EQ(length.has_value(), std::isfinite(expected));
    if (length) {
      EXPECT_NEAR(*length, expected, 1e-9);
    }
    ++(length ? reachable : unreachable);
  }
  EXPECT_GT(reachable, 100);
  EXPECT_GT(unreachable, 10);
}

}  // namespace
}  // namespace lasius
