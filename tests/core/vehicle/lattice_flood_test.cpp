// All of a lattice at once, against motions looked at one by one and Dijkstra's search.
#include "core/vehicle/lattice_flood.h"

#include <gtest/gtest.h>

#include <functional>
#include <queue>
#include <random>
#include <tuple>
#include <vector>

#include "core/vehicle/angle.h"
#include "core/vehicle/edge_planes.h"
#include "core/vehicle/flood.h"
#include "core/vehicle/sweep.h"
#include "lasius/vehicle/planner.h"
#include "tests/core/vehicle/dense_check.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

std::vector<Vehicle> flooded() {
  Vehicle forward = car(rectangle(3, 5, 2), 5);
  forward.reverse = false;
  // The reference point lies outside; wider than 64 cells; to any side.
  return {forward, car({{3, -1}, {8, -1}, {8, 2}, {3, 2}}, 4), differential(rectangle(10, 60, 1)),
          omni(rectangle(3, 2, 1))};
}

TEST(EdgePlanes, SayWhatMasksSay) {
  const Grid grid = blobs(3, 60);
  for (const Vehicle& vehicle : flooded()) {
    const Space space(grid, vehicle);
    const Lattice lattice(vehicle, space.impl().outline());
    Poller poller(kGoesOn);
    const auto planes = EdgePlanes::make(space.impl(), lattice, poller);
    ASSERT_TRUE(planes);
    std::mt19937_64 random(2);
    int free = 0;
    for (int i = 0; i < 60000; ++i) {
      const int e = static_cast<int>(random() % lattice.edges().size());
      const int x = static_cast<int>(random() % grid.width());
      const int y = static_cast<int>(random() % grid.height());
      const bool one = lattice.masks().free(lattice.edges()[e].mask, space.impl().bits(), x, y);
      ASSERT_EQ(planes->free(e, x, y), one) << e << " " << x << " " << y;
      free += one ? 1 : 0;
    }
    EXPECT_GT(free, 1000);
    for (int y = 0; y < grid.height(); ++y) {
      for (int e = 0; e < static_cast<int>(lattice.edges().size()); ++e)
        ASSERT_EQ(planes->word(e, planes->words() - 1, y) >> 1 >> (grid.width() - 1) % 64, 0u);
    }
    const StopCondition stopped{.deadline = Clock::time_point::min()};
    Poller stops(stopped, 1);
    EXPECT_FALSE(EdgePlanes::make(space.impl(), lattice, stops));
  }
}

TEST(FreeHeadings, SayWhatMasksSay) {
  // Words of the second and third have no free cell, or no blocked one near.
  for (const Grid& grid : {blobs(3, 60), walled(512, 60, {{0, 0, 140, 60}, {300, 20, 9, 9}}),
                           walled(530, 9, {{200, 0, 129, 9}, {500, 3, 1, 1}})}) {
    for (const Vehicle& vehicle : flooded()) {
      const Space space(grid, vehicle);
      const Lattice lattice(vehicle, space.impl().outline());
      Poller poller(kGoesOn);
      const FreeHeadings free(space.impl(), lattice, poller);
      for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x)
          for (int h = 0; h < Lattice::kHeadings; ++h)
            ASSERT_EQ((free.at(x, y) >> h & 1) != 0,
                      lattice.masks().free(lattice.footprint(h), space.impl().bits(), x, y))
                << x << " " << y << " " << h;
    }
  }
}

std::size_t state_of(const Grid& grid, int x, int y, int h) {
  return (static_cast<std::size_t>(h) * grid.height() + y) * grid.width() + x;
}

/// By Dijkstra's algorithm, what it costs at least to come to each state from the starts.
std::vector<int> least_units(const Grid& grid, const Space& space, const Lattice& lattice,
                             const std::vector<Connector>& starts) {
  std::vector<int> cost(state_of(grid, 0, 0, Lattice::kHeadings), LatticeFlood::kNever);
  using Entry = std::tuple<int, int, int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto offer = [&](int x, int y, int h, int units) {
    if (units >= cost[state_of(grid, x, y, h)]) return;
    cost[state_of(grid, x, y, h)] = units;
    open.emplace(units, x, y, h);
  };
  for (const auto& start : starts)
    offer(start.x, start.y, start.heading, LatticeFlood::units(start.cost));
  while (!open.empty()) {
    const auto [units, x, y, h] = open.top();
    open.pop();
    if (units != cost[state_of(grid, x, y, h)]) continue;
    for (const int e : lattice.from(h)) {
      const Edge& edge = lattice.edges()[e];
      if (!grid.contains({x + edge.dx, y + edge.dy})) continue;
      if (lattice.masks().free(edge.mask, space.impl().bits(), x, y))
        offer(x + edge.dx, y + edge.dy, edge.to, units + LatticeFlood::units(edge));
    }
  }
  return cost;
}

