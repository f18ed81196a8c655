// A colony whose map changes under it: what it offers is walkable, and depends on the calls alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "core/colony/colony.h"
#include "core/colony/terminal_index.h"
#include "core/grid/move_rule.h"
#include "lasius/path/path.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

class EveryColony : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(SurvivingColony, EveryColony, testing::ValuesIn(colonies()), by_algorithm);

Params few_ants(std::string_view algorithm) {
  Params params = quick(algorithm);
  params.ants = std::min(params.ants, 6);
  return params;
}

void expect_same_run(const Result& a, const Result& b) {
  EXPECT_EQ(a.path, b.path);
  EXPECT_EQ(a.curves.best, b.curves.best);
  EXPECT_EQ(a.curves.steps, b.curves.steps);
  EXPECT_EQ(a.curves.arrived, b.curves.arrived);
}

TEST_P(EveryColony, TheFirstRunIsThatOfRunColonyWholeOrInTwo) {
  FarApart far;
  Params params = quick(GetParam());
  params.agreement = 0;
  ColonyMemory memory;
  const Result once = run_colony(far.planner.grid(), far.request, params, memory, {}, {});
  SurvivingColony colony(far.planner.grid(), far.request.goal, params);
  expect_same_run(colony.run(far.request.start, params.iterations), once);
  colony.changed({10, 10, 5, 5});
  (void)colony.run(far.request.start, 2);
  colony.forget();
  Result first = colony.run(far.request.start, 7);
  const Result second = colony.run(far.request.start, params.iterations - 7);
  first.path = second.path;
  const auto append = [](auto& to, const auto& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  append(first.curves.best, second.curves.best);
  append(first.curves.steps, second.curves.steps);
  append(first.curves.arrived, second.curves.arrived);
  expect_same_run(first, once);
}

/// A map that changes at random, with a start and a goal that stay joined.
class ChangingMap {
 public:
  explicit ChangingMap(unsigned seed) : random_(seed), grid_(blobs(40, 36, seed)) {
    grid_.fill({goal_.x - 2, goal_.y - 2, 5, 5}, false);
    move_start();
  }
  const Grid& grid() const { return grid_; }
  Cell start() const { return start_; }
  static constexpr Cell goal() { return goal_; }

  void move_start() {
    const Planner planner(grid_);
    do {
      start_ = {below(grid_.width()), below(grid_.height())};
    } while (start_ == goal_ || grid_.blocked(start_) || !planner.connected(start_, goal_));
  }
  /// Blocks or frees some cells and says where.
  Rectangle edit() {
    for (;;) {
      const int width = 1 + below(9), height = 1 + below(9);
      const Rectangle part{below(grid_.width() - width), below(grid_.height() - height), width,
                           height};
      Grid edited = grid_;
      edited.fill(part, below(2) == 0);
      if (edited.blocked(start_) || edited.blocked(goal_)) continue;
      if (!Planner(edited).connected(start_, goal_)) continue;
      grid_ = std::move(edited);
      return part;
    }
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

 private:
  static constexpr Cell goal_{33, 30};
  std::mt19937 random_;
  Grid grid_;
  Cell start_;
};

TEST_P(EveryColony, WalksOnlyWhereTheMapIsFreeByNow) {
  Params params = few_ants(GetParam());
  const kernels::Moves moves = moves_of(params.neighbours);
  int paths = 0, edits = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    ChangingMap map(seed);
    params.polish = seed % 2 == 0 ? Polish::straight : Polish::none;
    SurvivingColony colony(map.grid(), map.goal(), params);
    const auto look = [&](const GridProgress& seen) {
      for (int a = 0; a < seen.ants(); ++a) {
        const auto tour = seen.walk(a);
        for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
          const auto k = std::find_if(moves.move.begin(), moves.move.begin() + moves.count,
                                      [&](const auto& m) { return tour[i] + m.to == tour[i + 1]; });
          ASSERT_TRUE(move_exists(map.grid(), params.corners, tour[i], *k)) << seed;
        }
      }
    };
    for (int i = 0; i < 80; ++i, ++edits) {
      colony.changed(map.edit());
      if (i % 3 == 0) colony.changed(map.edit());
      if (i % 5 == 0) map.move_start();
      const Result found = colony.run(map.start(), 2, {}, look);
      if (found.path.empty()) continue;
      ++paths;
      EXPECT_EQ(found.path.front(), centre(map.start()));
      EXPECT_EQ(found.path.back(), centre(map.goal()));
      const auto fault = path_fault(map.grid(), found.path, params.corners);
      ASSERT_FALSE(fault) << *fault;
    }
  }
  EXPECT_GT(paths, edits / 2);
}

TEST_P(EveryColony, ResultsDoNotDependOnThreads) {
  std::vector<Result> first;
  for (const int threads : {1, 2, 5}) {
    Params params = few_ants(GetParam());
    params.threads = threads;
    ChangingMap map(7);
    SurvivingColony colony(map.grid(), map.goal(), params);
    std::vector<Result> found;
    for (int i = 0; i < 12; ++i) {
      found.push_back(colony.run(map.start(), 3));
      colony.changed(map.edit());
      if (i % 4 == 3) map.move_start();
    }
    if (first.empty()) first = found;
    for (std::size_t i = 0; i < found.size(); ++i) expect_same_run(found[i], first[i]);
  }
}

