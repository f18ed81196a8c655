// Planning on a map with the heavier preparation, and on what is made from it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "lasius/plan/batch.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/base/made_files.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

const Grid& map() {
  static const Grid grid = generate(MapKind::rooms, {160, 120, -1, 2});
  return grid;
}

std::vector<Request> some_queries(int count) {
  std::mt19937 random(3);
  std::vector<Request> queries;
  while (static_cast<int>(queries.size()) < count) {
    queries.push_back({random_cell(map(), random), random_cell(map(), random)});
  }
  return queries;
}

void expect_as_good(const Result& prepared, const Result& plain) {
  EXPECT_EQ(prepared.status, plain.status);
  EXPECT_EQ(prepared.error, plain.error);
  EXPECT_EQ(prepared.optimal, plain.optimal);
  EXPECT_EQ(prepared.path.empty(), plain.path.empty());
  if (plain.path.empty()) return;
  EXPECT_NEAR(prepared.length, plain.length, 1e-9 * plain.length);
}

TEST(PreparedPlanner, IsMadeFromAPlannerToo) {
  const Planner plain = *Planner(map()).edited(std::vector<Planner::Edit>{{{3, 3}, true}});
  const Planner at_once(plain.grid(), PrepareOptions{.threads = 1});
  const Planner later = plain.prepared({.threads = 2});
  EXPECT_EQ(plain.preparation().state, Preparation::State::none);
  ASSERT_EQ(later.preparation().state, Preparation::State::ready);
  EXPECT_EQ(later.preparation().edges, at_once.preparation().edges);
  EXPECT_EQ(later.grid(), plain.grid());
  for (const Request& request : some_queries(50)) {
    EXPECT_EQ(later.plan(request).path, at_once.plan(request).path);
  }
  const Planner stopped = plain.prepared({.stop = fired()});
  EXPECT_EQ(stopped.preparation().state, Preparation::State::stopped);
  EXPECT_EQ(stopped.plan({.start = {0, 0}, .goal = {0, 0}}).status,
            plain.plan({.start = {0, 0}, .goal = {0, 0}}).status);
}

TEST(PreparedPlanner, AnswersAsTheUnpreparedOne) {
  const Planner plain(map());
  const Planner prepared(map(), PrepareOptions{.threads = 2});
  EXPECT_EQ(plain.preparation().state, Preparation::State::none);
  EXPECT_EQ(plain.footprint().visibility_graph, 0);
  ASSERT_EQ(prepared.preparation().state, Preparation::State::ready);
  EXPECT_GT(prepared.preparation().edges, prepared.preparation().vertices);
  EXPECT_EQ(prepared.footprint().visibility_graph, prepared.preparation().bytes);
  Workspace workspace;
  int solved = 0, invalid = 0;
  for (const Request& request : some_queries(200)) {
    const Result result = prepared.plan(request, {}, {.workspace = &workspace});
    expect_as_good(result, plain.plan(request));
    solved += result.status == Status::solved;
    invalid += result.status == Status::invalid;
  }
  EXPECT_GT(solved, 50);
  EXPECT_GT(invalid, 5);
  EXPECT_EQ(prepared.plan({.start = {0, 0}, .goal = {0, 0}}).status,
            plain.plan({.start = {0, 0}, .goal = {0, 0}}).status);
}

TEST(PreparedPlanner, GivenUpItPlansWithout) {
  const Planner small(map(), PrepareOptions{.threads = 1, .max_bytes = 1000});
  EXPECT_EQ(small.preparation().state, Preparation::State::too_large);
  EXPECT_EQ(small.footprint().visibility_graph, 0);
  const Planner cut(map(), PrepareOptions{.stop = fired()});
  EXPECT_EQ(cut.preparation().state, Preparation::State::stopped);
  const Planner plain(map());
  for (const Request& request : some_queries(20)) {
    EXPECT_EQ(small.plan(request).path, plain.plan(request).path);
    EXPECT_EQ(cut.plan(request).path, plain.plan(request).path);
  }
}

