// Answers by what was prepared of an older map, against the ordinary search on the map as it is.
#include "core/plan/stale_answers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "lasius/drive/navigator.h"
#include "lasius/grid/generate.h"
#include "lasius/plan/planner.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

/// Some cells of a square of 5 x 5 blocked or freed.
std::vector<Planner::Edit> some_edit(const Grid& grid, std::mt19937& random) {
  const int x = random_in(0, grid.width() - 5, random);
  const int y = random_in(0, grid.height() - 5, random);
  const bool blocked = random() % 2 == 0;
  std::vector<Planner::Edit> edits;
  for (int i = 0; i < 10; ++i) {
    const int dx = random_in(0, 4, random);
    const int dy = random_in(0, 4, random);
    edits.push_back({{x + dx, y + dy}, blocked});
  }
  return edits;
}

Grid some_map(int number, std::mt19937& random) {
  constexpr MapKind kKinds[] = {MapKind::blobs, MapKind::rooms, MapKind::maze, MapKind::city};
  const auto seed = static_cast<std::uint64_t>(number);
  if (number % 5 == 4) return random_grid(70, 60, random_in(5, 35, random), random);
  return generate(kKinds[number % 5], {90, 70, -1, seed});
}

void expect_equal(const Result& found, const Result& plain) {
  EXPECT_EQ(found.status, plain.status);
  EXPECT_EQ(found.optimal, plain.optimal);
  ASSERT_EQ(found.path.empty(), plain.path.empty());
  if (!plain.path.empty()) {
    EXPECT_NEAR(found.length, plain.length, 1e-9 * plain.length);
  }
}

TEST(StaleAnswers, AreThoseOfTheOrdinarySearchAfterEdits) {
  std::mt19937 random(21);
  for (int number = 0; number < 28; ++number) {
    SCOPED_TRACE(number);
    const Grid grid = some_map(number, random);
    const bool labels = number % 3 != 0;
    Planner edited = Planner(grid, PrepareOptions{.threads = 1, .labels = labels});
    int done = 0;
    for (const int edits : {1, 10, 100}) {
      std::vector<Planner::Edit> more;
      for (; done < edits; ++done)
        for (const Planner::Edit& edit : some_edit(grid, random)) more.push_back(edit);
      edited = *edited.edited(more);
      EXPECT_EQ(edited.preparation().state, Preparation::State::none);
      const Planner plain(edited.grid());
      const Planner again = edits == 10 && number % 2 == 0  // in the kept order
                                ? edited.prepared({.threads = 1 + number % 3, .labels = labels})
                                : edited;
      Workspace workspace;
      for (int i = 0; i < 25; ++i) {
        const Request request{random_cell(grid, random), random_cell(grid, random)};
        const Result right = plain.plan(request, {}, {.workspace = &workspace});
        expect_equal(edited.plan(request, {}, {.workspace = &workspace}), right);
        expect_equal(again.plan(request, {}, {.workspace = &workspace}), right);
      }
    }
  }
}