TEST(SurvivingColony, OffersTheRestOfItsBestTour) {
  const FarApart far;
  SurvivingColony colony(far.planner.grid(), far.request.goal, quick("mmas"));
  const Result found = colony.run(far.request.start, 15);
  const std::size_t passed = found.path.size() / 3;
  const Point at = found.path[passed];
  const Result rest = colony.run({static_cast<int>(at.x), static_cast<int>(at.y)}, 0);
  EXPECT_EQ(rest.path, std::vector<Point>(found.path.begin() + passed, found.path.end()));
}

TEST(SurvivingColony, DropsABestWayThatIsBlocked) {
  // Two ways round: 10 cells below row 1, or above it, by one cell more each way.
  Grid grid = walled(12, 5, {{1, 1, 10, 1}});
  SurvivingColony colony(grid, {11, 1}, few_ants("eas"));
  const double shorter = colony.run({0, 1}, 30).length;
  grid.set_blocked({5, 0});
  colony.changed({5, 0, 1, 1});
  EXPECT_TRUE(colony.run({0, 1}, 0).path.empty());
  EXPECT_GE(colony.run({0, 1}, 30).length, shorter);
}

// Pockets on both sides of the way, in which ants die.
TEST(SurvivingColony, KeepsItsTrailWhereNoAntHasArrived) {
  const Grid grid = grid_of(41, 5, [](int x, int y) { return y != 2 && x % 2 == 1; });
  Params params = few_ants("as");
  params.dead_end = DeadEnd::kill;
  params.trail = Trail::cells;
  SurvivingColony colony(grid, {40, 2}, params), other(grid, {40, 2}, params);
  EXPECT_EQ(colony.run({0, 2}, 1).curves.arrived, std::vector{0});
  (void)other.run({0, 2}, 1);
  other.changed({1, 2, 1, 1});
  EXPECT_EQ(other.run({0, 2}, 40).curves.steps, colony.run({0, 2}, 40).curves.steps);
}

/// Cells whose index some way holds up, found by sweeps over the whole map.
std::vector<bool> held_up(const Field& field, const Grid& grid, const Params& params, Cell goal) {
  const auto moves = moves_of(params.neighbours);
  const auto index = [&](Cell c) { return static_cast<std::size_t>(c.y) * grid.width() + c.x; };
  std::vector<bool> held(index({0, grid.height()}));
  held[index(goal)] = true;
  for (bool more = true; more;) {
    more = false;
    for (const Cell c : cells_of(grid)) {
      const double k = field.tau(c, 0);
      if (held[index(c)] || grid.blocked(c) || k >= field.untouched()) continue;
      for (int m = 0; m < moves.count && !held[index(c)]; ++m) {
        const Cell to = c + moves[m].to;
        if (!move_exists(grid, params.corners, c, moves[m]) || !held[index(to)]) continue;
        if (field.tau(to, 0) + moves[m].length <= k * (1 + 1e-6)) more = held[index(c)] = true;
      }
    }
  }
  return held;
}

TEST(TerminalIndex, ForgetsWhatLedThroughBlockedCellsAndNothingElse) {
  const Params params("terminal-index");
  const auto moves = moves_of(params.neighbours);
  std::mt19937 random(5);
  int forgotten = 0, kept = 0;
  for (unsigned seed = 1; seed <= 120; ++seed) {
    ChangingMap map(seed);
    const Cell goal = map.goal();
    Field field;
    field.reset(map.grid(), moves, goal, params, 99, {});
    // Tours at random, in chains of several ants' labels.
    std::vector<int> ranking;
    for (int ant = 0; ant < 30; ++ant) {
      std::vector<std::uint8_t> walk;
      Cell c = goal;
      for (int i = 0; i < 60; ++i) {
        const auto k = static_cast<std::uint8_t>(map.below(moves.count));
        if (!move_exists(map.grid(), params.corners, c, moves[k])) continue;
        c = c + moves[k].to;
        walk.insert(walk.begin(), static_cast<std::uint8_t>(moves.count - 1 - k));  // the way back
      }
      const Tour tour{walk, 60};
      update_trail(field, params,
                   {.start = c,
                    .moves = moves,
                    .ants = {&tour, 1},
                    .best_so_far = tour,
                    .rows = 20,
                    .ranking = ranking});
    }
    for (int edits = 0; edits < 3; ++edits) {
      const Rectangle part = map.edit();
      const auto expected = held_up(field, map.grid(), params, goal);
      std::vector<double> before;
      for (const Cell c : cells_of(map.grid())) before.push_back(field.tau(c, 0));
      field.edited(part);
      forget_lost_ways(field, map.grid(), params.corners, moves, goal, part);
      for (std::size_t i = 0; i < before.size(); ++i) {
        const Cell c{static_cast<int>(i % 40), static_cast<int>(i / 40)};
        EXPECT_EQ(field.tau(c, 0), expected[i] ? before[i] : field.untouched())
            << c.x << ' ' << c.y;
        kept += expected[i];
        forgotten += !expected[i] && before[i] < field.untouched();
      }
    }
  }
  EXPECT_GT(forgotten, 100);
  EXPECT_GT(kept, 1000);
}

TEST(SurvivingColony, AgreesAnewAfterAChange) {
  Params params = few_ants("mmas");
  params.agreement = 3;
  const Grid corridor(20, 1);
  SurvivingColony colony(corridor, {19, 0}, params);
  EXPECT_EQ(colony.run({0, 0}, 10).curves.best.size(), 3U);
  colony.changed({5, 0, 1, 1});
  EXPECT_EQ(colony.run({0, 0}, 10).curves.best.size(), 3U);
}

}  // namespace
}  // namespace lasius
