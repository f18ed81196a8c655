// Searches cut short: what they give back must still be certified.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact.h"
#include "lasius/generate.h"
#include "lasius/path.h"
#include "tests/core/counting_time.h"
#include "tests/random_grid.h"

namespace lasius {
namespace {

constexpr int kSide = 700;
constexpr Cell kStart{2, 2};
constexpr Cell kGoal{kSide - 3, kSide - 3};

// Noise is what takes longest: every corner sees many others.
Grid noise(std::mt19937& random) {
  Grid grid = random_grid(kSide, kSide, 15, random);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x) {
      grid.set_blocked({x, y}, false);
      grid.set_blocked({kSide - 1 - x, kSide - 1 - y}, false);
    }
  }
  return grid;
}

TEST(ExactStop, BoundsHoldAtEveryStop) {
  std::mt19937 random(11);
  ExactSearch search;
  int with_path = 0;
  int stopped = 0;
  for (int map = 0; map < 3; ++map) {
    const Grid grid = noise(random);
    ExactAnswer exact;
    search.search(grid, kStart, kGoal, {}, {}, exact);
    ASSERT_TRUE(exact.optimal);
    double last_bound = 0;
    for (int polls = 0; polls < 100; ++polls) {
      CountingTime time(polls);
      ExactAnswer cut;
      search.search(grid, kStart, kGoal, {}, time.is_up(), cut);
      if (cut.end != ExactEnd::stopped) {
        EXPECT_EQ(cut.path, exact.path);
        break;
      }
      ++stopped;
      EXPECT_EQ(cut.cause, StopCondition::Cause::deadline);
      EXPECT_FALSE(cut.optimal);
      EXPECT_LE(cut.lower_bound, exact.length);
      EXPECT_GE(cut.lower_bound, last_bound);
      last_bound = cut.lower_bound;
      if (cut.path.empty()) continue;
      ++with_path;
      EXPECT_GE(cut.length, exact.length * (1 - 1e-12));
      EXPECT_FALSE(path_fault(grid, cut.path).has_value());
    }
  }
  EXPECT_GT(stopped, 8);
  EXPECT_GT(with_path, 4);
}

// Stopped at a random look at the clock, hurried or not.
TEST(ExactStop, BoundsHoldAtRandomStopsOnEveryKindOfMap) {
  std::mt19937 random(14);
  ExactSearch search;
  int stopped = 0, with_path = 0, with_gain = 0;
  for (std::size_t k = 0; k < map_kind_names().size(); ++k) {
    const Grid grid = generate(static_cast<MapKind>(k), {600, 500, -1, 4});
    for (int i = 0; i < 60; ++i) {
      const auto cell = [&] { return Cell{random_in(0, 599, random), random_in(0, 499, random)}; };
      const Cell start = cell(), goal = cell();
      if (grid.blocked(start) || grid.blocked(goal)) continue;
      CountingTime counted(1 << 30);
      ExactAnswer exact;
      const ExactOptions options{i % 2 == 0 ? 0 : 0.05};
      search.search(grid, start, goal, {}, {}, exact);
      if (!exact.optimal) continue;
      ExactAnswer whole, cut;
      search.search(grid, start, goal, options, counted.is_up(), whole);
      CountingTime time(random_in(0, std::max(0, counted.polls() - 1), random));
      search.search(grid, start, goal, options, time.is_up(), cut);
      EXPECT_LE(cut.lower_bound, exact.length);
      stopped += cut.end == ExactEnd::stopped;
      const double dx = goal.x - start.x, dy = goal.y - start.y;
      with_gain += cut.lower_bound > std::sqrt(dx * dx + dy * dy);
      if (cut.path.empty()) continue;
      ++with_path;
      EXPECT_GE(cut.length, exact.length * (1 - 1e-12));
      EXPECT_FALSE(path_fault(grid, cut.path).has_value());
    }
  }
  EXPECT_GT(stopped, 30);
  EXPECT_GT(with_path, 10);
  EXPECT_GT(with_gain, 20);
}

TEST(ExactStop, PollsAtLeastEach65536Words) {
  std::mt19937 random(12);
  const Grid grid = noise(random);
  ExactSearch search;
  ExactAnswer answer;
  CountingTime time(1 << 30);
  search.search(grid, kStart, kGoal, {}, time.is_up(), answer);
  ASSERT_TRUE(answer.optimal);
  const std::int64_t words = search.counters().words;
  ASSERT_GT(words, 65536);
  EXPECT_GE(time.polls(), words / 16384);
}

TEST(ExactStop, ATokenInterrupts) {
  std::mt19937 random(13);
  const Grid grid = noise(random);
  std::stop_source source;
  source.request_stop();
  ExactSearch search;
  ExactAnswer answer;
  search.search(grid, kStart, kGoal, {}, {.token = source.get_token()}, answer);
  EXPECT_EQ(answer.end, ExactEnd::stopped);
  EXPECT_EQ(answer.cause, StopCondition::Cause::token);
  EXPECT_GT(answer.lower_bound, (kSide - 5) * 1.414);
}

}  // namespace
}  // namespace lasius
