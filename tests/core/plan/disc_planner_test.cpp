// Planners of a disc: what is planned keeps the radius, by an independent distance.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "lasius/base/error.h"
#include "lasius/plan/batch.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/base/refusal.h"
#include "tests/core/disc/disc_worlds.h"
#include "tests/oracle/disc_paths.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

constexpr double kRoom = 1e-9;  // of a clearance

double least_clearance(const oracle::DiscPaths& judge, const Result& result) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < result.path.size(); ++i)
    least = std::min(least, judge.clearance(result.path[i - 1], result.path[i]));
  for (const CurvePiece& piece : result.curve) {
    if (piece.turn == 0) {
      least = std::min(least, judge.clearance(piece.from, piece.to));
      continue;
    }
    const double from = std::atan2(piece.from.y - piece.centre.y, piece.from.x - piece.centre.x);
    const double to = from + piece.turn * piece.angle;
    least =
        std::min(least, judge.arc_clearance(piece.centre, std::min(from, to), std::max(from, to)));
    EXPECT_NEAR(piece.centre.x + piece.radius * std::cos(to), piece.to.x, 1e-9);
    EXPECT_NEAR(piece.centre.y + piece.radius * std::sin(to), piece.to.y, 1e-9);
  }
  return least;
}

Params small(std::string_view algorithm, int threads = 1) {
  Params params{algorithm};
  params.threads = threads;
  if (find_algorithm(algorithm).has("iterations")) params.iterations = 4;
  if (find_algorithm(algorithm).has("ants")) params.ants = std::min(params.ants, 8);
  return params;
}

bool same(const Result& a, const Result& b) {
  return a.status == b.status && a.path == b.path && a.curve == b.curve && a.error == b.error &&
         (a.length == b.length || a.path.empty()) && a.lower_bound == b.lower_bound;
}

/// Judges the leg out of where the robot stands, if there is one, and takes it away.
Result from_way_out(const Planner& planner, const oracle::DiscPaths& judge, const Request& request,
                    Result result, double radius) {
  if (!result.way_out) return result;
  const Point start = centre(request.start), out = *result.way_out;
  EXPECT_TRUE(planner.grid().free(request.start));
  EXPECT_GE(judge.clearance(out), radius - kRoom);
  EXPECT_GE(judge.clearance(start, out), std::min(radius, judge.clearance(start)) - kRoom);
  EXPECT_TRUE(!result.optimal && !result.lower_bound && !result.gap());
  if (result.path.empty()) return result;
  EXPECT_EQ(result.path.front(), start);
  EXPECT_EQ(result.path[1], out);
  result.path.erase(result.path.begin());
  if (!result.curve.empty()) {
    EXPECT_EQ(result.curve.front(), (CurvePiece{.from = start, .to = out}));
    result.curve.erase(result.curve.begin());
  }
  result.length -= std::hypot(out.x - start.x, out.y - start.y);
  return result;
}

struct Walks {
  int walked = 0, closed_to_cells = 0;
};

/// What every other algorithm plans keeps the radius, and is no shorter than what `exact` found.
void judge_colonies(const Planner& planner, const oracle::DiscPaths& judge, const Request& request,
                    const Result& exact, double radius, Walks& walks) {
  for (const Algorithm& algorithm : algorithms()) {
    if (algorithm.kind == Algorithm::Kind::exact) continue;
    const Result whole = planner.plan(request, small(algorithm.name));
    const Result colony = from_way_out(planner, judge, request, whole, radius);
    EXPECT_TRUE(colony.curve.empty());
    if (!whole.curves.best.empty() && !whole.path.empty()) {
      EXPECT_EQ(whole.curves.best.back(), whole.length);
    }
    walks.closed_to_cells += exact.status == Status::solved && colony.path.empty();
    if (colony.path.size() < 2) continue;
    ++walks.walked;
    EXPECT_GE(least_clearance(judge, colony), radius - kRoom) << algorithm.name;
    if (!exact.way_out) {
      EXPECT_GE(whole.length, exact.length * (1 - 1e-12)) << algorithm.name;
    }
  }
}

