#include "core/exact/corner_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/stored_arrays.h"
#include "core/exact/exact_answer.h"
#include "core/exact/place_landmarks.h"
#include "core/grid/grid_view.h"
#include "kernels/sight/sight.h"
#include "lasius/grid/generate.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/exact/exact_answers.h"
#include "tests/oracle/dense_dijkstra.h"
#include "tests/worlds/grids.h"

namespace lasius::exact {
namespace {

using Graph = std::shared_ptr<const CornerGraph>;

kernels::HalfPoint place(const CornerGraph& graph, std::uint32_t i) {
  return {2 * graph.corner(i).x(), 2 * graph.corner(i).y()};
}

double between(kernels::HalfPoint a, kernels::HalfPoint b) { return distance(a.x, a.y, b.x, b.y); }

int blocked_around(const Grid& grid, int x, int y) {
  return grid.blocked({x - 1, y - 1}) + grid.blocked({x, y - 1}) + grid.blocked({x - 1, y}) +
         grid.blocked({x, y});
}

TEST(CornerGraph, NumbersEachCornerOnce) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const Grid grid = random_grid(random_in(1, 140, random), random_in(1, 40, random), 30, random);
    const Graph graph = graph_of(grid);
    std::uint32_t count = 0;
    for (int y = 0; y <= grid.height(); ++y) {
      for (int x = 0; x <= grid.width(); ++x) {
        if (blocked_around(grid, x, y) != 1) continue;
        ++count;
        const std::uint32_t index = graph->index(x, y);
        ASSERT_LT(index, graph->size());
        const GraphCorner& corner = graph->corner(index);
        EXPECT_EQ(corner.x(), x);
        EXPECT_EQ(corner.y(), y);
        const Cell block{corner.block_x() > 0 ? x : x - 1, corner.block_y() > 0 ? y : y - 1};
        EXPECT_TRUE(grid.blocked(block));
      }
    }
    EXPECT_EQ(graph->size(), count);
  }
}

// Turns from the block's edge on, in the quadrant of its side, in sight, to a corner that a path
// may bend around: into the side across from where it came.
void expect_edges(const Grid& grid, const CornerGraph& graph, std::uint32_t i, Side side) {
  const GraphCorner& c = graph.corner(i);
  const int right = side == kColumn ? -c.block_x() : c.block_x();
  const int down = side == kColumn ? c.block_y() : -c.block_y();
  std::int64_t last_x = side == kColumn ? 0 : 1, last_y = side == kColumn ? 1 : 0;
  for (const GraphEdge& edge : graph.edges(i, side)) {
    const GraphCorner& to = graph.corner(edge.to());
    ASSERT_EQ(to.x(), edge.x);
    ASSERT_EQ(to.y(), edge.y);
    const std::int64_t x = right * (to.x() - c.x()), y = down * (to.y() - c.y());
    EXPECT_GE(x, 0);
    EXPECT_GE(y, 0);
    const std::int64_t turn = last_x * y - last_y * x;
    EXPECT_TRUE(side == kColumn ? turn <= 0 : turn >= 0);
    last_x = x;
    last_y = y;
    EXPECT_TRUE(kernels::sees(view_of(grid), place(graph, i), place(graph, edge.to())));
    EXPECT_EQ(edge.side(), to.side_from(2 * c.x(), 2 * c.y()));
  }
}

TEST(CornerGraph, EdgesAreInSightAndInTheOrderOfTheTurn) {
  std::mt19937 random(2);
  for (int k = 0; k < 20; ++k) {
    const Grid grid = random_grid(60, 50, random_in(2, 45, random), random);
    const Graph graph = graph_of(grid);
    std::int64_t edges = 0;
    for (std::uint32_t i = 0; i < graph->size(); ++i) {
      for (const Side side : {kColumn, kLine}) {
        expect_edges(grid, *graph, i, side);
        edges += static_cast<std::int64_t>(graph->edges(i, side).size());
      }
    }
    EXPECT_EQ(edges, graph->edge_count());
  }
}

TEST(CornerGraph, SeesAroundOneBlock) {
  const Grid grid = with_blocked(9, 9, {{4, 4}});
  const Graph graph = graph_of(grid);
  ASSERT_EQ(graph->size(), 4u);
  EXPECT_EQ(graph->edge_count(), 8);  // along each edge, both ways
  const std::uint32_t corner = graph->index(4, 4);
  const auto down = graph->edges(corner, kColumn), right = graph->edges(corner, kLine);
  ASSERT_EQ(down.size(), 1u);
  EXPECT_EQ(down[0].to(), graph->index(4, 5));
  ASSERT_EQ(right.size(), 1u);
  EXPECT_EQ(right[0].to(), graph->index(5, 4));
}

TEST(CornerGraph, AFileThatNamesOtherCornersIsRefused) {
  const Grid grid = with_blocked(9, 9, {{4, 4}});
  ArrayWriter to;
  graph_of(grid)->save(to);
  std::string text = to.text();
  const auto load = [&] {
    ArrayReader from(text, "file", 0);
    return CornerGraph::load(grid, from);
  };
  EXPECT_EQ(load()->size(), 4u);
  // Of the first tile's rows, which follow their number, the one of (4, 4) and (5, 4).
  text[8 + 4] = static_cast<char>(text[8 + 4] << 1);
  EXPECT_THROW(load(), Error);
}

