// Whole plans between points, by every kind of algorithm.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "lasius/grid/clearance.h"
#include "lasius/path/path.h"
#include "tests/worlds/changing_world.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

/// A point near a cell's centre, in the cell.
Point beside(Cell c, std::mt19937& random) {
  const auto part = [&] { return static_cast<double>(random() % 4096) / 4096; };
  return {c.x + part(), c.y + part()};
}

class PlanBetweenPoints : public testing::TestWithParam<const char*> {};

TEST_P(PlanBetweenPoints, BeginsAndEndsThere) {
  const FarApart far;
  std::mt19937 random(2);
  for (const Polish polish : {Polish::none, Polish::straight, Polish::taut, Polish::local}) {
    Params params = quick(GetParam());
    params.polish = polish;
    Request request = far.request;
    request.start_point = beside(request.start, random);
    request.goal_point = beside(request.goal, random);
    const Result cells = far.planner.plan(far.request, params);
    int told = 0;
    const Result result =
        far.planner.plan(request, params, {.observer = [&](const GridProgress&) { ++told; }});
    SCOPED_TRACE(std::string(to_string(polish)));
    if (cells.path.empty()) continue;
    ASSERT_EQ(result.status, Status::solved) << result.error;
    EXPECT_EQ(result.path.front(), *request.start_point);
    EXPECT_EQ(result.path.back(), *request.goal_point);
    EXPECT_EQ(path_fault(far.planner.grid(), result.path, params.corners), std::nullopt);
    EXPECT_NEAR(result.length, path_length(result.path), 1e-9);
    EXPECT_LT(std::abs(result.length - cells.length), 2 * std::sqrt(0.5) + 1e-9);
    EXPECT_EQ(told, result.curves.iterations);
    ASSERT_EQ(result.curves.best.size(), cells.curves.best.size());
    for (std::size_t i = 1; i < result.curves.best.size(); ++i)
      EXPECT_FALSE(result.curves.best[i] > result.curves.best[i - 1]);
    ASSERT_FALSE(result.curves.best.empty());
    EXPECT_EQ(result.curves.best.back(), result.length);
    EXPECT_EQ(result.curves.raw_best, cells.curves.raw_best);  // what ants do is as between centres
    Request exact = request;
    EXPECT_GE(result.length, far.planner.plan(exact).length - 1e-9);
    // A centre is its cell.
    request.start_point = centre(request.start);
    request.goal_point = centre(request.goal);
    const Result same = far.planner.plan(request, params);
    EXPECT_EQ(same.path, cells.path);
    EXPECT_EQ(same.curves.best, cells.curves.best);
  }
}
INSTANTIATE_TEST_SUITE_P(All, PlanBetweenPoints,
                         testing::Values("as", "mmas", "fan2004", "terminal-index", "grid-ga"),
                         by_algorithm);

TEST(PointEndsOfPlans, AreAnsweredAsCellsAre) {
  const Grid grid = drawn({"..#.", "..#.", "###.", "...."});
  const Planner planner(grid), prepared(grid, PrepareOptions{.threads = 1});
  struct Case {
    Point start, goal;
    Status status;
    Fault fault;
    std::string error;
  };
  const std::vector<Case> cases{
      {{0.25, 0.25}, {1.75, 1.5}, Status::solved, Fault::none, ""},
      {{2, 1}, {0, 0}, Status::solved, Fault::none, ""},    // on a wall, on the map's corner
      {{2, 2}, {1, 1}, Status::solved, Fault::none, ""},    // a corner of three walls
      {{3, 1.5}, {4, 4}, Status::solved, Fault::none, ""},  // its other side
      {{3, 3}, {0.5, 3}, Status::solved, Fault::none, ""},  // around no wall
      {{1.5, 0.5},
       {3.25, 0.5},
       Status::unreachable,
       Fault::disconnected,
       "start (1, 0) and goal (3.25, 0.5) lie in different regions of free cells"},
      {{2.5, 1.5}, {1.5, 0.5}, Status::invalid, Fault::start_blocked, "start (2, 1) is blocked; "},
      {{2.25, 2},
       {1.5, 0.5},
       Status::invalid,
       Fault::start_blocked,
       "start (2.25, 2) is blocked; "},
      {{1.5, 0.5},
       {4.25, 1},
       Status::invalid,
       Fault::goal_outside,
       "goal (4.25, 1) is outside the map; "},
      {{-1e300, 0.5},
       {0.5, 0.5},
       Status::invalid,
       Fault::start_outside,
       "start (-1e+300, 0.5) is outside the map; the nearest free cell is (0, 0)"},
      {{0.5, 3.5},
       {1e300, 3.5},
       Status::invalid,
       Fault::goal_outside,
       "goal (1e+300, 3.5) is outside the map; the nearest free cell is (3, 3)"},
      {{0.5, 3.5},
       {1.5, 2e9},
       Status::invalid,
       Fault::goal_outside,
       "goal (1.5, 2e+09) is outside the map; the nearest free cell is (1, 3)"},
      {{std::nan(""), 0.5},
       {0.5, 0.5},
       Status::invalid,
       Fault::start_outside,
       "start (nan, 0.5) is "}};
  for (const auto& [start, goal, status, fault, error] : cases) {
    const Request request{.start_point = start, .goal_point = goal};
    for (const Result& result :
         {planner.plan(request), prepared.plan(request), planner.plan(request, quick("as"))}) {
      SCOPED_TRACE(testing::Message() << start.x << ',' << start.y << " to " << goal.x);
      EXPECT_EQ(result.status, status) << result.error;
      EXPECT_EQ(result.fault, fault);
      EXPECT_EQ(result.error.substr(0, error.size()), error);
      if (status != Status::solved) continue;
      EXPECT_EQ(result.path.front(), start);
      EXPECT_EQ(result.path.back(), goal);
    }
  }
}