TEST(PreparedPlanner, RefusesThreadsOutOfRangeAndKeepsTheMap) {
  const Planner plain(map());
  for (const int threads : {-1, 1025}) {
    const PrepareOptions options{.threads = threads};
    EXPECT_THROW(Planner(map(), options), Error);
    EXPECT_THROW((void)plain.prepared(options), Error);
    Grid grid = map();
    EXPECT_THROW((void)Planner::make_prepared(std::move(grid), options), Error);
    EXPECT_EQ(grid, map());
  }
}

// The graph is of the map as it was: a planner for another one does without.
TEST(PreparedPlanner, EditsLeaveThePreparationBehind) {
  Grid grid = with_blocked(40, 21, {{20, 10}});
  const Planner prepared(grid, PrepareOptions{});
  ASSERT_EQ(prepared.preparation().state, Preparation::State::ready);
  const Request request{.start = {2, 10}, .goal = {37, 10}};
  const double before = prepared.plan(request).length;

  std::vector<Planner::Edit> wall;
  for (int y = 0; y < 20; ++y) wall.push_back({{20, y}, true});
  const Planner walled = *prepared.edited(wall);
  EXPECT_EQ(walled.preparation().state, Preparation::State::none);
  for (const Planner::Edit& edit : wall) grid.set_blocked(edit.cell);
  EXPECT_EQ(walled.plan(request).path, Planner(grid).plan(request).path);
  EXPECT_GT(walled.plan(request).length, before + 1);

  const Planner excluded = *prepared.exclude(std::vector<Planner::Direction>{{{2, 10}, 1, 0}});
  EXPECT_EQ(excluded.preparation().state, Preparation::State::none);
  EXPECT_GT(excluded.plan(request).length, before);
  const Planner allowed = *excluded.allow(excluded.excluded());
  EXPECT_EQ(allowed.preparation().state, Preparation::State::none);
  EXPECT_NEAR(allowed.plan(request).length, before, 1e-9 * before);
  EXPECT_EQ(prepared.plan(request).length, before);
}

TEST(PreparedPlanner, LabelsAnswerAndMeasureAsTheUnpreparedOne) {
  const Planner plain(map()), labelled(map(), PrepareOptions{.threads = 2, .labels = true});
  ASSERT_EQ(labelled.preparation().labels.state, Preparation::State::ready);
  EXPECT_EQ(labelled.footprint().visibility_graph,
            labelled.preparation().bytes + labelled.preparation().labels.bytes);
  Workspace workspace;
  std::vector<Cell> places;
  for (const Request& request : some_queries(200)) {
    expect_as_good(labelled.plan(request, {}, {.workspace = &workspace}), plain.plan(request));
    if (map().free(request.start)) places.push_back(request.start);
  }
  const auto expected = plain.distances(places, places), found = labelled.distances(places, places);
  ASSERT_EQ(found->size(), expected->size());
  for (std::size_t i = 0; i < found->size(); ++i) {
    if (std::isinf((*expected)[i])) {
      EXPECT_EQ((*found)[i], (*expected)[i]);
    } else {
      EXPECT_NEAR((*found)[i], (*expected)[i], 1e-9 * (*expected)[i]);
    }
  }
}

class PreparationFiles : public Files {};

TEST_F(PreparationFiles, KeepWhatWasPrepared) {
  const Planner labelled(map(), PrepareOptions{.threads = 2, .labels = true});
  const std::string file = path("map.prepared");
  labelled.save_preparation(file);
  const Planner loaded = Planner(map()).load_preparation(file);
  EXPECT_EQ(loaded.preparation().edges, labelled.preparation().edges);
  EXPECT_EQ(loaded.preparation().labels.entries, labelled.preparation().labels.entries);
  for (const Request& request : some_queries(100))
    EXPECT_EQ(loaded.plan(request).path, labelled.plan(request).path);
  Grid other = map();
  other.set_blocked({1, 1}, other.free({1, 1}));
  EXPECT_THROW((void)Planner(other).load_preparation(file), Error);
  EXPECT_THROW((void)Planner(map(), Disc{1}).load_preparation(file), Error);
  EXPECT_THROW(Planner(map()).save_preparation(file), Error);
  EXPECT_THROW((void)Planner(map()).load_preparation(file + ".none"), Error);
}

