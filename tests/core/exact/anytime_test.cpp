// What an exact search that is cut has found by then.
#include "core/exact/anytime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <stop_token>
#include <vector>

#include "lasius/grid/generate.h"
#include "lasius/path/path.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

constexpr MapKind kKinds[] = {MapKind::blobs, MapKind::maze,   MapKind::rooms,
                              MapKind::city,  MapKind::random, MapKind::open};

Params exact() { return Params("exact"); }

/// A planner on a generated map and a query across it.
struct Across {
  Across(MapKind kind, int side, double density, bool prepare = false)
      : planner(generate(kind, {side, side, density, 7})) {
    if (prepare) planner = planner.prepared({.threads = 1});
    const Cell near{side / 20, side / 20};
    start = planner.nearest_free(near).value();
    for (int i = side - 1 - side / 20; goal == Cell{}; --i) {
      const Cell c{i, i};
      if (planner.grid().free(c) && planner.connected(start, c, Corners::forbid)) goal = c;
    }
  }
  Result plan(const StopCondition& stop, const Observer& observer = {}) const {
    return planner.plan({.start = start, .goal = goal, .stop = stop}, exact(),
                        {.observer = observer});
  }
  int polls() const {
    const CountingTime counted(1 << 30);
    plan(counted.is_up());
    return counted.polls();
  }

  Planner planner;
  Cell start, goal{};
};

// On dense noise neither the exact search nor weighted A* with a small weight has a path for long.
TEST(Anytime, OnDenseNoiseAPathIsSoonThere) {
  const Across across(MapKind::random, 2048, 0.35);
  const CountingTime time(across.polls() / 20);
  const Result cut = across.plan(time.is_up());
  EXPECT_EQ(cut.status, Status::limit);
  EXPECT_EQ(cut.limit, Limit::time);
  ASSERT_FALSE(cut.path.empty());
  EXPECT_LT(cut.length, 1.4 * cut.lower_bound.value());
}

TEST(Anytime, ATokenIsEnoughForAPath) {
  const Across across(MapKind::random, 1024, 0.35);
  std::stop_source source;
  const StopCondition stop{.token = source.get_token()};
  exact::Anytime::Memory memory;
  exact::Anytime anytime(memory, across.planner.grid(), centre(across.start), centre(across.goal),
                         {}, stop);
  constexpr std::int64_t kTurn = 1 << 20;  // words
  for (int i = 0; i < 100; ++i) EXPECT_EQ(anytime.turn(kTurn), StopCondition::Cause::none);
  source.request_stop();
  StopCondition::Cause cause{};
  for (int i = 0; i < 100 && cause == StopCondition::Cause::none; ++i) cause = anytime.turn(kTurn);
  EXPECT_EQ(cause, StopCondition::Cause::token);
  ExactAnswer answer;
  answer.end = ExactEnd::stopped;
  answer.cause = cause;
  anytime.merge(answer);
  EXPECT_FALSE(path_fault(across.planner.grid(), answer.path).has_value());
  EXPECT_LT(answer.length, 1.5 * answer.lower_bound);
  EXPECT_EQ(answer.end, ExactEnd::stopped);
}

// Whichever search improves the path, and in the middle of whichever scan.
TEST(Anytime, WhatAnObserverThrowsArrives) {
  int throwing = 0;  // kinds of maps on which it throws
  for (const MapKind kind : {MapKind::blobs, MapKind::maze, MapKind::rooms, MapKind::random}) {
    const bool random = kind == MapKind::random;
    const Across across(kind, random ? 1024 : 2048, random ? 0.35 : -1);
    int thrown = 0;
    for (int n = 0; n < 3; ++n) {
      const CountingTime time(1 << 30);
      int told = 0;
      const Observer observer = [&](const GridProgress&) {
        if (told++ == n) throw std::runtime_error("enough");
      };
      try {
        (void)across.plan(time.is_up(), observer);
        EXPECT_LE(told, n);
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "enough");
        EXPECT_EQ(told, n + 1);
        ++thrown;
      }
    }
    throwing += thrown > 0 ? 1 : 0;
  }
  EXPECT_GE(throwing, 2);  // on the others the first path is proven
}

