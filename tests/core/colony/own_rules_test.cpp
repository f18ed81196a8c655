// Colonies with a caller's own rules: what computes as a built-in rule gives its plan, bit for bit.
#include "lasius/params/own_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/colony/own_update.h"
#include "core/grid/cell_distance.h"
#include "lasius/plan/batch.h"
#include "tests/core/colony/own_published.h"
#include "tests/core/loop/same_result.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

class Rebuilt : public testing::TestWithParam<std::tuple<const char*, Preset>> {};

TEST_P(Rebuilt, APublishedUpdateGivesTheSamePlanFor20Seeds) {
  const auto [name, preset] = GetParam();
  const Planner planner(blobs(60, 40));
  const Request request = far_apart(planner);
  Params params(name, preset);
  params.iterations = 7;
  params.threads = 1;
  params.dead_end = DeadEnd::backtrack;
  int solved = 0;
  for (params.seed = 1; params.seed <= 20; ++params.seed) {
    const Result own = planner.plan(request, params, {.own_rules = rebuilt(params)});
    expect_same(own, planner.plan(request, params));
    EXPECT_TRUE(own.own_rules);
    solved += own.status == Status::solved;
  }
  EXPECT_EQ(solved, 20);
}
INSTANTIATE_TEST_SUITE_P(
    OwnRules, Rebuilt,
    testing::Values(std::tuple("as", Preset::usual), std::tuple("as", Preset::book),
                    std::tuple("eas", Preset::usual), std::tuple("eas", Preset::book),
                    std::tuple("ras", Preset::usual), std::tuple("ras", Preset::book),
                    std::tuple("mmas", Preset::usual), std::tuple("mmas", Preset::book),
                    std::tuple("acs", Preset::usual), std::tuple("acs", Preset::book),
                    std::tuple("cong2009", Preset::usual)),
    [](const auto& test) {
      return std::string(std::get<0>(test.param)) + "_" +
             std::string(to_string(std::get<1>(test.param)));
    });

TEST(OwnRules, ALearnedHeuristicAndDeadEndsGiveTheSamePlan) {
  const Planner planner(generate(MapKind::blobs, {.width = 30, .height = 20, .seed = 5}));
  const Request request = far_apart(planner);
  Params params("cong2009");
  params.iterations = 60;
  params.ants = 5;
  int lost = 0;
  for (params.seed = 1; params.seed <= 20; ++params.seed) {
    const Result own = planner.plan(request, params, {.own_rules = rebuilt(params)});
    expect_same(own, planner.plan(request, params));
    for (const int arrived : own.curves.arrived) lost += 5 - arrived;
  }
  EXPECT_GT(lost, 100);
}

TEST(OwnRules, ThreadsChangeNothing) {
  const FarApart far;
  for (const char* name : {"fan2004", "ras", "mmas", "cong2009"}) {
    Params params = quick(name);
    OwnRules own = rebuilt(params);
    own.schedule = [&](int q) { return schedule(params, q); };
    const Result one = far.plan(params, {.own_rules = own});
    for (const int threads : {2, 5}) {
      params.threads = threads;
      expect_same(far.plan(params, {.own_rules = own}), one);
    }
  }
}

TEST(OwnRules, PolishedPathsAreTheSame) {
  const FarApart far;
  Params params = quick("ras");
  for (const Polish polish : {Polish::straight, Polish::taut, Polish::local}) {
    for (const int threads : {1, 2}) {
      params.polish = polish;
      params.threads = threads;
      params.straight_deposit = StraightDeposit::improving;
      expect_same(far.plan(params, {.own_rules = rebuilt(params)}), far.plan(params));
    }
  }
}

TEST(OwnRules, TheBuiltInScheduleAsAnOwnOneChangesNothing) {
  const FarApart far;
  for (const char* name : colonies()) {
    Params params = quick(name);
    int called = 0;
    const OwnRules own{.schedule = [&](int q) {
      EXPECT_EQ(q, called++);
      return schedule(params, q);
    }};
    expect_same(far.plan(params, {.own_rules = own}), far.plan(params));
    EXPECT_GE(called, 1) << name;
  }
}

TEST(OwnRules, AnOwnScheduleSetsExponentsAndShares) {
  const FarApart far;
  Params params = quick("acs");
  params.heuristic = Heuristic::inverse_distance;
  params.critical_time = 0;
  params.greedy = 0.7;
  params.alpha = 2;
  params.beta = 3;
  const Result expected = far.plan(params);
  params.greedy = 0;
  params.alpha = params.beta = 1;
  const OwnRules own{
      .schedule = [](int) { return StepWeights{.alpha = 2, .beta = 3, .greedy = 0.7}; }};
  expect_same(far.plan(params, {.own_rules = own}), expected);
  EXPECT_NE(far.plan(params).curves.steps, expected.curves.steps);
}