// A batch makes a graph for itself, which shows in no answer.
TEST(PreparedPlanner, TheGraphOfABatchChangesNothing) {
  const Planner planner(generate(MapKind::maze, {300, 300, -1, 2}));
  std::mt19937 random(3);
  std::vector<Request> queries;
  while (queries.size() < 600)
    queries.push_back({random_cell(planner.grid(), random), random_cell(planner.grid(), random)});
  Workspace workspace;
  for (const int threads : {1, 2}) {
    plan_batch(planner, queries, {}, {.threads = threads}, [&](const BatchAnswer& answer) {
      const Result alone = planner.plan(queries[answer.index], {}, {.workspace = &workspace});
      EXPECT_EQ(answer.result.status, alone.status);
      EXPECT_EQ(answer.result.path, alone.path);
      if (!alone.path.empty()) {
        EXPECT_EQ(answer.result.length, alone.length);
      }
      EXPECT_EQ(answer.result.lower_bound, alone.lower_bound);
      EXPECT_EQ(answer.result.optimal, alone.optimal);
    });
  }
}

// So does a planner, after enough plans; unless it may not.
TEST(PreparedPlanner, TheGraphOfAPlannerChangesNothing) {
  const Grid grid = generate(MapKind::maze, {300, 300, -1, 2});
  const Planner planner(grid);
  Planner without(grid);
  without.limit_own_graph(0);
  std::mt19937 random(3);
  Workspace workspace, other;
  for (int i = 0; i < 400; ++i) {
    const Request request{random_cell(grid, random), random_cell(grid, random)};
    const Result with = planner.plan(request, {}, {.workspace = &workspace});
    const Result alone = without.plan(request, {}, {.workspace = &other});
    EXPECT_EQ(with.path, alone.path);
    EXPECT_EQ(with.lower_bound, alone.lower_bound);
    EXPECT_EQ(with.optimal, alone.optimal);
  }
  EXPECT_GT(planner.footprint().visibility_graph, 0);
  EXPECT_EQ(without.footprint().visibility_graph, 0);
  EXPECT_EQ(planner.preparation().state, Preparation::State::none);
}

TEST(PreparedPlanner, ThreadsChangeNothing) {
  const auto queries = some_queries(60);
  std::vector<std::vector<Point>> first;
  for (const int threads : {1, 2, 5}) {
    const Planner planner(map(), PrepareOptions{.threads = threads});
    std::vector<std::vector<Point>> paths;
    plan_batch(planner, queries, {}, {.threads = threads},
               [&](const BatchAnswer& answer) { paths.push_back(answer.result.path); });
    if (first.empty()) first = paths;
    EXPECT_EQ(paths, first);
  }
}

// A workspace goes from map to map.
TEST(PreparedPlanner, AWorkspaceServesSeveralMaps) {
  const Planner large(map(), PrepareOptions{});
  const Grid other = generate(MapKind::maze, {60, 60, -1, 4});
  const Planner small(other, PrepareOptions{}), plain(other);
  Workspace workspace;
  std::mt19937 random(9);
  for (const Request& q : some_queries(30)) {
    large.plan(q, {}, {.workspace = &workspace});
    const Request request{.start = {random_in(0, 59, random), random_in(0, 59, random)},
                          .goal = {random_in(0, 59, random), random_in(0, 59, random)}};
    expect_as_good(small.plan(request, {}, {.workspace = &workspace}), plain.plan(request));
  }
}

}  // namespace
}  // namespace lasius