TEST(LatticeFlood, IsDijkstras) {
  const Grid grid = blobs(3, 40);
  for (const Vehicle& vehicle : flooded()) {
    const Space space(grid, vehicle);
    const Lattice lattice(vehicle, space.impl().outline());
    Poller poller(kGoesOn);
    const auto planes = EdgePlanes::make(space.impl(), lattice, poller);
    ASSERT_TRUE(LatticeFlood::takes(lattice));
    std::vector<Connector> starts(2);
    starts[0] = {.x = 40, .y = 40, .heading = 3, .cost = 1.7, .motions = {}};
    starts[1] = {.x = 100, .y = 90, .heading = 8, .motions = {}};
    LatticeFlood::Memory memory;
    LatticeFlood flood(*planes, lattice, grid.width(), grid.height(), memory);
    // Without an end all of the lattice is looked at.
    EXPECT_EQ(flood.run(starts, {}, poller), -1);
    // A path costs what its level says, up to the rounding, and begins at a start.
    std::vector<Segment> path;
    for (int h = 0; h < Lattice::kHeadings; ++h) {
      if (flood.level(60, 60, h) == LatticeFlood::kNever) continue;
      path.clear();
      flood.append(starts, {60, 60}, h, path);
      ASSERT_FALSE(path.empty());
      const Pose end = path.back().end();
      EXPECT_NEAR(end.x, 60.5, 1e-6);
      EXPECT_NEAR(end.y, 60.5, 1e-6);
      EXPECT_NEAR(std::fabs(half_turned(end.yaw - lattice.yaw(h))), 0, 1e-6);
      const double known = vehicle::cost(vehicle, path);
      EXPECT_NEAR(known, flood.cost(60, 60, h), 2 + 0.1 * known);
    }
    const std::vector<int> cost = least_units(grid, space, lattice, starts);
    int reached = 0;
    for (int h = 0; h < Lattice::kHeadings; ++h)
      for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) {
          ASSERT_EQ(flood.level(x, y, h), cost[state_of(grid, x, y, h)])
              << x << " " << y << " " << h;
          reached += flood.level(x, y, h) != LatticeFlood::kNever ? 1 : 0;
        }
    EXPECT_GT(reached, 100);
    // What lies about a goal, beside the border too.
    Steering steering(vehicle);
    for (const Pose& goal : {Pose{60.3, 61.8, 0.4}, Pose{1.2, 128.5, 1}, Pose{158.5, 1.2, 1}}) {
      std::vector<LatticeFlood::Try> tries;
      for (const Cell c : cells_of(grid)) {
        const int away =
            std::max(std::abs(c.x - floor_of(goal.x)), std::abs(c.y - floor_of(goal.y)));
        for (int h = 0; h < Lattice::kHeadings && away <= 3; ++h) {
          const double total =
              flood.cost(c.x, c.y, h) + steering.least(lattice.pose(c.x, c.y, h), goal);
          if (flood.level(c.x, c.y, h) != LatticeFlood::kNever && total < 150)
            tries.push_back({total, c.x, c.y, h});
        }
      }
      std::ranges::sort(tries);
      EXPECT_TRUE(flood.about(goal, 3, 150, steering, poller) == tries);
    }
  }
}

TEST(LatticeFlood, TellsThatItsLevelsRanOut) {
  const Grid grid(80, 40);
  const Vehicle vehicle = omni(rectangle(3, 2, 1));
  const Space space(grid, vehicle);
  const Lattice lattice(vehicle, space.impl().outline());
  Poller poller(kGoesOn);
  const auto planes = EdgePlanes::make(space.impl(), lattice, poller);
  LatticeFlood::Memory memory;
  LatticeFlood flood(*planes, lattice, grid.width(), grid.height(), memory);
  const std::vector<Connector> starts{{.x = 5, .y = 20, .motions = {}}};
  const std::vector<Connector> ends{{.x = 65, .y = 20, .motions = {}}};
  EXPECT_EQ(flood.run(starts, ends, poller, 200), -1);  // 300 lead there
  EXPECT_TRUE(flood.ran_out());
  LatticeFlood whole(*planes, lattice, grid.width(), grid.height(), memory);
  EXPECT_EQ(whole.run(starts, ends, poller, 301), 0);
  EXPECT_FALSE(whole.ran_out());
  LatticeFlood dry(*planes, lattice, grid.width(), grid.height(), memory);
  EXPECT_EQ(dry.run(starts, {}, poller), -1);
  EXPECT_FALSE(dry.ran_out());
  std::vector<Connector> dear{{.x = 5, .y = 20, .cost = 2e4, .motions = {}},
                              {.x = 6, .y = 20, .cost = 3e9, .motions = {}}};
  LatticeFlood above(*planes, lattice, grid.width(), grid.height(), memory);
  EXPECT_EQ(above.run(dear, ends, poller), -1);
  EXPECT_TRUE(above.ran_out());
  dear.push_back(starts[0]);
  LatticeFlood below(*planes, lattice, grid.width(), grid.height(), memory);
  ASSERT_EQ(below.run(dear, ends, poller), 0);
  EXPECT_FALSE(below.ran_out());
  std::vector<Segment> way;
  below.append(dear, {65, 20}, 0, way);
  EXPECT_NEAR(driven_length(way), 60, 1e-9);
  // Nor is it over at the nearer end, the dearer one.
  const std::vector<Connector> two{{.x = 15, .y = 20, .cost = 100, .motions = {}}, ends[0]};
  LatticeFlood further(*planes, lattice, grid.width(), grid.height(), memory);
  EXPECT_EQ(further.run(starts, two, poller), 1);
}

// Longer than levels of 16 bits tell.
TEST(LatticeFlood, LeavesLongWaysToTheSearch) {
  constexpr int kLong = 263;
  Grid grid(kLong, kLong);
  for (int y = 3; y < kLong; y += 4)
    for (int x = 0; x < kLong; ++x)
      if (y % 8 == 3 ? x < kLong - 3 : x > 2) grid.set_blocked({x, y});
  const Planner planner(grid, differential(rectangle(0.5, 0.4, 0.25)));
  const Result found =
      planner.plan({.start = {1.5, 1.5, 0}, .goals = {{10.5, kLong - 1.5, 0}}, .smooth = false});
  EXPECT_EQ(found.status, Status::solved);
  EXPECT_GT(found.cost, LatticeFlood::kNever * LatticeFlood::kUnit);
}

}  // namespace
}  // namespace lasius::vehicle