TEST(StaleAnswers, TellWhereNothingNearTheWayChanged) {
  const Grid grid = generate(MapKind::blobs, {120, 90, -1, 5});
  std::mt19937 random(22);
  exact::LabelSearch labels;
  exact::PreparedSearch search;
  Preparation report;
  const PrepareOptions options{.threads = 1};
  std::shared_ptr<const exact::CornerGraph> graph = exact::CornerGraph::make(grid, options, report);
  const auto kept = exact::CornerLabels::make(grid, *graph, options, report.labels);
  const auto older = std::make_shared<const PreparedMap>(PreparedMap{grid, graph, kept});
  const auto only_graph = std::make_shared<const PreparedMap>(PreparedMap{grid, graph});
  Grid now = grid;
  std::vector<Cell> changed;
  for (int i = 0; i < 6; ++i)
    for (const auto& [cell, blocked] : some_edit(grid, random)) {
      now.set_blocked(cell, blocked);
      changed.push_back(cell);
    }
  const StaleAnswers stale(older, now, changed), by_graph(only_graph, now, changed);
  const Planner plain(now), before(grid);
  int told = 0, by_graph_alone = 0, unchanged = 0;
  for (int i = 0; i < 300; ++i) {
    const Cell from = random_cell(grid, random), to = random_cell(grid, random);
    const Result right = plain.plan({from, to}), old = before.plan({from, to});
    if (right.path.size() < 2 || old.path.empty()) continue;
    unchanged += std::abs(right.length - old.length) < 1e-9 ? 1 : 0;
    ExactAnswer answer;
    if (stale.search({labels, search}, now, centre(from), centre(to), {}, {}, answer)) {
      ++told;
      EXPECT_TRUE(answer.optimal);
      EXPECT_NEAR(answer.length, right.length, 1e-9 * right.length);
    }
    if (by_graph.search({labels, search}, now, centre(from), centre(to), {}, {}, answer)) {
      ++by_graph_alone;
      EXPECT_NEAR(answer.length, right.length, 1e-9 * right.length);
    }
  }
  EXPECT_GT(unchanged, 80);
  EXPECT_GE(told, by_graph_alone);
  EXPECT_GT(told, 0.8 * unchanged) << by_graph_alone;
}

TEST(StaleAnswers, AWallThatGoesIsNotMissed) {
  // A wall with a door at one end: the way through its middle is shorter once a cell is free there.
  const Grid grid = grid_of(41, 21, [](int x, int y) { return x == 20 && y > 0; });
  const Planner prepared(grid, PrepareOptions{.threads = 1, .labels = true});
  const Request request{{10, 10}, {30, 10}};
  EXPECT_GT(prepared.plan(request).length, 25);
  const Planner open = *prepared.edited(std::vector<Planner::Edit>{{{20, 10}, false}});
  EXPECT_DOUBLE_EQ(open.plan(request).length, 20);
  const Planner shut = *open.edited(std::vector<Planner::Edit>{{{20, 10}, true}});
  EXPECT_EQ(shut.plan(request).path, prepared.plan(request).path);
  // Two cells that are doors together only: each is a dead end for itself.
  const Grid thick = grid_of(41, 21, [](int x, int y) { return (x == 20 || x == 21) && y > 0; });
  const Planner both =
      *Planner(thick, PrepareOptions{.threads = 1, .labels = true})
           .edited(std::vector<Planner::Edit>{{{20, 10}, false}, {{21, 10}, false}});
  EXPECT_DOUBLE_EQ(both.plan(request).length, 20);
}

TEST(StaleAnswers, EndWhereTooManyCellsAreFree) {
  const Grid grid = grid_of(80, 80, [](int x, int y) { return x >= 20 && x < 60 && y >= 20; });
  std::vector<Planner::Edit> edits;
  for (const Cell c : cells_of({20, 20, 40, 40})) edits.push_back({c, false});
  const Planner open = *Planner(grid, PrepareOptions{.threads = 1, .labels = true}).edited(edits);
  const Request request{{5, 70}, {75, 70}};
  EXPECT_EQ(open.plan(request).path, Planner(open.grid()).plan(request).path);
  EXPECT_EQ(open.footprint().visibility_graph, 0);
}

TEST(StaleAnswers, TheKeptOrderIsTheSameForAnyNumberOfThreads) {
  const Grid grid = generate(MapKind::rooms, {120, 90, -1, 6});
  std::mt19937 random(23);
  const Planner edited =
      *Planner(grid, PrepareOptions{.threads = 1, .labels = true}).edited(some_edit(grid, random));
  const Planner one = edited.prepared({.threads = 1, .labels = true});
  ASSERT_EQ(one.preparation().labels.state, Preparation::State::ready);
  for (const int threads : {2, 5}) {
    const Planner other = edited.prepared({.threads = threads, .labels = true});
    EXPECT_EQ(other.preparation().labels.entries, one.preparation().labels.entries);
    for (int i = 0; i < 30; ++i) {
      const Request request{random_cell(grid, random), random_cell(grid, random)};
      EXPECT_EQ(other.plan(request).path, one.plan(request).path);
    }
  }
}

}  // namespace
}  // namespace lasius
