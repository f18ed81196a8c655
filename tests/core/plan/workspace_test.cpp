// Workspaces that are kept: what earlier calls leave in them, and what they hold.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>

#include "tests/core/base/counting_time.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

constexpr int kPagedSide = 2200;  // the planes of ants have pages of their own
constexpr Cell kYard{900, 1};     // where a small map lies in the large one, walled off

const Planner& tiny() {
  static const Planner map(blobs());
  return map;
}
const Planner& large() {
  static const Planner map([] {
    const Grid& small = tiny().grid();
    Grid grid = blobs(kPagedSide, kPagedSide);
    grid.fill({kYard.x - 1, kYard.y - 1, small.width() + 2, small.height() + 2}, true);
    const Rectangle yard{kYard.x, kYard.y, small.width(), small.height()};
    grid.paste(yard, small.bytes(Nonzero::blocked), Nonzero::blocked);
    return grid;
  }());
  return map;
}
/// From one end of the small map to the other, in the large one.
Request in_the_yard() {
  const Request request = far_apart(tiny());
  const auto there = [](Cell c) { return Cell{c.x + kYard.x, c.y + kYard.y}; };
  return {.start = there(request.start), .goal = there(request.goal)};
}

Params small(std::string_view algorithm) {
  Params params = quick(algorithm);
  const Algorithm& read = find_algorithm(algorithm);
  if (read.has("iterations")) params.iterations = 2;
  if (read.has("ants")) params.ants = 4;
  if (read.has("population")) params.population = 4;
  return params;
}

Result cut_short(const Params& params, int looks, Workspace& workspace) {
  static const Request far = far_apart(large());
  const CountingTime time(looks);
  return large().plan({.start = far.start, .goal = far.goal, .stop = time.is_up()}, params,
                      {.workspace = &workspace});
}

class KeptWorkspace : public testing::TestWithParam<std::string_view> {};
std::vector<std::string_view> names() {
  std::vector<std::string_view> all;
  for (const Algorithm& algorithm : algorithms()) all.push_back(algorithm.name);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Workspace, KeptWorkspace, testing::ValuesIn(names()), by_algorithm);

TEST_P(KeptWorkspace, AfterCutsAnswersAndHoldsAsAFreshOneDoes) {
  const Params params = small(GetParam());
  const Request request = in_the_yard();
  Workspace fresh;
  const Result expected = large().plan(request, params, {.workspace = &fresh});
  ASSERT_FALSE(expected.path.empty());
  std::int64_t most = fresh.bytes();
  Workspace kept;
  for (const int looks : {0, 1, 2, 3, 5, 20, 50, 100, 300, 40, 10, 4}) {
    Workspace once;
    (void)cut_short(params, looks, once);
    most = std::max(most, once.bytes());
    (void)cut_short(params, looks, kept);
    EXPECT_LE(kept.bytes(), most + most / 2) << looks;
    if (looks % 2 == 0) continue;  // or cut short twice in a row
    const Result again = large().plan(request, params, {.workspace = &kept});
    EXPECT_EQ(again.path, expected.path) << looks;
    EXPECT_EQ(again.curves.mean, expected.curves.mean) << looks;
  }
}

TEST(Workspace, ServesAllAlgorithmsAndMapsInTurn) {
  Workspace kept;
  for (const int looks : {3, 30}) {
    for (const Algorithm& algorithm : algorithms()) {
      const Params params = small(algorithm.name);
      (void)cut_short(params, looks, kept);
      const Request request = far_apart(tiny());
      for (const Planner* map : {&tiny(), &large()}) {
        const Request asked = map == &tiny() ? request : in_the_yard();
        const Result expected = map->plan(asked, params);
        const Result again = map->plan(asked, params, {.workspace = &kept});
        EXPECT_EQ(again.path, expected.path) << algorithm.name;
        EXPECT_EQ(again.curves.mean, expected.curves.mean) << algorithm.name;
      }
    }
  }
}

// Blocks below MemoryBlock::kPaged come from the C library, which maps the larger ones of them.
std::int64_t heap_in_use() {
  const auto info = mallinfo2();
  return static_cast<std::int64_t>(info.uordblks + info.hblkhd);
}

bool heap_is_counted() {
  const auto nothing = heap_in_use();
  const auto block = std::make_unique<char[]>(100000);
  return heap_in_use() >= nothing + 100000;
}

TEST(Planner, TellsWhatADiscHolds) {
  if (!heap_is_counted()) GTEST_SKIP() << "the allocator does not count";
  const auto before = heap_in_use();
  const Planner disc(Grid(900, 900), Disc{2});
  const auto held = static_cast<double>(heap_in_use() - before);
  const Planner::Footprint told = disc.footprint();
  const std::int64_t sum = told.bitmap + told.components + told.disc;
  EXPECT_NEAR(static_cast<double>(sum), held, 0.01 * held);
}

TEST(Workspace, TellsWhatItHoldsAndGivesItBack) {
  const Planner plain(blobs(150, 100));
  const Planner prepared = plain.prepared({.threads = 1});
  const Planner disc(plain.grid(), Disc{0.5});
  const Request request = far_apart(plain);
  if (!heap_is_counted()) GTEST_SKIP() << "the allocator does not count";
  for (const Algorithm& algorithm : algorithms()) {
    for (const Planner* planner : {&plain, &prepared, &disc}) {
      const auto before = heap_in_use();
      Workspace workspace;
      const auto empty = workspace.bytes();
      (void)planner->plan(request, small(algorithm.name), {.workspace = &workspace});
      const auto held = static_cast<double>(heap_in_use() - before);
      EXPECT_NEAR(static_cast<double>(workspace.bytes()), held, 0.05 * held) << algorithm.name;
      workspace.release();
      EXPECT_EQ(workspace.bytes(), empty) << algorithm.name;
      // The allocator keeps some small blocks at hand.
      EXPECT_LT(static_cast<double>(heap_in_use() - before - empty), 10000 + held / 20)
          << algorithm.name;
      EXPECT_EQ(planner->plan(request, small(algorithm.name), {.workspace = &workspace}).path,
                planner->plan(request, small(algorithm.name)).path);
    }
  }
}

}  // namespace
}  // namespace lasius