TEST(PointEndsOfPlans, AHairFromAWallHaveTheWaysOfTheGraph) {
  Draw draw(5);
  int asked = 0;
  for (int maps = 0; maps < 40; ++maps) {
    const Grid grid = grid_of(14, 14, [&](int, int) { return draw.one_in(3); });
    const Planner planner(grid), prepared(grid, PrepareOptions{.threads = 1});
    for (const Cell from : cells_of({1, 0, 13, 14})) {
      const Cell to = draw_free(draw, grid);
      if (grid.blocked(from) || grid.free({from.x - 1, from.y})) continue;
      if (from == to || !planner.connected(from, to)) continue;
      for (const double off : {1e-12, 1e-6, 3e-5, 1e-4}) {
        const Point beside_wall{from.x + off, from.y + 0.38};
        for (const bool back : {false, true}) {
          Request request{.start_point = beside_wall, .goal_point = centre(to)};
          if (back) std::swap(request.start_point, request.goal_point);
          const Result result = planner.plan(request), other = prepared.plan(request);
          ASSERT_EQ(result.status, Status::solved) << result.error;
          ASSERT_EQ(other.status, Status::solved) << other.error;
          EXPECT_NEAR(result.length, other.length, 1e-9);
          ++asked;
        }
      }
    }
  }
  EXPECT_GT(asked, 4000);
}

TEST(PointEndsOfPlans, OfADiscKeepItsRadius) {
  Grid grid = walled(40, 30, {{12, 0, 2, 20}, {24, 8, 2, 22}});
  for (const double radius : {0.75, 1.5, 0.04}) {
    const Planner planner(grid, Disc{radius});
    for (const char* algorithm : {"exact", "as"}) {
      if (radius < 0.05 && std::string(algorithm) == "exact") continue;
      Params params = quick(algorithm);
      for (const Polish polish : {Polish::none, Polish::straight, Polish::taut}) {
        params.polish = std::string(algorithm) == "exact" ? params.polish : polish;
        SCOPED_TRACE(std::string(algorithm) + " " + std::to_string(radius) + " " +
                     std::string(to_string(polish)));
        const Request request{.start_point = Point{2.2, 5.9}, .goal_point = Point{37.3, 20.6}};
        const Result result = planner.plan(request, params);
        ASSERT_EQ(result.status, Status::solved) << result.error;
        EXPECT_EQ(result.way_out, std::nullopt);
        EXPECT_EQ(result.path.front(), *request.start_point);
        EXPECT_EQ(result.path.back(), *request.goal_point);
        for (std::size_t i = 1; i < result.path.size(); ++i)
          for (int k = 0; k <= 64; ++k) {
            const double t = k / 64.0;
            const Point a = result.path[i - 1], b = result.path[i];
            const Point p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
            EXPECT_GE(nearest_blocked(grid, p, 3).distance, radius - 1e-8);
          }
      }
    }
    if (radius < 0.05) continue;
    // Nearer than that it is led out, to the point nearest to it, and a goal is refused.
    const Result out =
        planner.plan({.start_point = Point{11.5, 10.25}, .goal_point = Point{5.25, 5.25}});
    ASSERT_TRUE(out.way_out.has_value() == (radius > 0.5)) << out.error;
    EXPECT_NEAR(out.way_out->x, 12 - radius, 1e-8);
    EXPECT_EQ(out.path.front(), (Point{11.5, 10.25}));
    const Result in =
        planner.plan({.start_point = Point{5.25, 5.25}, .goal_point = Point{11.5, 10.25}});
    EXPECT_EQ(in.fault, Fault::goal_blocked) << in.error;
  }
}