TEST(DiscPlanner, AllThatIsPlannedKeepsTheRadius) {
  std::mt19937 random(3);
  int curved = 0, led = 0, not_led = 0;
  Walks walks;
  for (int round = 0; round < 100; ++round) {
    const double radius = disc::random_radius(round % 5 == 0 ? 6 : 2.5, random);
    const Grid grid = disc::random_map(radius, random);
    const Planner planner(grid, Disc{radius});
    const Planner prepared(grid, PrepareOptions{.threads = 1 + round % 5}, Disc{radius});
    EXPECT_EQ(planner.grid(), grid);
    const oracle::DiscPaths judge(grid, radius, oracle::DiscPaths::Lines::none);
    for (const Cell c : cells_of(grid))
      ASSERT_EQ(planner.passable().free(c), grid.free(c) && judge.clear(centre(c)));
    for (int i = 0; i < 3; ++i) {
      const Request request{random_cell(grid, random), random_cell(grid, random)};
      const Result exact = planner.plan(request);
      const bool stands = grid.free(request.start) && judge.clear(centre(request.start));
      const bool ends = grid.free(request.goal) && judge.clear(centre(request.goal));
      if (stands || !ends || grid.blocked(request.start)) {
        EXPECT_EQ(exact.status == Status::invalid, !stands || !ends) << exact.error;
        EXPECT_EQ(exact.way_out, std::nullopt);
      } else {
        ++(exact.way_out ? led : not_led);
        EXPECT_EQ(exact.status == Status::invalid, !exact.way_out) << exact.error;
      }
      const Result again = prepared.plan(request);
      EXPECT_EQ(again.status, exact.status);
      EXPECT_EQ(again.way_out, exact.way_out);
      if (exact.way_out && !exact.path.empty()) {
        const Result rest = from_way_out(planner, judge, request, exact, radius);
        EXPECT_GE(least_clearance(judge, rest), radius - kRoom);
        EXPECT_NEAR(again.length, exact.length, 1e-9);
      } else if (exact.status == Status::solved && request.start != request.goal) {
        ++curved;
        EXPECT_TRUE(exact.optimal);
        EXPECT_NEAR(again.length, exact.length, 1e-9);
        EXPECT_GE(least_clearance(judge, exact), radius - kRoom);
        EXPECT_GE(least_clearance(judge, again), radius - kRoom);
        const double polyline = path_length(exact.path);
        EXPECT_GE(polyline, exact.length * (1 - 1e-12));
        EXPECT_LE(polyline, exact.length * 1.001);
        EXPECT_GE(*planner.widest_disc(request.start, request.goal), radius - kRoom);
      } else if (exact.status == Status::unreachable) {
        EXPECT_LT(planner.widest_disc(request.start, request.goal).value_or(0), radius);
      }
      judge_colonies(planner, judge, request, exact, radius, walks);
    }
  }
  EXPECT_GT(curved, 40);
  EXPECT_GT(walks.walked, 100);
  EXPECT_LT(walks.closed_to_cells, walks.walked / 2);
  EXPECT_GT(led, 10);
  EXPECT_GT(not_led, 0);
}

TEST(DiscPlanner, ACorridorAsWideAsTheDiscIsOpen) {
  const Grid grid = walled(40, 21, {{10, 0, 20, 9}, {10, 12, 20, 9}});
  const Request request{{3, 3}, {36, 17}};
  for (const auto& [radius, open] : {std::pair{1.5, true}, {1.5 + 1e-6, false}, {0.7, true}}) {
    const Planner planner(grid, Disc{radius});
    const Result result = planner.plan(request);
    EXPECT_EQ(result.status, open ? Status::solved : Status::unreachable) << radius;
    EXPECT_EQ(result.optimal, open);
    EXPECT_EQ(planner.joined(request.start, request.goal), open);
    EXPECT_EQ(planner.widest_disc(request.start, request.goal), 1.5);
  }
  EXPECT_EQ(Planner(grid).widest_disc({3, 3}, {3, 4}), 3.5) << "as near as the ends are";
  EXPECT_EQ(Planner(grid).widest_disc({3, 3}, {15, 3}), std::nullopt) << "into a wall";
}

TEST(DiscPlanner, AnswersDependOnNoThreads) {
  std::mt19937 random(8);
  const Grid grid = random_grid(70, 50, 1, random);
  const Planner planner(grid, Disc{0.8});
  std::vector<Request> requests;
  for (int i = 0; i < 12; ++i)
    requests.push_back({random_cell(grid, random), random_cell(grid, random)});
  const Planner prepared = planner.prepared({.threads = 1});
  EXPECT_EQ(prepared.preparation().state, Preparation::State::ready);
  EXPECT_GT(prepared.preparation().edges, 0);
  for (const int threads : {1, 2, 5}) {
    const auto batch = plan_batch(planner, requests, {}, {.threads = threads});
    const Planner other = planner.prepared({.threads = threads});
    ASSERT_EQ(batch.size(), requests.size());
    for (std::size_t i = 0; i < requests.size(); ++i) {
      EXPECT_TRUE(same(batch[i].result, planner.plan(requests[i])));
      EXPECT_TRUE(same(prepared.plan(requests[i]), other.plan(requests[i])));
      EXPECT_TRUE(same(planner.plan(requests[i], small("as", 1)),
                       planner.plan(requests[i], small("as", threads))));
    }
  }
}