TEST(OwnRules, TheInverseDistanceAsATableChangesNothing) {
  const FarApart far;
  const Grid& grid = far.planner.grid();
  for (const Neighbours neighbours :
       {Neighbours::four, Neighbours::eight, Neighbours::sixteen_knight}) {
    Params params = quick("ras");
    params.neighbours = neighbours;
    params.heuristic = Heuristic::inverse_distance;
    const auto near = [&](Cell c) { return 1 / std::max(distance(c, far.request.goal), 0.5); };
    const auto steps = move_steps(neighbours);
    std::vector<double> by_cell, by_arc;
    for (const Cell c : cells_of(grid)) {
      by_cell.push_back(grid.free(c) ? near(c) : std::nan(""));
      for (const Cell step : steps) by_arc.push_back(near({c.x + step.x, c.y + step.y}));
    }
    const Result expected = far.plan(params);
    params.heuristic = Heuristic::uniform;
    expect_same(far.plan(params, {.own_rules = {.heuristic = by_cell}}), expected);
    expect_same(far.plan(params, {.own_rules = {.heuristic = by_arc}}), expected);
    EXPECT_NE(far.plan(params).curves.steps, expected.curves.steps);
  }
}

TEST(OwnRules, AValueOf0LeavesAMoveAChance) {
  const Planner planner(Grid(12, 3));
  const std::vector<double> nothing(12 * 3, 0);
  Params params = quick("ras");
  const Result result = planner.plan({.start = {0, 1}, .goal = {11, 1}}, params,
                                     {.own_rules = {.heuristic = nothing}});
  EXPECT_EQ(result.status, Status::solved);
}

TEST(OwnRules, FunctionsAreCalledInTurnOnTheCallersThread) {
  const FarApart far;
  Params params = quick("ras");
  params.threads = 5;
  params.polish = Polish::straight;
  const auto here = std::this_thread::get_id();
  std::string calls;
  const OwnRules own{.update =
                         [&](Pheromone&, const IterationTours& tours) {
                           EXPECT_EQ(std::this_thread::get_id(), here);
                           calls += "u" + std::to_string(tours.iteration);
                         },
                     .schedule =
                         [&](int q) {
                           EXPECT_EQ(std::this_thread::get_id(), here);
                           calls += "s" + std::to_string(q);
                           return StepWeights{};
                         }};
  params.iterations = 3;
  (void)far.plan(params,
                 {.observer = [&](const GridProgress&) { calls += "o"; }, .own_rules = own});
  EXPECT_EQ(calls, "s0u0os1u1os2u2o");
}

TEST(OwnRules, AnUpdateStopsTheSearch) {
  const FarApart far;
  for (const int threads : {1, 2, 5}) {
    Params params = quick("ras");
    params.threads = threads;
    int seen = 0;
    const OwnRules own{.update = [](Pheromone&, const IterationTours& tours) {
      return tours.iteration == 3 ? Go::stop : Go::on;
    }};
    const Result result =
        far.plan(params, {.observer = [&](const GridProgress&) { ++seen; }, .own_rules = own});
    EXPECT_EQ(result.status, Status::interrupted);
    EXPECT_EQ(result.curves.iterations, 4);
    EXPECT_EQ(seen, 4);
    EXPECT_FALSE(result.path.empty());
  }
}

TEST(OwnRules, AnUpdateIsFinishedAndRecordedThoughATokenAsksToStop) {
  FarApart far;
  std::stop_source source;
  far.request.stop.token = source.get_token();
  const Params params = quick("ras");
  double before = 0, after = 0;
  const OwnRules own{.update = [&](Pheromone& trail, const IterationTours& tours) {
    if (tours.iteration < 2) return;
    source.request_stop();
    const std::vector<TrailPlace> many(10000, 7);
    trail.get(std::span(many).first(1), {&before, 1});
    trail.add(many, 1);
    trail.get(std::span(many).first(1), {&after, 1});
  }};
  const Result result = far.plan(params, {.own_rules = own});
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_EQ(result.curves.iterations, 3);
  EXPECT_NEAR(after, before + 10000, 50);  // sums of floats
}

TEST(OwnRules, WhatAFunctionThrowsIsThrownOn) {
  struct Mine {};
  const FarApart far;
  for (const int threads : {1, 2, 5}) {
    Params params = quick("ras");
    params.threads = threads;
    Workspace workspace;
    const OwnRules updating{.update = [](Pheromone&, const IterationTours& tours) {
      if (tours.iteration == 2) throw Mine{};
    }};
    EXPECT_THROW(far.plan(params, {.workspace = &workspace, .own_rules = updating}), Mine);
    const OwnRules scheduling{.schedule = [](int) -> StepWeights { throw Mine{}; }};
    EXPECT_THROW(far.plan(params, {.workspace = &workspace, .own_rules = scheduling}), Mine);
    expect_same(far.plan(params, {.workspace = &workspace}), far.plan(params));
  }
}