// Cut anywhere: the later, the closer; never past the optimum.
TEST(Anytime, PathAndBoundHoldAndOnlyImproveAtEveryStop) {
  for (const bool prepare : {false, true}) {
    for (const MapKind kind : kKinds) {
      SCOPED_TRACE(to_string(kind));
      const Across across(kind, 700, kind == MapKind::random ? 0.35 : -1, prepare);
      const Result whole = across.plan({});
      ASSERT_TRUE(whole.optimal);
      const int polls = across.polls();
      double bound = 0;
      std::vector<double> before;
      for (int i = 0; i < 12; ++i) {
        const CountingTime time(polls * i / 12);
        std::vector<double> told;
        const Result cut = across.plan(
            time.is_up(), [&](const GridProgress& now) { told.push_back(now.best_length); });
        ASSERT_TRUE(cut.lower_bound.has_value());
        EXPECT_LE(*cut.lower_bound, whole.length);
        EXPECT_GE(*cut.lower_bound, bound);
        bound = *cut.lower_bound;
        EXPECT_EQ(cut.path.empty(), told.empty());
        ASSERT_GE(told.size(), before.size());
        EXPECT_TRUE(std::equal(before.begin(), before.end(), told.begin()));
        before = told;
        if (!before.empty()) before.pop_back();  // perhaps told because the run was cut
        if (cut.path.empty()) continue;
        EXPECT_GE(cut.length, whole.length * (1 - 1e-12));
        EXPECT_LE(cut.length, told.back());
        EXPECT_FALSE(path_fault(across.planner.grid(), cut.path).has_value());
      }
    }
  }
}

// Where every path has a mirror image, the bounding search must not decide which of the two is
// returned.
TEST(Anytime, ADeadlineThatIsNotReachedChangesNothing) {
  std::mt19937 random(15);
  std::stop_source source;
  int solved = 0;
  for (int i = 0; i < 4; ++i) {
    Grid grid = mirrored_grid(1000, 601, 33, random);
    const Cell start{1, 300}, goal{998, 300};
    for (const Cell c : {start, goal}) grid.set_blocked(c, false);
    const Planner planner(std::move(grid));
    const Result without = planner.plan({.start = start, .goal = goal}, exact());
    if (without.status != Status::solved) continue;
    ++solved;
    const CountingTime counted(1 << 30);
    const auto with = [&](const StopCondition& stop) {
      return planner.plan({.start = start, .goal = goal, .stop = stop}, exact());
    };
    EXPECT_EQ(with(counted.is_up()).path, without.path);
    EXPECT_EQ(with({.token = source.get_token()}).path, without.path);
  }
  EXPECT_GT(solved, 0);
}

TEST(Anytime, AnObserverSeesShorterPathsAndHigherBounds) {
  const Across across(MapKind::random, 1024, 0.35);
  std::vector<double> lengths, bounds;
  const Observer look = [&](const GridProgress& progress) {
    EXPECT_EQ(progress.iteration, static_cast<int>(lengths.size()));
    EXPECT_DOUBLE_EQ(path_length(progress.path()), progress.best_length);
    lengths.push_back(progress.best_length);
    bounds.push_back(progress.lower_bound.value());
  };
  const CountingTime time(1 << 30);
  const Result whole = across.plan(time.is_up(), look);
  ASSERT_TRUE(whole.optimal);
  ASSERT_GT(lengths.size(), 2U);
  for (std::size_t i = 1; i < lengths.size(); ++i) {
    EXPECT_LT(lengths[i], lengths[i - 1]);
    EXPECT_GE(bounds[i], bounds[i - 1]);
    EXPECT_LE(bounds[i], whole.length);
  }
  EXPECT_DOUBLE_EQ(lengths.back(), whole.length);
}

// The bounding search alone: weights fall until the gap is small.
TEST(Anytime, ImprovingEndsCloseToTheOptimum) {
  const Across across(MapKind::random, 500, 0.3);
  const Result whole = across.plan({});
  ExactSearch search;
  search.begin_improving(across.planner.grid(), centre(across.start), centre(across.goal));
  const StopCondition never;
  Poller poller(never);
  while (search.improve(1 << 12, poller)) {
    EXPECT_LE(search.lower(), whole.length * (1 + 1e-12));
  }
  EXPECT_GE(search.upper(), whole.length * (1 - 1e-12));
  EXPECT_LE(search.upper(), 1.02 * search.lower());
  // After a stop nothing more is claimed.
  search.begin_improving(across.planner.grid(), centre(across.start), centre(across.goal));
  const CountingTime up(0);
  const StopCondition stop = up.is_up();
  Poller stopped(stop, 1);
  EXPECT_FALSE(search.improve(1 << 12, stopped));
  const double lower = search.lower();
  EXPECT_FALSE(search.improve(1 << 20, poller));
  EXPECT_EQ(search.lower(), lower);
}

}  // namespace
}  // namespace lasius
