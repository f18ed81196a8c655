#include "core/exact/labels/label_search.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "core/exact/prepared_search.h"
#include "core/grid/grid_view.h"
#include "lasius/grid/generate.h"
#include "tests/core/exact/exact_answers.h"

namespace lasius {
namespace {

using exact::CornerLabels;

/// A map with labels, whatever they take.
struct LabelledMap {
  explicit LabelledMap(const Grid& map, int threads = 1) : grid(map) {
    PrepareOptions options{.threads = threads};
    options.max_label_entries = 1 << 20;
    Preparation report;
    graph = exact::CornerGraph::make(grid, options, report);
    labels = CornerLabels::make(grid, *graph, options, report.labels);
  }
  const Grid& grid;
  std::shared_ptr<const exact::CornerGraph> graph;
  std::shared_ptr<const CornerLabels> labels;
};

/// Both ways of asking, on one map after another.
struct Searches {
  exact::LabelSearch by_labels;
  exact::PreparedSearch by_graph;
  int found = 0;

  // The labels tell of a path where there is one, and of one as short.
  void expect_equal(const LabelledMap& map, Point start, Point goal) {
    ExactAnswer answer, expected;
    by_graph.search(map.grid, *map.graph, start, goal, {}, {}, expected);
    const bool told =
        by_labels.search(map.grid, *map.graph, *map.labels, start, goal, {}, {}, answer);
    ASSERT_EQ(told, !expected.path.empty());
    if (!told) return;
    ++found;
    EXPECT_TRUE(answer.optimal);
    EXPECT_TRUE(answer.stored_legs);
    EXPECT_NEAR(answer.length, expected.length, 1e-9 * expected.length);
    EXPECT_EQ(answer.length, path_length(answer.path));
    EXPECT_EQ(answer.path.front(), start);
    EXPECT_EQ(answer.path.back(), goal);
    const auto fault = path_fault(map.grid, answer.path);
    EXPECT_FALSE(fault.has_value()) << *fault;
  }
  void expect_equal(const LabelledMap& map, int queries, std::mt19937& random) {
    for (int i = 0; i < queries && !testing::Test::HasFailure(); ++i) {
      const auto start = random_free(map.grid, random), goal = random_free(map.grid, random);
      if (!start || !goal) continue;
      SCOPED_TRACE(testing::Message()
                   << start->x << ',' << start->y << " to " << goal->x << ',' << goal->y);
      expect_equal(map, centre(*start), centre(*goal));
    }
  }
};

TEST(LabelSearch, EqualsThePreparedSearchOnRandomGrids) {
  std::mt19937 random(20261127);
  Searches searches;
  for (int i = 0; i < scaled(600) && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("grid " + std::to_string(i));
    const Grid small = random_small_grid(i, random);
    searches.expect_equal(LabelledMap(small), 8, random);
    if (i % 15 != 0) continue;
    const Grid large = random_large_grid(i / 15, random);
    searches.expect_equal(LabelledMap(large), 60, random);
    const Grid sparse = random_sparse_grid(i % 2 == 0, random);
    searches.expect_equal(LabelledMap(sparse), 20, random);
  }
  EXPECT_GT(searches.found, 3000);
}

TEST(LabelSearch, EqualsThePreparedSearchOnGeneratedMaps) {
  std::mt19937 random(7);
  Searches searches;
  for (const MapKind kind : {MapKind::maze, MapKind::rooms, MapKind::city, MapKind::blobs}) {
    SCOPED_TRACE(std::string(to_string(kind)));
    const Grid grid = generate(kind, {240, 170, -1, 5});
    searches.expect_equal(LabelledMap(grid, 2), 800, random);
  }
  EXPECT_GT(searches.found, 2000);
}

// Ends on corners, on walls, inside cells, anywhere but at centres.
TEST(LabelSearch, TakesAnyPointsAsEnds) {
  std::mt19937 random(11);
  Searches searches;
  const Grid grid = generate(MapKind::rooms, {60, 50, -1, 3});
  const LabelledMap map(grid);
  const auto place = [&](int i) {
    Cell c = *random_free(grid, random);
    const double far = i % 4 == 3 ? 0.3125 : 0.5 * (i % 3);
    return Point{c.x + far, c.y + 0.5 * ((i / 3) % 3)};
  };
  for (int i = 0; i < 600 && !HasFailure(); ++i)
    searches.expect_equal(map, place(i),
                          i % 2 == 0 ? place(i / 2) : centre(*random_free(grid, random)));
  EXPECT_GT(searches.found, 300);
}

template <class T>
void expect_same(const std::vector<T>& a, const std::vector<T>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0);
}

TEST(CornerLabels, AreTheSameForAnyThreads) {
  const Grid grid = generate(MapKind::blobs, {200, 150, -1, 9});
  const LabelledMap one(grid, 1), three(grid, 3);
  const auto &a = one.labels->arrays(), &b = three.labels->arrays();
  EXPECT_GT(a.hubs.size(), a.corners.size());
  expect_same(a.corners, b.corners);
  expect_same(a.groups, b.groups);
  expect_same(a.hubs, b.hubs);
  expect_same(a.lengths, b.lengths);
  expect_same(a.steps, b.steps);
  expect_same(a.tiles, b.tiles);
  expect_same(a.live, b.live);
  expect_same(a.dead, b.dead);
  expect_same(a.masks, b.masks);
}

// A bit for each cell that sees a corner, and for no other.
TEST(CornerLabels, TilesKnowWhatTheirCellsSee) {
  std::mt19937 random(5);
  for (int i = 0; i < 40 && !HasFailure(); ++i) {
    const Grid grid = i % 2 == 0 ? random_small_grid(i, random) : random_large_grid(i, random);
    const LabelledMap map(grid);
    const auto& arrays = map.labels->arrays();
    const kernels::BitmapView view = view_of(grid);
    for (const Cell c : cells_of({0, 0, grid.width(), grid.height()})) {
      if (grid.blocked(c)) continue;
      const exact::Tile* const tile = arrays.tiles.data() + map.labels->tile_of(c);
      const int place = CornerLabels::place_of(c);
      std::vector<std::uint32_t> seen;
      const std::uint64_t* mask = arrays.masks.data() + tile->masks;
      const auto add = [&](const auto& list, std::uint32_t full, std::uint32_t partial,
                           std::uint32_t end, const auto& number) {
        for (std::uint32_t k = full; k < partial; ++k) seen.push_back(number(list[k]));
        for (std::uint32_t k = partial; k < end; ++k, ++mask)
          if ((*mask >> place & 1) != 0) seen.push_back(number(list[k]));
      };
      add(arrays.live, tile->live_full, tile->live_partial, tile[1].live_full,
          [](const exact::TileCorner& t) { return t.number; });
      add(arrays.dead, tile->dead_full, tile->dead_partial, tile[1].dead_full,
          [](std::uint32_t t) { return t; });
      for (const std::uint32_t v : seen) {
        const exact::GraphCorner& corner = map.graph->corner(v);
        EXPECT_TRUE(
            kernels::sees(view, {2 * c.x + 1, 2 * c.y + 1}, {2 * corner.x(), 2 * corner.y()}));
      }
    }
  }
}

TEST(CornerLabels, AreGivenUpWhereTheyWouldTakeTooMuch) {
  const Grid grid = generate(MapKind::random, {200, 200, 0.2, 1});
  PrepareOptions options{.threads = 2};
  options.max_label_entries = 4;
  Preparation report;
  const auto graph = exact::CornerGraph::make(grid, options, report);
  EXPECT_EQ(CornerLabels::make(grid, *graph, options, report.labels), nullptr);
  EXPECT_EQ(report.labels.state, Preparation::State::too_large);
  options.stop = fired();
  EXPECT_EQ(CornerLabels::make(grid, *graph, options, report.labels), nullptr);
  EXPECT_EQ(report.labels.state, Preparation::State::stopped);
}

// 8 bytes for each corner that cells of a tile see, 8 more where not all of the free ones do.
TEST(CornerLabels, AreGivenUpByTheBytesOfTheirLists) {
  const Grid grid = generate(MapKind::open, {256, 256, -1, 3});
  PrepareOptions options{.threads = 2};
  Preparation report;
  const auto graph = exact::CornerGraph::make(grid, options, report);
  const auto labels = CornerLabels::make(grid, *graph, options, report.labels);
  ASSERT_NE(labels, nullptr);
  const auto& lists = labels->arrays();
  const auto bytes =
      static_cast<std::int64_t>(8 * (lists.live.size() + lists.dead.size() + lists.masks.size()));
  ASSERT_GT(bytes, 20 * labels->entry_count());
  options.max_label_bytes = bytes;
  EXPECT_NE(CornerLabels::make(grid, *graph, options, report.labels), nullptr);
  options.max_label_bytes = bytes - 1;
  EXPECT_EQ(CornerLabels::make(grid, *graph, options, report.labels), nullptr);
  EXPECT_EQ(report.labels.state, Preparation::State::too_large);
}

}  // namespace
}  // namespace lasius