TEST(CornerGraph, AFileMayNameTheOutermostCorners) {
  const Grid grid = with_blocked(9, 9, {{0, 0}, {8, 8}});
  ArrayWriter to;
  graph_of(grid)->save(to);
  ArrayReader from(to.text(), "file", 0);
  const auto loaded = CornerGraph::load(grid, from);
  ASSERT_EQ(loaded->size(), 2u);
  EXPECT_EQ(loaded->index(1, 1), 0u);
  EXPECT_EQ(loaded->index(8, 8), 1u);
}

// Distances from one landmark to all corners, by brute force.
std::vector<double> distances(const Grid& grid, const CornerGraph& graph, Cell landmark) {
  const auto map = view_of(grid);
  const kernels::HalfPoint from{2 * landmark.x + 1, 2 * landmark.y + 1};
  std::vector<kernels::HalfPoint> places;
  std::vector<double> known;
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    const auto& at = places.emplace_back(place(graph, v));
    known.push_back(kernels::sees(map, from, at) ? between(from, at) : oracle::kUnreached);
  }
  return oracle::shortest_distances(
      std::move(known), [&](std::size_t a, std::size_t b) { return between(places[a], places[b]); },
      [&](std::size_t a, std::size_t b) { return kernels::sees(map, places[a], places[b]); });
}

TEST(CornerGraph, LandmarksKnowTheirDistanceFromEveryCorner) {
  std::mt19937 random(5);
  int known = 0, unknown = 0;
  for (int k = 0; k < 150; ++k) {
    const Grid grid = random_grid(random_in(4, 14, random), random_in(4, 14, random),
                                  random_in(10, 50, random), random);
    const Graph graph = graph_of(grid);
    const Landmarks& landmarks = graph->landmarks();
    for (std::size_t i = 0; i < landmarks.cells().size(); ++i) {
      const auto expected = distances(grid, *graph, landmarks.cells()[i]);
      for (std::uint32_t v = 0; v < graph->size(); ++v) {
        const float distance = landmarks.distances(v)[i];
        if (std::isfinite(expected[v])) {
          EXPECT_NEAR(distance, expected[v], 1e-4);  // some grains
          ++known;
        } else {
          EXPECT_TRUE(std::isnan(distance));
          ++unknown;
        }
      }
    }
  }
  EXPECT_GT(known, 1000);
  EXPECT_GT(unknown, 100);
}

TEST(CornerGraph, LandmarksBoundWhatIsLeftToGo) {
  std::mt19937 random(6);
  const Grid grid = random_grid(40, 40, 35, random);
  const Graph graph = graph_of(grid);
  const Landmarks& landmarks = graph->landmarks();
  ASSERT_FALSE(landmarks.empty());
  int tight = 0;
  for (const Cell goal_cell : landmarks.cells()) {
    const auto left = distances(grid, *graph, goal_cell);
    Landmarks::Goal goal;
    const kernels::HalfPoint g{2 * goal_cell.x + 1, 2 * goal_cell.y + 1};
    for (std::size_t i = 0; i < landmarks.cells().size(); ++i) {
      double least = std::numeric_limits<double>::infinity(), largest = -least;
      for (std::uint32_t v = 0; v < graph->size(); ++v) {
        const double known = landmarks.distances(v)[i], way = between(place(*graph, v), g);
        if (std::isnan(known) || !kernels::sees(view_of(grid), place(*graph, v), g)) continue;
        least = std::min(least, known + way);
        largest = std::max(largest, known - way);
      }
      if (std::isfinite(least)) goal.set(i, least, largest);
    }
    for (std::uint32_t v = 0; v < graph->size(); ++v) {
      if (!std::isfinite(left[v])) continue;
      EXPECT_LE(landmarks.bound(v, goal), left[v] + 1e-4);  // at both ends no path need bend
      tight += landmarks.bound(v, goal) > 0.9 * left[v];
    }
  }
  EXPECT_GT(tight, 100);
}

TEST(CornerGraph, IsTheSameForAnyThreads) {
  const Grid grid = generate(MapKind::blobs, {300, 260, -1, 5});
  const Graph one = graph_of(grid, {.threads = 1});
  for (const int threads : {2, 5}) {
    const Graph many = graph_of(grid, {.threads = threads});
    ASSERT_EQ(many->size(), one->size());
    EXPECT_EQ(many->edge_count(), one->edge_count());
    EXPECT_EQ(many->bytes(), one->bytes());
    EXPECT_EQ(many->landmarks().cells(), one->landmarks().cells());
    for (std::uint32_t i = 0; i < one->size(); ++i) {
      for (const Side side : {kColumn, kLine}) {
        const auto a = one->edges(i, side), b = many->edges(i, side);
        ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end(),
                               [](const GraphEdge& e, const GraphEdge& f) {
                                 return e.to_and_side == f.to_and_side && e.x == f.x && e.y == f.y;
                               }));
      }
      using Bits = std::array<std::uint32_t, Landmarks::kCount>;  // not numbers are equal, too
      EXPECT_EQ(std::bit_cast<Bits>(one->landmarks().distances(i)),
                std::bit_cast<Bits>(many->landmarks().distances(i)));
    }
  }
}

