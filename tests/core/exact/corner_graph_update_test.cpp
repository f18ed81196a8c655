#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <tuple>

#include "core/exact/corner_graph.h"
#include "core/exact/exact.h"
#include "core/exact/prepared_search.h"
#include "lasius/generate.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/exact/exact_answers.h"
#include "tests/worlds/grids.h"

namespace lasius::exact {
namespace {

// An edge by coordinates: from, side, to, onward side. In the order of the graph.
using Edge = std::array<int, 6>;

std::vector<Edge> edges_of(const CornerGraph& graph, std::uint32_t i) {
  std::vector<Edge> edges;
  const GraphCorner& c = graph.corner(i);
  for (const Side side : {kColumn, kLine}) {
    for (const GraphEdge& e : graph.edges(i, side)) {
      edges.push_back({c.x(), c.y(), int(side), e.x, e.y, int(e.side())});
    }
  }
  return edges;
}

void expect_equal(const CornerGraph& graph, const CornerGraph& fresh) {
  std::int64_t edges = 0;
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    edges += static_cast<std::int64_t>(graph.edges(i).size());
  }
  for (std::uint32_t i = 0; i < fresh.size(); ++i) {
    const GraphCorner& c = fresh.corner(i);
    const std::uint32_t there = graph.index(c.x(), c.y());
    ASSERT_LT(there, graph.size());
    const GraphCorner& d = graph.corner(there);
    ASSERT_EQ(std::tuple(d.x(), d.y(), d.block_x(), d.block_y()),
              std::tuple(c.x(), c.y(), c.block_x(), c.block_y()));
    ASSERT_EQ(edges_of(graph, there), edges_of(fresh, i)) << "at " << c.x() << ' ' << c.y();
    for (const GraphEdge& e : graph.edges(there)) {
      ASSERT_EQ(graph.index(e.x, e.y), e.to());
    }
  }
  EXPECT_EQ(edges, fresh.edge_count()) << "edges of corners that are none";
  EXPECT_EQ(graph.edge_count(), fresh.edge_count());
}

// What makes the bounds of landmarks true.
void expect_no_edge_shorter_than_landmarks_say(const CornerGraph& graph, int& known) {
  const Landmarks& landmarks = graph.landmarks();
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    for (const GraphEdge& e : graph.edges(v)) {
      const double length = std::hypot(e.x - graph.corner(v).x(), e.y - graph.corner(v).y());
      for (std::size_t i = 0; i < landmarks.cells().size(); ++i) {
        if (!landmarks.bounds(i)) continue;
        const double here = landmarks.distances(v)[i], there = landmarks.distances(e.to())[i];
        ASSERT_EQ(std::isnan(here), std::isnan(there));
        if (std::isnan(here)) continue;
        ASSERT_LE(std::abs(here - there), length)
            << i << " at " << graph.corner(v).x() << ' ' << graph.corner(v).y() << " to " << e.x
            << ' ' << e.y;
        ++known;
      }
    }
  }
}

// Blocks, frees or deals anew the cells of a small rectangle, often at the border.
Rectangle edit(Grid& grid, int most, std::mt19937& random) {
  const int width = std::min(random_in(1, most, random), grid.width());
  const int height = std::min(random_in(1, most, random), grid.height());
  Rectangle part{random_in(0, grid.width() - width, random),
                 random_in(0, grid.height() - height, random), width, height};
  if (random() % 8 == 0) part.x = random() % 2 == 0 ? 0 : grid.width() - width;
  if (random() % 8 == 0) part.y = random() % 2 == 0 ? 0 : grid.height() - height;
  const auto kind = random() % 4;
  for (const Cell c : cells_of(part)) {
    if (kind == 0) grid.set_blocked(c);
    if (kind == 1) grid.set_blocked(c, false);
    if (kind == 2) grid.set_blocked(c, random() % 2 == 0);
    if (kind == 3 && random() % 4 == 0) grid.set_blocked(c, grid.free(c));
  }
  return part;
}

struct Kind {
  std::string name;
  int maps, edits, most;  // `most` cells a side of an edit
  Grid (*make)(std::mt19937&);
};

Grid generated(MapKind kind, std::mt19937& random) {
  return generate(kind, {random_in(40, 90, random), random_in(40, 90, random), -1, random()});
}