TEST(OwnRules, AnObserverSeesTheTrail) {
  const FarApart far;
  const Cell c = far.request.start;
  const std::vector<TrailPlace> place{std::int64_t{c.y} * far.planner.grid().width() + c.x};
  const OwnRules own{.update = [&](Pheromone& trail, const IterationTours&) {
    trail.set(place, std::vector{4.5});
  }};
  int seen = 0;
  const auto look = [&](const GridProgress& progress) {
    EXPECT_FLOAT_EQ(static_cast<float>(progress.pheromone(c)), 4.5F);
    ++seen;
  };
  (void)far.plan(quick("ras"), {.observer = look, .own_rules = own});
  EXPECT_GT(seen, 0);
}

TEST(OwnRules, ABatchAnswersAsSinglePlansDo) {
  const Planner planner(blobs());
  const std::vector<Request> requests(3, far_apart(planner));
  Params params = quick("ras");
  params.ranks = 3;
  const OwnRules own = rebuilt(params);
  params.ranks = 6;
  const auto answers = plan_batch(planner, requests, params, {.threads = 3, .seeds = 4}, own);
  ASSERT_EQ(answers.size(), 12U);
  for (const BatchAnswer& answer : answers) {
    params.seed = answer.seed;
    expect_same(answer.result, planner.plan(requests[0], params, {.own_rules = own}));
    EXPECT_TRUE(answer.result.own_rules);
  }
}

TEST(OwnRules, AResultTellsOfThemOnlyWhereThereWereSome) {
  const FarApart far;
  EXPECT_FALSE(far.plan(quick("ras")).own_rules);
  EXPECT_FALSE(far.plan(quick("ras"), {.own_rules = {}}).own_rules);
  EXPECT_FALSE(far.plan(Params("exact"), {.own_rules = {}}).own_rules);
  const OwnRules own{.schedule = [](int) { return StepWeights{}; }};
  EXPECT_TRUE(far.plan(quick("ras"), {.own_rules = own}).own_rules);
}

TEST(OwnRules, ToursAreNumberedByCellAndByMove) {
  // From (0, 0) right, right, down; and one that was lost after a move down.
  Grid grid(5, 4);
  const kernels::Moves moves = moves_of(Neighbours::four);  // up, left, right, down
  const std::vector<std::uint8_t> arrived{2, 2, 3}, lost{3};
  const std::vector<Tour> ants{{lost, std::nan("")}, {arrived, 3}};
  std::vector<int> ranking;
  const Tours tours{
      .start = {1, 1}, .moves = moves, .ants = ants, .best_so_far = ants[1], .ranking = ranking};
  NumberedTours numbered;
  const auto view = numbered.view(tours, grid, Trail::arcs);
  const auto list = [](auto span) { return std::vector<std::int64_t>(span.begin(), span.end()); };
  using List = std::vector<std::int64_t>;
  EXPECT_EQ(list(view.places_of(1)), (List{26, 30, 35}));  // before the others
  const auto cells = view.cells();
  EXPECT_EQ(list(cells), (List{6, 11, 6, 7, 8, 13}));
  EXPECT_EQ(list(view.offsets), (List{0, 2, 6}));
  EXPECT_EQ(list(view.arcs()), (List{6 * 4 + 3, 6 * 4 + 2, 7 * 4 + 2, 8 * 4 + 3}));
  EXPECT_EQ(list(view.places_of(0)), (List{27}));
  EXPECT_EQ(list(view.best_cells()), (List{6, 7, 8, 13}));
  EXPECT_EQ(list(view.best_places()), (List{26, 30, 35}));
  EXPECT_EQ(view.best_length, 3);
  EXPECT_FALSE(view.arrived(0));
  EXPECT_TRUE(view.arrived(1));

  const auto by_cell = numbered.view(tours, grid, Trail::cells);
  EXPECT_NE(by_cell.memory, view.memory);  // which is kept
  EXPECT_TRUE(by_cell.arcs().empty());
  EXPECT_EQ(list(by_cell.cells_of(0)), (List{6, 11}));
  EXPECT_EQ(list(cells), (List{6, 11, 6, 7, 8, 13}));
  EXPECT_EQ(list(by_cell.places_of(1)), (List{6, 7, 8, 13}));
  EXPECT_EQ(list(by_cell.best_places()), (List{6, 7, 8, 13}));
}

TEST(OwnRules, StepsAreInScanOrder) {
  EXPECT_EQ(move_steps(Neighbours::four), (std::vector<Cell>{{0, -1}, {-1, 0}, {1, 0}, {0, 1}}));
  const auto knight = move_steps(Neighbours::sixteen_knight);
  ASSERT_EQ(knight.size(), 16U);
  EXPECT_EQ(knight[0], (Cell{-1, -2}));
  EXPECT_EQ(knight[15], (Cell{1, 2}));
}

}  // namespace
}  // namespace lasius
