// The field's rows against a plain reference that keeps tau of every cell and evaporates eagerly.
#include "core/colony/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "core/grid/move_rule.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/colony/walked_grid.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

Grid noisy(int width, int height, double blocked, unsigned seed) {
  std::mt19937 random(seed);
  return grid_of(width, height,
                 [&](int, int) { return static_cast<double>(random()) < blocked * 4294967296.0; });
}

/// tau by the formulas: every cell or arc in full, nothing lazy.
struct Reference {
  Reference(const Grid& g, const Params& p)
      : grid(g),
        params(p),
        moves(moves_of(p.neighbours)),
        tau(static_cast<std::size_t>(g.width()) * g.height() *
                (p.trail == Trail::arcs ? moves.count : 1),
            p.initial_pheromone) {}

  double& at(Cell c, int move) {
    const auto cell = static_cast<std::size_t>(c.y) * grid.width() + c.x;
    return tau[params.trail == Trail::arcs ? cell * moves.count + move : cell];
  }
  double of_move(Cell c, int k) {
    return params.trail == Trail::arcs ? at(c, k)
                                       : at({c.x + moves[k].to.dx, c.y + moves[k].to.dy}, 0);
  }

  const Grid& grid;
  Params params;
  kernels::Moves moves;
  std::vector<double> tau;
};

class FieldAgainstReference : public testing::TestWithParam<std::tuple<int, Trail, double>> {};