const Kind kKinds[] = {
    {"tiny", 150, 12, 3,
     [](std::mt19937& r) {
       return random_grid(random_in(1, 14, r), random_in(1, 14, r), random_in(5, 60, r), r);
     }},
    {"sparse", 12, 40, 4,
     [](std::mt19937& r) {
       return random_grid(random_in(20, 70, r), random_in(20, 70, r), random_in(0, 4, r), r);
     }},
    {"noise", 8, 40, 5,
     [](std::mt19937& r) {
       return random_grid(random_in(20, 70, r), random_in(20, 70, r), random_in(10, 45, r), r);
     }},
    {"blobs", 8, 50, 6, [](std::mt19937& r) { return generated(MapKind::blobs, r); }},
    {"rooms", 12, 50, 6, [](std::mt19937& r) { return generated(MapKind::rooms, r); }},
    {"maze", 8, 50, 3, [](std::mt19937& r) { return generated(MapKind::maze, r); }},
    {"large", 8, 12, 30, [](std::mt19937& r) { return generated(MapKind::blobs, r); }},
};

class CornerGraphUpdate : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, CornerGraphUpdate, testing::ValuesIn(kKinds),
                         [](const auto& kind) { return kind.param.name; });

TEST_P(CornerGraphUpdate, HasTheEdgesOfAFreshGraph) {
  std::mt19937 random(31);
  int known = 0;
  for (int m = 0; m < GetParam().maps && !HasFailure(); ++m) {
    Grid grid = GetParam().make(random);
    const auto graph = graph_of(grid);
    for (int i = 0; i < GetParam().edits && !HasFailure(); ++i) {
      SCOPED_TRACE("map " + std::to_string(m) + ", edit " + std::to_string(i));
      const Rectangle part = edit(grid, GetParam().most, random);
      ASSERT_TRUE(graph->update(grid, part));
      const auto fresh = graph_of(grid);
      expect_equal(*graph, *fresh);
      expect_no_edge_shorter_than_landmarks_say(*graph, known);
      if (i == 0) expect_no_edge_shorter_than_landmarks_say(*fresh, known);
    }
  }
  EXPECT_GT(known, 1000);
}

TEST_P(CornerGraphUpdate, AnswersAsTheUnpreparedSearch) {
  std::mt19937 random(32);
  PreparedSearch search;
  ExactSearch unprepared;
  int reachable = 0;
  for (int m = 0; m < (GetParam().maps + 3) / 4 && !HasFailure(); ++m) {
    Grid grid = GetParam().make(random);
    const auto graph = graph_of(grid);
    for (int i = 0; i < 4 * GetParam().edits && !HasFailure(); ++i) {
      ASSERT_TRUE(graph->update(grid, edit(grid, GetParam().most, random)));
      const Cell start = random_cell(grid, random), goal = random_cell(grid, random);
      if (grid.blocked(start) || grid.blocked(goal)) continue;
      ExactAnswer answer;
      search.search(grid, *graph, start, goal, {}, {}, answer);
      reachable += expect_unprepared(grid, start, goal, unprepared, answer);
    }
  }
  EXPECT_GT(reachable, 20);
}

// A wall across the map, and a door in it that opens and shuts.
TEST(CornerGraphUpdate, LandmarksReachWhatAnEditJoins) {
  Grid grid(60, 40);
  grid.fill({30, 0, 1, 40}, true);
  grid.fill({10, 10, 3, 3}, true);
  grid.fill({40, 10, 2, 2}, true);
  const auto graph = graph_of(grid);
  for (const bool shut : {false, true, false}) {
    grid.fill({30, 5, 1, 4}, shut);
    ASSERT_TRUE(graph->update(grid, {30, 5, 1, 4}));
    expect_equal(*graph, *graph_of(grid));
    int known = 0;
    expect_no_edge_shorter_than_landmarks_say(*graph, known);
    EXPECT_GT(known, 0);
    EXPECT_TRUE(graph->landmarks().bounds(0));
    const float behind = graph->landmarks().distances(graph->index(40, 10))[0];
    EXPECT_TRUE(shut || !std::isnan(behind));
  }
}

TEST(CornerGraphUpdate, NumbersOfOtherCornersStay) {
  Grid grid(30, 30);
  grid.fill({10, 10, 4, 4}, true);
  grid.fill({20, 3, 2, 2}, true);
  const auto graph = graph_of(grid);
  const std::uint32_t kept = graph->index(14, 14), size = graph->size();
  for (int i = 0; i < 20; ++i) {
    grid.fill({12, 8, 1, 2}, i % 2 == 0);
    ASSERT_TRUE(graph->update(grid, {12, 8, 1, 2}));
    EXPECT_EQ(graph->index(14, 14), kept);
  }
  EXPECT_LE(graph->size(), size + 4);  // numbers are used again
}

TEST(CornerGraphUpdate, TellsWhenItIsStopped) {
  std::mt19937 random(33);
  Grid grid = random_grid(300, 300, 2, random);
  const auto graph = graph_of(grid);
  grid.fill({150, 150, 20, 20}, true);
  const CountingTime time(0);
  EXPECT_FALSE(graph->update(grid, {150, 150, 20, 20}, time.is_up()));
}

}  // namespace
}  // namespace lasius::exact