TEST(DiscPlanner, AGraphThatWouldTakeTooMuchIsGivenUp) {
  const Planner planner(with_blocked(30, 20, {{10, 8}, {20, 12}}), Disc{0.8});
  const Preparation whole = planner.prepared({}).preparation();
  EXPECT_EQ(planner.prepared({.max_bytes = whole.bytes}).preparation().edges, whole.edges);
  const Preparation less = planner.prepared({.max_bytes = whole.bytes - 1}).preparation();
  EXPECT_EQ(less.state, Preparation::State::too_large);
  EXPECT_EQ(less.bytes, 0);
}

TEST(DiscPlanner, RadiiThatItIsNotMadeFor) {
  for (const double radius : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(Planner(Grid(9, 9), Disc{radius}), Error) << radius;
  const Planner wide(Grid(200, 200), Disc{60}), thin(Grid(9, 9), Disc{0.01});
  EXPECT_EQ(wide.plan({{70, 70}, {120, 130}}, small("as")).status, Status::solved);
  for (const Planner* planner : {&wide, &thin}) {
    const Request request{{4, 4}, {5, 4}};
    EXPECT_THROW((void)planner->plan(request), Error);
    EXPECT_THROW((void)plan_batch(*planner, std::span(&request, 1)), Error);
  }
  expect_says(refusal([&] {
                (void)wide.plan({{70, 70}, {120, 130}});
              }),
              "radius is 60; for exact a disc's radius is between");
  const Planner point(Grid(9, 9), Disc{});
  EXPECT_TRUE(point.plan({{0, 0}, {8, 5}}).curve.empty());
  EXPECT_EQ(point.plan({{0, 0}, {8, 5}}).path, Planner(Grid(9, 9)).plan({{0, 0}, {8, 5}}).path);
}

TEST(DiscPlanner, EndsInCellsThatAreFreeInPart) {  // for all algorithms
  const Planner planner(Grid(20, 9), Disc{1.5});
  const Request request{{1, 4}, {18, 4}};
  EXPECT_TRUE(planner.clear({1, 4}));
  EXPECT_TRUE(planner.passable().free({1, 4}));
  EXPECT_EQ(planner.plan(request).length, 17);
  EXPECT_EQ(planner.plan(request, small("as")).way_out, std::nullopt);
  const Result led = planner.plan({{0, 4}, {16, 4}}, small("as"));
  EXPECT_EQ(led.status, Status::solved);
  EXPECT_EQ(led.way_out, (Point{1.5, 4.5}));
  EXPECT_EQ(led.curves.best.back(), led.length);
  const Result refused = planner.plan({{16, 4}, {0, 4}}, small("as"));
  EXPECT_EQ(
      refused.error,
      "goal (0, 4) is nearer to what is blocked than the radius of 1.5; the nearest free cell "
      "is (1, 4)");
  const Result outside = planner.plan({{18, 4}, {0, 4}});
  EXPECT_EQ(outside.nearest_free, (Cell{1, 4}));
  EXPECT_EQ(outside.nearest_reachable, (Cell{1, 4}));
  EXPECT_EQ(outside.fault, Fault::goal_blocked);
  const Result near = planner.plan({.start = {1, 4}, .goal = {19, 0}, .goal_tolerance = 2});
  EXPECT_EQ(near.status, Status::solved);
  EXPECT_EQ(near.goal_reached, (Cell{18, 1}));
}

TEST(DiscPlanner, AnEditedMapIsPlannedAnew) {
  Grid grid(30, 15);
  const Planner before(grid, Disc{1.2});
  std::vector<Planner::Edit> edits;
  for (int y = 2; y < 13; ++y) edits.push_back({{15, y}, true});
  for (const auto& edit : edits) grid.set_blocked(edit.cell);
  const Planner after = *before.edited(edits), anew(grid, Disc{1.2});
  EXPECT_EQ(after.grid(), grid);
  EXPECT_EQ(after.robot().radius, 1.2);
  const Request request{{3, 7}, {26, 7}};
  EXPECT_TRUE(same(after.plan(request), anew.plan(request)));
  EXPECT_EQ(after.plan(request).status, Status::unreachable) << "2 cells are left on each side";
  const Planner::Direction ahead{{14, 1}, 1, 0};
  const Planner shut = *before.exclude(std::span(&ahead, 1));
  EXPECT_TRUE(shut.grid().blocked({15, 1}));
  EXPECT_EQ(shut.allow(std::span(&ahead, 1))->grid(), before.grid());
}

TEST(DiscPlanner, EditedPlannersPlanAsFreshOnesBitForBit) {
  std::mt19937 random(6);
  int found = 0;
  for (int round = 0; round < 20; ++round) {
    const double radius = round % 10 == 9 ? 60 : disc::random_radius(4, random);
    Grid grid = random_grid(150 + random_in(0, 60, random), 150, 1, random);
    Planner planner(grid, Disc{radius});
    for (int edit = 0; edit < 5; ++edit) {
      std::vector<Planner::Edit> edits;
      const Cell at = random_cell(grid, random);
      for (const Cell c : cells_of({at.x, at.y, 10, 10})) {
        if (grid.contains(c)) edits.push_back({c, random_in(0, 2, random) == edit % 2});
      }
      edits.push_back({random_cell(grid, random), edit % 2 == 0});
      for (const auto& one : edits) grid.set_blocked(one.cell, one.blocked);
      planner = *planner.edited(edits);
      const Planner fresh(grid, Disc{radius});
      ASSERT_EQ(planner.grid(), grid);
      ASSERT_EQ(planner.passable(), fresh.passable());
      ASSERT_EQ(planner.components(), fresh.components());
      if (round % 10 == 9) continue;
      const bool graphs = edit == 4 && radius > 1;
      const Planner prepared = graphs ? planner.prepared({}) : planner;
      const Planner fresh_prepared = graphs ? fresh.prepared({}) : fresh;
      ASSERT_EQ(prepared.preparation().edges, fresh_prepared.preparation().edges);
      for (int i = 0; i < 6; ++i) {
        const Request request{random_cell(grid, random), random_cell(grid, random)};
        const Result result = fresh.plan(request);
        EXPECT_TRUE(same(planner.plan(request), result));
        EXPECT_TRUE(same(prepared.plan(request), fresh_prepared.plan(request)));
        found += result.curve.size() > 1;
      }
    }
  }
  EXPECT_GT(found, 100);
}

TEST(DiscPlanner, IsStopped) {
  std::mt19937 random(2);
  Grid grid = random_grid(400, 400, 1, random);
  EXPECT_FALSE(Planner::make(Grid(grid), Disc{0.9}, fired()));
  const Planner planner(grid, Disc{0.5});
  std::vector<double> lengths;
  Result whole, cut;
  for (int i = 0; i < 100 && lengths.size() < 2; ++i) {
    const Request request{random_cell(grid, random), random_cell(grid, random)};
    lengths.clear();
    whole = planner.plan(request, {}, {.observer = [&](const GridProgress& seen) {
                           lengths.push_back(seen.best_length);
                         }});
    cut = planner.plan(request, {}, {.observer = [](const GridProgress&) { return Go::stop; }});
  }
  ASSERT_GE(lengths.size(), 2U) << "no question with several paths";
  EXPECT_EQ(lengths.back(), whole.length) << "of the curve";
  EXPECT_EQ(cut.status, Status::interrupted);
  EXPECT_GT(*cut.lower_bound, 0);
  EXPECT_LE(*cut.lower_bound, whole.length);
  EXPECT_GE(cut.length, whole.length);
}

TEST(DiscPlanner, LongWaysPastFewObstaclesAreTheSameByTheGraph) {
  std::mt19937 random(5);
  int bent = 0;
  for (int round = 0; round < 40; ++round) {
    const double radius = std::array{0.5, 2.0, 4.4, 9.0}[round % 4];
    Grid grid(400, 90);
    for (int i = 0; i < 40 - 3 * (round % 4) * (round % 4); ++i)
      grid.fill({random_in(0, 395, random), random_in(0, 87, random), 1 + i % 5, 1 + i % 3}, true);
    const Planner planner(grid, Disc{radius});
    const Planner prepared(grid, PrepareOptions{}, Disc{radius});
    for (int i = 0; i < 8; ++i) {
      const Request request{random_cell(grid, random), random_cell(grid, random)};
      const Result one = planner.plan(request), other = prepared.plan(request);
      EXPECT_EQ(one.status, other.status);
      if (one.path.empty()) continue;
      EXPECT_NEAR(one.length, other.length, 1e-9) << "round " << round << ", question " << i;
      EXPECT_TRUE(one.way_out || (one.optimal && other.optimal));
      bent += one.curve.size() > 1;
    }
  }
  EXPECT_GT(bent, 60);
}

TEST(DiscPlanner, PassesBetweenCornersThatItTouchesAtOnce) {
  Grid grid(21, 12);
  for (const Cell c : {Cell{16, 1}, {9, 3}, {9, 4}, {13, 4}, {6, 6}, {4, 9}}) grid.set_blocked(c);
  const double touching = std::sqrt(2.0);
  for (const double radius : {touching, std::nextafter(touching, 0), touching - 1e-9}) {
    const Planner planner(grid, Disc{radius});
    for (const Planner& with : {planner, planner.prepared({})}) {
      EXPECT_NEAR(with.plan({{19, 10}, {2, 3}}).length, 21.7655927628, 3e-9);
      EXPECT_NEAR(with.plan({{2, 3}, {19, 10}}).length, 21.7655927628, 3e-9);
    }
  }
}

}  // namespace
}  // namespace lasius