TEST(Via, JoinsTheLegs) {
  const FarApart far;
  const Grid& grid = far.planner.grid();
  const Cell middle =
      *far.planner.nearest_reachable({grid.width() / 2, grid.height() / 2}, far.request.start);
  for (const char* algorithm : {"exact", "as"}) {
    const Params params = quick(algorithm);
    Request request = far.request;
    request.via = {centre(middle), {middle.x + 0.25, middle.y + 0.75}, centre(request.start)};
    const Result whole = far.planner.plan(request, params);
    ASSERT_EQ(whole.status, Status::solved) << whole.error;
    double length = 0, bound = 0;
    int iterations = 0;
    std::vector<Point> path;
    for (std::size_t i = 0; i <= request.via.size(); ++i) {
      Request leg = far.request;
      if (i > 0) leg.start_point = request.via[i - 1];
      if (i < request.via.size()) leg.goal_point = request.via[i];
      const Result one = far.planner.plan(leg, params);
      length += one.length;
      bound += one.lower_bound.value_or(0);
      iterations += one.curves.iterations;
      path.insert(path.end(), one.path.begin() + (i > 0), one.path.end());
    }
    EXPECT_EQ(whole.path, path);
    EXPECT_EQ(whole.length, length);
    EXPECT_NEAR(path_length(path), length, 1e-9);
    EXPECT_EQ(whole.optimal, params.algorithm() == "exact");
    EXPECT_EQ(whole.lower_bound.value_or(0), bound);
    EXPECT_EQ(whole.curves.iterations, iterations);
    ASSERT_EQ(whole.curves.mean.size(), static_cast<std::size_t>(iterations));
    if (iterations == 0) continue;
    EXPECT_TRUE(std::isnan(whole.curves.best.front()));
    EXPECT_EQ(whole.curves.best.back(), length);
  }
}

TEST(Via, ALegWithoutAPathHasNoBoundOfAll) {
  FarApart far{Planner(blobs(900, 900))};
  far.request.stop.deadline = Clock::now();
  const Result leg = far.plan();
  EXPECT_TRUE(leg.path.empty() && leg.lower_bound);
  far.request.via = {centre(far.request.goal)};
  EXPECT_EQ(far.plan().lower_bound, std::nullopt);
}

TEST(Via, TellsWhichCannotBeReached) {
  const Grid grid = drawn({"..#.", "..#.", "###.", "...."});
  struct Case {
    std::vector<Point> via;
    Status status;
    std::optional<int> bad;
    std::string error;
  };
  const std::vector<Case> cases{
      {{{1.5, 1.5}, {0.25, 1}}, Status::solved, {}, ""},
      {{{1.5, 1.5}, {2.5, 0.5}}, Status::invalid, 1, "via point 2 (2, 0) is blocked; the nearest"},
      {{{9, 1.5}}, Status::invalid, 0, "via point 1 (9, 1.5) is outside the map; "},
      {{{1.5, 1.5}, {3.25, 0.5}},
       Status::unreachable,
       1,
       "via point 1 (1, 1) and via point 2 (3.25, 0.5) lie in different regions"}};
  for (const auto& [via, status, bad, error] : cases) {
    Request request{.start = {0, 0}, .goal = {1, 0}};
    request.via = via;
    const Result result = Planner(grid).plan(request);
    EXPECT_EQ(result.status, status);
    EXPECT_EQ(result.bad_via, bad);
    EXPECT_EQ(result.error.substr(0, error.size()), error);
  }
  Request request{.start = {0, 0}, .goal = {3, 0}};
  request.via = {{1.5, 1.5}};
  const Result last = Planner(grid).plan(request);
  EXPECT_EQ(last.bad_via, std::nullopt);
  EXPECT_TRUE(last.error.starts_with("via point 1 (1, 1) and goal (3, 0) lie in")) << last.error;
}

TEST(PointEndsOfPlans, WithAGoalToleranceEndAtACellsCentre) {
  const Grid grid = drawn({"..#.", "..#.", "..#.", "..#."});
  Request request{
      .goal_tolerance = 3, .start_point = Point{0.25, 0.5}, .goal_point = Point{3.25, 1.25}};
  const Result near = Planner(grid).plan(request);
  ASSERT_EQ(near.status, Status::solved) << near.error;
  EXPECT_EQ(near.goal_reached, (Cell{1, 1}));
  EXPECT_EQ(near.path, (std::vector<Point>{{0.25, 0.5}, {1.5, 1.5}}));
  request.goal_tolerance = 1;
  EXPECT_EQ(Planner(grid).plan(request).status, Status::unreachable);
}

}  // namespace
}  // namespace lasius