TEST(CornerGraph, IsGivenUpWhereItWouldTakeTooMuch) {
  std::mt19937 random(7);
  const Grid grid = random_grid(120, 120, 20, random);
  Preparation whole;
  const Graph graph = CornerGraph::make(grid, {.threads = 2}, whole);
  ASSERT_NE(graph, nullptr);
  EXPECT_EQ(whole.state, Preparation::State::ready);
  EXPECT_EQ(whole.bytes, graph->bytes());
  EXPECT_EQ(whole.edges, graph->edge_count());
  EXPECT_EQ(whole.vertices, graph->size());
  for (const int threads : {1, 2, 5}) {
    Preparation report;
    EXPECT_NE(CornerGraph::make(grid, {.threads = threads, .max_bytes = whole.bytes}, report),
              nullptr);
    for (const std::int64_t limit : {whole.bytes - 1, whole.bytes / 2, std::int64_t{0}}) {
      EXPECT_EQ(CornerGraph::make(grid, {.threads = threads, .max_bytes = limit}, report), nullptr);
      EXPECT_EQ(report.state, Preparation::State::too_large);
      EXPECT_EQ(report.vertices, whole.vertices);
      EXPECT_EQ(report.edges, 0);
      EXPECT_EQ(report.bytes, 0);
    }
  }
}

// Told by a sixth of the corners.
TEST(CornerGraph, ExpectsAboutWhatItHolds) {
  std::mt19937 random(7);
  const Grid grid = random_grid(36, 36, 10, random);
  const Graph graph = graph_of(grid);
  const auto held = static_cast<double>(graph->bytes());
  EXPECT_NEAR(static_cast<double>(CornerGraph::expected_bytes(grid, {})), held, 0.2 * held);
}

int polls_of_making(const Grid& grid) {
  const CountingTime counted(1 << 30);
  EXPECT_NE(graph_of(grid, {.threads = 1, .stop = counted.is_up()}), nullptr);
  return counted.polls();
}

TEST(CornerGraph, PollsWhileItLooksForCornersWhereThereAreNone) {
  // Counted, marked, and tile by tile listed: 2048 x 2048 / 64 words each.
  EXPECT_GE(polls_of_making(Grid(2048, 2048)), 3);
  EXPECT_GE(polls_of_making(Grid(4096, 4096)), 3 * 4);
}

TEST(CornerGraph, PollsAfterEachFloodHoweverLittleItReached) {
  // Closed rooms of 4 x 4 cells around a block: 4 corners each, all that a flood from there
  // reaches.
  const auto polls_of_rooms = [](int rooms) {
    const Grid grid = grid_of(6 * rooms, 6 * rooms, [](int x, int y) {
      return x % 6 == 5 || y % 6 == 5 || (x % 6 == 2 && y % 6 == 2);
    });
    const Graph graph = graph_of(grid);
    EXPECT_EQ(graph->size(), static_cast<std::uint32_t>(4 * rooms * rooms));
    const CountingTime counted(1 << 30);
    EXPECT_FALSE(place_landmarks(grid, *graph, 1, counted.is_up()).empty());
    return counted.polls();
  };
  // Twelve floods and more, each followed by a loop over 40000 corners.
  EXPECT_GE(polls_of_rooms(100), 12 * 40000 / 65536);
}

TEST(CornerGraph, StoppedWhileItCountsTellsOfNoCorners) {
  const Grid grid = with_blocked(2048, 2048, {{100, 100}});
  const CountingTime time(0);
  Preparation report;
  EXPECT_EQ(CornerGraph::make(grid, {.threads = 1, .stop = time.is_up()}, report), nullptr);
  EXPECT_EQ(report.state, Preparation::State::stopped);
  EXPECT_EQ(report.vertices, 0);
}

TEST(CornerGraph, IsGivenUpWhenStopped) {
  std::mt19937 random(8);
  const Grid grid = random_grid(160, 160, 20, random);
  const CountingTime counted(1 << 30);
  const Graph whole = graph_of(grid, {.threads = 1, .stop = counted.is_up()});
  ASSERT_NE(whole, nullptr);
  ASSERT_GT(counted.polls(), 10);
  for (int polls = 0; polls < counted.polls(); polls += std::max(1, counted.polls() / 8)) {
    const CountingTime time(polls);
    Preparation report;
    EXPECT_EQ(CornerGraph::make(grid, {.threads = 1, .stop = time.is_up()}, report), nullptr);
    EXPECT_EQ(report.state, Preparation::State::stopped);
    EXPECT_EQ(report.vertices, whole->size());
    EXPECT_EQ(report.bytes, 0);
  }
}

}  // namespace
}  // namespace lasius::exact