TEST_P(FieldAgainstReference, RowsKeepTheRatiosOfTauToTheAlpha) {
  const auto [neighbours, trail, persistence] = GetParam();
  const Grid grid = noisy(90, 70, 0.2, 4);
  Params params("fan2004");
  params.neighbours = neighbours == 4 ? Neighbours::four : Neighbours::eight;
  params.trail = trail;
  params.straight_deposit = StraightDeposit::none;
  params.persistence = persistence;
  params.initial_pheromone = 0.3;
  params.corners = Corners::allow;
  Field field;
  Reference reference(grid, params);
  field.reset(grid, reference.moves, {80, 60}, params, params.initial_pheromone, {});

  std::mt19937 random(9);
  for (int q = 0; q < 60; ++q) {
    const StepWeights weights = schedule(params, q);
    field.refresh(weights, 1);
    for (int i = 0; i < 40; ++i) {
      const Cell c{static_cast<int>(random() % 90), static_cast<int>(random() % 70)};
      const float* a = row(field, c, 2 * neighbours);
      const float* b = a + neighbours;
      double largest = 0;
      for (int k = 0; k < neighbours; ++k) {
        if (b[k] > 0) largest = std::max(largest, reference.of_move(c, k));
      }
      for (int k = 0; k < neighbours; ++k) {
        if (grid.blocked(c)) {
          EXPECT_EQ(a[k], 0);
          continue;
        }
        const Cell to{c.x + reference.moves[k].to.dx, c.y + reference.moves[k].to.dy};
        EXPECT_EQ(a[k] > 0, grid.free(to));
        EXPECT_EQ(b[k] > 0, grid.free(to));
        if (a[k] == 0) continue;
        const double ratio = reference.of_move(c, k) / largest;
        const double expected = std::max(std::pow(ratio, weights.alpha), 0x1p-60);
        EXPECT_NEAR(a[k] / expected, 1, 2e-5) << "iteration " << q;
        if (trail == Trail::cells) {
          EXPECT_NEAR(field.pheromone(to) / reference.at(to, 0), 1, 1e-5);
        }
      }
    }
    field.evaporate(persistence);
    for (double& t : reference.tau) t *= persistence;
    for (int i = 0; i < 30; ++i) {  // few cells, so that some gather a lot
      const Cell c{static_cast<int>(random() % 12) * 7, static_cast<int>(random() % 9) * 7};
      if (grid.blocked(c)) continue;
      const int move = static_cast<int>(random() % static_cast<unsigned>(neighbours));
      const double amount = static_cast<double>(random()) * 0x1p-32;
      field.deposit(c, move, amount);
      reference.at(c, move) += amount;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Field, FieldAgainstReference,
                         testing::Combine(testing::Values(4, 8),
                                          testing::Values(Trail::cells, Trail::arcs),
                                          testing::Values(0.999, 0.7)));

TEST(Field, RowsFollowBoundsUpAndOff) {
  const Grid grid = noisy(60, 50, 0.2, 4);
  Params params("ras");
  params.heuristic = Heuristic::uniform;
  const auto moves = moves_of(params.neighbours);
  Field free, bounded;
  for (Field* field : {&free, &bounded}) {
    field->reset(grid, moves, {50, 40}, params, 1, {});
    for (int x = 10; x < 30; ++x) field->deposit({x, 20}, 0, 7);
    field->evaporate(0.5);
  }
  const auto differing = [&] {
    const StepWeights weights = schedule(params, 0);
    free.refresh(weights, 1);
    bounded.refresh(weights, 1);
    int rows = 0;
    for (const Cell c : cells_of(grid)) {
      const float *a = row(free, c, moves.count), *b = row(bounded, c, moves.count);
      rows += !std::equal(a, a + moves.count, b);
    }
    return rows;
  };
  EXPECT_EQ(differing(), 0);
  bounded.bound(0, 2);
  EXPECT_GT(differing(), 0);
  bounded.bound(0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(differing(), 0);
  bounded.bound(3, 5);
  EXPECT_GT(differing(), 0);
  bounded.bound(0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(differing(), 0);
}

TEST(Field, EditedRowsAreThoseOfANewField) {
  for (const char* name : {"fan2004", "mmas", "terminal-index", "cong2009", "lecture-grid"}) {
    Params params(name);
    params.neighbours = Neighbours::thirty_two;
    const kernels::Moves moves = moves_of(params.neighbours);
    for (const Heuristic heuristic : {params.heuristic, Heuristic::distance_field}) {
      params.heuristic = heuristic;
      Grid grid = noisy(90, 70, 0.2, 4);
      Field kept, made;
      kept.reset(grid, moves, {80, 60}, params, 1, {});
      for (int i = 0; i < 60; ++i) (void)kept.exists({i, i}, 0);  // makes tiles
      const Rectangle part{30, 20, 9, 30};
      for (const bool blocked : {true, false}) {
        grid.fill(part, blocked);
        kept.edited(part);
        made.reset(grid, moves, {80, 60}, params, 1, {});
        const int floats = moves.count * (kept.mixture() ? 2 : 1);
        for (const Cell c : cells_of(grid)) {
          const float* row_made = row(made, c, floats);
          ASSERT_TRUE(std::equal(row_made, row_made + floats, row(kept, c, floats)))
              << name << ' ' << c.x << ' ' << c.y;
        }
      }
    }
  }
}

TEST(Field, ASingleRuleHoldsTheProductOfBothParts) {
  const Grid grid = noisy(64, 64, 0.2, 4);
  Params mixture("fan2004"), single = mixture;
  single.pheromone_rule_first = single.pheromone_rule = 0;
  single.distance_rule_first = single.distance_rule = single.distance_rule_last = 0;
  single.combined_rule_first = 1;
  Field two, one;
  two.reset(grid, moves_of(Neighbours::four), {50, 50}, mixture, 1, {});
  one.reset(grid, moves_of(Neighbours::four), {50, 50}, single, 1, {});
  EXPECT_TRUE(two.mixture());
  EXPECT_FALSE(one.mixture());
  for (Field* f : {&two, &one}) {
    f->deposit({10, 10}, 0, 3);
    f->deposit({33, 31}, 0, 5);
    f->refresh(schedule(mixture, 7), 1);
  }
  for (const Cell c : {Cell{10, 9}, Cell{32, 31}, Cell{33, 32}, Cell{20, 20}}) {
    const float* parts = row(two, c, 8);
    const float* product = row(one, c, 4);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(product[k], parts[k] * parts[4 + k]);
  }
}

TEST(Field, CornerRulesCloseDiagonalMoves) {
  Grid grid(3, 3);
  grid.set_blocked({1, 0});  // beside the move from (1, 1) to (0, 0) and to (2, 0)
  grid.set_blocked({0, 1});  // the other side of the one to (0, 0)
  Params params("fan2004");
  params.neighbours = Neighbours::eight;
  const auto open = [&](Corners corners) {
    params.corners = corners;
    Field field;
    field.reset(grid, moves_of(Neighbours::eight), {2, 2}, params, 1, {});
    const float* a = row(field, {1, 1}, 16);
    std::string moves;
    for (int k = 0; k < 8; ++k) moves += a[k] > 0 ? '1' : '0';
    return moves;
  };
  // Moves in scan order: NW N NE W E SW S SE.
  EXPECT_EQ(open(Corners::forbid), "00001011");
  EXPECT_EQ(open(Corners::one_side), "00101111");
  EXPECT_EQ(open(Corners::allow), "10101111");
}

TEST(Field, TilesExistOnlyWhereSomethingWasAskedOrLaid) {
  const Grid grid(4096, 4096);
  Field field;
  field.reset(grid, moves_of(Neighbours::four), {4000, 4000}, Params("fan2004"), 1, {});
  EXPECT_EQ(field.tiles(), 0);
  field.deposit({5, 5}, 0, 1);
  field.deposit({3000, 2000}, 0, 1);
  field.evaporate(0.5);
  field.refresh(schedule(Params("fan2004"), 3), 1);
  EXPECT_EQ(field.tiles(), 2);
  EXPECT_LT(field.bytes(), 500000);
}

TEST(Field, WhatGoesOverAllTilesPollsAndIsCutShort) {
  const Grid grid(512, 512);  // 256 tiles
  const auto moves = moves_of(Neighbours::four);
  const auto weight_of_pheromone = [&](const CountingTime& time) {
    Field field;
    field.reset(grid, moves, {500, 500}, Params("fan2004"), 1, time.is_up());
    for (int y = 8; y < 512; y += 32) {
      for (int x = 8; x < 512; x += 32) field.deposit({x, y}, 0, 1);
    }
    field.refresh(schedule(Params("fan2004"), 20), 1);
    return row(field, {7, 8}, 8)[0];  // north of (7, 8); (8, 8) in the east has twice as much
  };
  const CountingTime enough(1000), none(0);
  EXPECT_FLOAT_EQ(weight_of_pheromone(enough), 1.0f / 16);  // alpha 4
  EXPECT_EQ(enough.polls(), 256 / 4);
  EXPECT_EQ(weight_of_pheromone(none), 1);
}

TEST(Field, MakesNoTileOnceTimeIsUp) {
  const Grid grid(128, 128);
  const auto moves = moves_of(Neighbours::four);
  const CountingTime time(1);
  Field field;
  kernels::WalkWorld world;
  field.reset(grid, moves, {100, 100}, Params("fan2004"), 1, time.is_up());
  field.fill(world);
  const float* made = world.make_tile(world.context, 0);
  EXPECT_TRUE(std::any_of(made, made + kernels::kTileCells * 8, [](float w) { return w > 0; }));
  for (const int tile : {1, 2, 1}) {  // here every cell is blocked
    const float* rows = world.make_tile(world.context, tile);
    EXPECT_EQ(rows, world.tiles[tile]);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(rows) % 64, 0u);
    EXPECT_EQ(std::count(rows, rows + kernels::kTileCells * 8, 0.0f), kernels::kTileCells * 8);
  }
  EXPECT_EQ(field.tiles(), 1);
  EXPECT_EQ(time.polls(), 3);
  field.reset(grid, moves, {100, 100}, Params("fan2004"), 1, {});
  field.fill(world);
  EXPECT_EQ(world.tiles[1], nullptr);
  EXPECT_EQ(row(field, {40, 3}, 8)[0], 1);
}

TEST(Field, AResetThatIsCutShortIsMadeUpFor) {
  const Grid grid(2048, 2048);  // 4096 tiles
  const auto moves = moves_of(Neighbours::four);
  Field field;
  for (const int looks : {0, 1}) {
    field.reset(grid, moves, {2000, 2000}, Params("fan2004"), 1, {});
    for (int y = 8; y < 2048; y += 32) {
      for (int x = 8; x < 2048; x += 32) field.deposit({x, y}, 0, 1);
    }
    const auto bytes = field.bytes();
    const CountingTime time(looks);
    field.reset(grid, moves, {2000, 2000}, Params("fan2004"), 1, time.is_up());
    EXPECT_EQ(time.polls(), looks + 1);
    EXPECT_EQ(field.tiles(), 4096 - 1023 - 1024 * looks);  // a look each 1024 of them
    field.reset(grid, moves, {2000, 2000}, Params("fan2004"), 1, {});
    EXPECT_EQ(field.tiles(), 0);
    EXPECT_EQ(field.bytes(), bytes);
    EXPECT_EQ(field.tau({8, 8}, 0), 1);
  }
}

TEST(Field, TilesServePlansOfEveryKind) {
  const Grid grid(64, 64);
  Field kept;
  for (const char* algorithm : {"as", "fan2004", "cong2009", "lecture-grid", "as"}) {
    const Params params(algorithm);
    const auto moves = moves_of(params.neighbours);
    Field fresh;
    for (Field* field : {&kept, &fresh}) {
      field->reset(grid, moves, {60, 60}, params, 1, {});
      field->deposit({10, 10}, 1, 3);
      field->refresh(schedule(params, 1), 1);
    }
    const int floats = fresh.mixture() ? 2 * moves.count : moves.count;
    for (const Cell c : {Cell{9, 10}, Cell{10, 10}, Cell{30, 31}}) {
      const float* expected = row(fresh, c, floats);
      EXPECT_TRUE(std::equal(expected, expected + floats, row(kept, c, floats))) << algorithm;
    }
  }
}

TEST(Field, ManyIterationsNeitherOverflowNorForget) {
  const Grid grid(40, 40);
  Params params("fan2004");
  Field field;
  field.reset(grid, moves_of(Neighbours::four), {39, 39}, params, 1, {});
  for (int q = 0; q < 5000; ++q) {
    field.evaporate(0.5);
    field.deposit({20, 20}, 0, 1);
  }
  // The sum of a geometric series: 1 / (1 - 0.5).
  EXPECT_NEAR(field.pheromone({20, 20}), 2, 1e-5);
  EXPECT_NEAR(field.pheromone({0, 0}), 0, 1e-20);
  field.refresh(schedule(params, 5000), 1);
  const float* a = row(field, {19, 20}, 8);
  EXPECT_EQ(a[2], 1);  // east
  for (const int k : {0, 1, 3}) {
    EXPECT_GT(a[k], 0);
    EXPECT_LT(a[k], 1e-15);
  }
}

TEST(Field, ManyRewardsNeitherOverflowNorForget) {
  const Grid grid(100, 100);
  const Cell here{20, 20}, there{70, 70};
  Field field;
  field.reset(grid, moves_of(Neighbours::four), {99, 99}, Params("fan2004"), 3, {});
  // As cong2009 rewards a tour of four moves: 41 times as much, 5.4 bits, where a float has 127.
  const auto reward = [&](Cell c) { field.set_tau(c, 0, field.tau(c, 0) * 41); };
  for (int success = 0; success < 2000; ++success) {
    field.evaporate(0.8);
    reward(here);
    reward(there);
    if (success == 100) {
      EXPECT_NEAR(field.tau(here, 0), 3 * std::pow(0.8 * 41, 101), 1e-4 * field.tau(here, 0));
    }
    ASSERT_TRUE(std::isfinite(field.tau(here, 0))) << success;
    ASSERT_EQ(field.tau(here, 0), field.tau(there, 0)) << success;
  }
  field.set_tau(there, 0, field.tau(there, 0) * 0.5);
  EXPECT_EQ(field.tau(here, 0), 2 * field.tau(there, 0));
  EXPECT_GT(field.tau({0, 0}, 0), 0);
  field.deposit(there, 0, field.tau(there, 0));
  EXPECT_EQ(field.tau(here, 0), field.tau(there, 0));
}

}  // namespace
}  // namespace lasius
