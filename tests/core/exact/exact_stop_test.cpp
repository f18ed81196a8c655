// Searches cut short: what they give back must still be certified.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/bucket_queue.h"
#include "lasius/grid/generate.h"
#include "lasius/path/path.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/exact/exact_answers.h"

namespace lasius {
namespace {

constexpr int kSide = 700;
constexpr Cell kStart{2, 2};
constexpr Cell kGoal{kSide - 3, kSide - 3};

// Noise is what takes longest: every corner sees many others.
Grid noise(std::mt19937& random) {
  Grid grid = random_grid(kSide, kSide, 15, random);
  grid.fill({0, 0, 6, 6}, false);
  grid.fill({kSide - 6, kSide - 6, 6, 6}, false);
  return grid;
}

TEST(ExactStop, BoundsHoldAtEveryStop) {
  std::mt19937 random(11);
  ExactSearch search;
  int with_path = 0;
  int stopped = 0;
  for (int map = 0; map < 3; ++map) {
    const Grid grid = noise(random);
    const Stops stops = expect_bounds_at_stops(grid, kStart, kGoal, [&](const StopCondition& stop) {
      return solve(search, grid, kStart, kGoal, {}, stop);
    });
    stopped += stops.stopped;
    with_path += stops.with_path;
  }
  EXPECT_GT(stopped, 8);
  EXPECT_GT(with_path, 4);
}

// Stopped at a random look at the clock, with the bounding search or not.
TEST(ExactStop, BoundsHoldAtRandomStopsOnEveryKindOfMap) {
  std::mt19937 random(14);
  ExactSearch search;
  int stopped = 0, with_path = 0, with_gain = 0;
  for (std::size_t k = 0; k < map_kind_names().size(); ++k) {
    const Grid grid = generate(static_cast<MapKind>(k), {600, 500, -1, 4});
    for (int i = 0; i < 60; ++i) {
      const Cell start = random_cell(grid, random), goal = random_cell(grid, random);
      if (grid.blocked(start) || grid.blocked(goal)) continue;
      const ExactAnswer exact = solve(search, grid, start, goal);
      if (!exact.optimal) continue;
      const ExactOptions options{i % 2 == 0 ? 0 : 0.05};
      const CountingTime counted(1 << 30);
      (void)solve(search, grid, start, goal, options, counted.is_up());
      const CountingTime time(random_in(0, std::max(0, counted.polls() - 1), random));
      const ExactAnswer cut = solve(search, grid, start, goal, options, time.is_up());
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

/// Never up; notes the most words that the search scanned between two looks.
class WordsBetweenLooks final : public TimeSource {
 public:
  explicit WordsBetweenLooks(const ExactSearch& search) : search_(search) {}
  Clock::time_point now() const noexcept override {
    const std::int64_t words = search_.counters().words;
    most_ = std::max(most_, words - last_);
    last_ = words;
    return {};
  }
  std::int64_t most() const noexcept { return most_; }

 private:
  const ExactSearch& search_;
  mutable std::int64_t last_ = 0, most_ = 0;
};

TEST(ExactStop, PollsAtLeastEach65536Words) {
  std::mt19937 random(12);
  const Grid grid = noise(random);
  ExactSearch search;
  const WordsBetweenLooks time(search);
  const StopCondition never{.deadline = Clock::time_point{} + std::chrono::hours(1), .time = &time};
  ASSERT_TRUE(solve(search, grid, kStart, kGoal, {}, never).optimal);
  ASSERT_GT(search.counters().words, 65536);
  EXPECT_GT(time.most(), 0);
  EXPECT_LE(time.most(), 65536);
}

// Where blocks are dense, an expansion scans few words.
TEST(ExactStop, ExpansionsAreWorkToo) {
  const Planner planner(generate(MapKind::random, {600, 600, 0.35, 3}));
  const Cell start = planner.nearest_free({20, 20}).value();
  const Cell goal = planner.nearest_free({570, 580}).value();
  ASSERT_TRUE(planner.connected(start, goal, Corners::forbid));
  const CountingTime counted(1 << 30);
  ExactSearch search;
  (void)solve(search, planner.grid(), start, goal, {}, counted.is_up());
  const auto words = static_cast<double>(search.counters().words);
  const auto expanded =
      static_cast<double>(exact::kWordsPerExpansion * search.counters().expansions);
  ASSERT_GT(expanded, 0.2 * words);
  EXPECT_GT(8192.0 * counted.polls(), 0.95 * (words + expanded));
}

// On very long ways most corners wait beyond the buckets, and are looked at again each time these
// start anew.
TEST(ExactStop, APollerIsToldOfTheItemsThatAFrontierDealsOut) {
  Poller poller(kNeverStops, 1);
  BucketQueue frontier;
  frontier.reset(0, 1);
  constexpr int kItems = 5;
  for (std::uint32_t i = 0; i < kItems; ++i) frontier.push(i, 1e5 * (i + 1));
  for (std::uint32_t i = 0; i < kItems; ++i) {
    ASSERT_TRUE(frontier.advance(poller));
    EXPECT_EQ(poller.take_work(), kItems - i);  // all that still wait
    EXPECT_EQ(frontier.pop(), i);
  }
  EXPECT_FALSE(frontier.advance(poller));
}

// Where every path has a mirror image, a deadline must not decide which of the two is returned.
TEST(ExactStop, ADeadlineThatIsNotReachedChangesNothing) {
  std::mt19937 random(15);
  ExactSearch search;
  int found = 0;
  for (int i = 0; i < 20; ++i) {
    Grid grid = mirrored_grid(400, 201, 30, random);
    const Cell start{1, 100}, goal{398, 100};
    for (const Cell c : {start, goal}) grid.set_blocked(c, false);
    const ExactAnswer without = solve(search, grid, start, goal);
    const CountingTime never(1 << 30);
    EXPECT_EQ(solve(search, grid, start, goal, {}, never.is_up()).path, without.path);
    found += without.path.empty() ? 0 : 1;
  }
  EXPECT_GT(found, 10);
}

// A way of 5000 cells takes milliseconds to prove; a path is there after a tenth of that.
TEST(ExactStop, OnALongWayAPathIsSoonThere) {
  const Planner planner(generate(MapKind::blobs, {4096, 4096, -1, 5}));
  const Grid& grid = planner.grid();
  const Cell start = planner.nearest_free({100, 100}).value();
  const Cell goal = planner.nearest_free({3990, 3990}).value();
  ExactSearch search;
  const CountingTime counted(1 << 30);
  ASSERT_TRUE(solve(search, grid, start, goal, {}, counted.is_up()).optimal);
  const CountingTime time(counted.polls() / 10);
  const ExactAnswer cut = solve(search, grid, start, goal, {}, time.is_up());
  EXPECT_EQ(cut.end, ExactEnd::stopped);
  ASSERT_FALSE(cut.path.empty());
  EXPECT_LT(cut.length, 1.25 * cut.lower_bound);
}

TEST(ExactStop, ATokenInterrupts) {
  std::mt19937 random(13);
  const Grid grid = noise(random);
  ExactSearch search;
  const ExactAnswer answer = solve(search, grid, kStart, kGoal, {}, fired());
  EXPECT_EQ(answer.end, ExactEnd::stopped);
  EXPECT_EQ(answer.cause, StopCondition::Cause::token);
  EXPECT_GT(answer.lower_bound, (kSide - 5) * 1.414);
}

}  // namespace
}  // namespace lasius
