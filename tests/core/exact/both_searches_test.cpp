// What the ordinary search and the one over a prepared map have in common.
#include <gtest/gtest.h>

#include "core/exact/exact.h"
#include "core/exact/prepared_search.h"
#include "lasius/grid/generate.h"
#include "tests/core/exact/exact_answers.h"
#include "tests/measures/count_allocations.h"
#include "tests/worlds/shared_maps.h"

namespace lasius {
namespace {

struct Unprepared {
  static constexpr int kGrids = 200;
  explicit Unprepared(const Grid&) {}
  void search(ExactSearch& search, const Grid& grid, Cell start, Cell goal,
              const ExactOptions& options, ExactAnswer& answer) const {
    search.search(grid, centre(start), centre(goal), options, {}, answer);
  }
  using Search = ExactSearch;
};

struct Prepared {
  static constexpr int kGrids = 40;
  explicit Prepared(const Grid& grid) : graph(graph_of(grid)) {}
  void search(exact::PreparedSearch& search, const Grid& grid, Cell start, Cell goal,
              const ExactOptions& options, ExactAnswer& answer) const {
    search.search(grid, *graph, centre(start), centre(goal), options, {}, answer);
  }
  using Search = exact::PreparedSearch;
  std::shared_ptr<const exact::CornerGraph> graph;
};

template <class Map>
class BothSearches : public testing::Test {
 protected:
  /// Asked of a search that may have answered others before.
  ExactAnswer solve(const Map& map, const Grid& grid, Cell start, Cell goal,
                    const ExactOptions& options = {}) {
    ExactAnswer answer;
    map.search(search_, grid, start, goal, options, answer);
    return answer;
  }
  typename Map::Search search_;
};
using Kinds = testing::Types<Unprepared, Prepared>;
TYPED_TEST_SUITE(BothSearches, Kinds);

TYPED_TEST(BothSearches, EqualBruteForceOnTheWidestMaps) {
  for (const bool tall : {false, true}) {
    const auto [grid, start, goal] = widest_puzzle(tall);
    const TypeParam map(grid);
    expect_optimum(grid, start, goal, this->solve(map, grid, start, goal));
    expect_path(grid, start, goal, this->solve(map, grid, start, goal, {0.05}));
  }
}

TYPED_TEST(BothSearches, EqualTheKnownOptimaOfRealMaps) {
  const auto tables = bench_test::shared_tables();
  if (tables.empty()) GTEST_SKIP() << "no maps in " << bench_test::shared_dir();
  for (const auto& table : tables) {
    const auto shared = bench_test::load_shared(table);
    SCOPED_TRACE(shared.name);
    const TypeParam map(shared.grid);
    for (const auto& q : shared.queries) {
      const ExactAnswer answer = this->solve(map, shared.grid, q.start, q.goal);
      EXPECT_TRUE(answer.optimal);
      EXPECT_NEAR(answer.length, q.euclid, 1e-6);
      expect_path(shared.grid, q.start, q.goal, answer);
    }
  }
}

TYPED_TEST(BothSearches, TheTargetGapIsCertified) {
  std::mt19937 random(5);
  int early = 0;
  const auto look = [&](const Grid& grid, int questions) {
    const TypeParam map(grid);
    for (int i = 0; i < questions; ++i) {
      const Cell start = *random_free(grid, random), goal = *random_free(grid, random);
      early += expect_gaps(grid, start, goal, [&](const ExactOptions& options) {
        return this->solve(map, grid, start, goal, options);
      });
    }
  };
  for (int i = 0; i < TypeParam::kGrids; ++i)
    look(random_grid(60, 60, random_in(5, 42, random), random), 1);
  for (const MapKind kind : {MapKind::blobs, MapKind::maze, MapKind::rooms, MapKind::city})
    look(generate(kind, {200, 150, -1, 3}), 20);
  EXPECT_GT(early, 60);
}

TYPED_TEST(BothSearches, EqualRunsGiveEqualAnswersWhateverCameBefore) {
  std::mt19937 random(6);
  int found = 0;
  for (int i = 0; i < 20; ++i) {
    const Grid grid = random_grid(random_in(20, 90, random), 50, 20, random);
    const TypeParam map(grid);
    const Cell start = *random_free(grid, random), goal = *random_free(grid, random);
    const ExactAnswer again = this->solve(map, grid, start, goal);
    typename TypeParam::Search fresh;
    ExactAnswer answer;
    map.search(fresh, grid, start, goal, {}, answer);
    EXPECT_EQ(answer.path, again.path);
    EXPECT_EQ(answer.end, again.end);
    found += answer.path.empty() ? 0 : 1;
  }
  EXPECT_GT(found, 10);
}

TYPED_TEST(BothSearches, ASecondSearchDoesNotAllocate) {
  std::mt19937 random(7);
  const Grid grid = random_grid(120, 120, 25, random);
  const TypeParam map(grid);
  ExactAnswer answer;
  const Cell start = *random_free(grid, random);
  std::vector<Cell> goals;
  for (int i = 0; i < 20; ++i) goals.push_back(*random_free(grid, random));
  EXPECT_EQ(allocations_of_the_second([&] {
              for (const Cell goal : goals)
                map.search(this->search_, grid, start, goal, {}, answer);
            }),
            0);
}

}  // namespace
}  // namespace lasius
