// Everything once on maps of 67 and 268 million cells: made, written, read, planned on, changed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lasius/grid/map_io.h"
#include "lasius/path/path.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/made_files.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

constexpr int kLargeSide = 8192;

class LargeMap : public Files {
 protected:
  static const Grid& grid() {
    static const Grid blobs = lasius::blobs(kLargeSide, kLargeSide);
    return blobs;
  }
};

TEST_F(LargeMap, IsWrittenAndReadBack) {
  const std::string file = path("large.pbm");
  write_map(grid(), file);
  EXPECT_EQ(read_map(file).grid, grid());
}

TEST_F(LargeMap, IsPlannedOnEditedAndProvenUnreachable) {
  const Planner planner(grid());
  const Request request = far_apart(planner);
  const Result best = planner.plan(request);
  ASSERT_TRUE(best.optimal);
  EXPECT_EQ(path_fault(grid(), best.path), std::nullopt);
  EXPECT_GT(best.length, 1.4 * kLargeSide);
  EXPECT_LE(planner.footprint().bitmap + planner.footprint().components,
            std::int64_t{kLargeSide} * kLargeSide / 8 * 5 / 4);  // 1.25 bits a cell

  std::vector<Planner::Edit> wall;
  for (int x = 0; x < kLargeSide; ++x) wall.push_back({{x, kLargeSide / 2}, true});
  const Planner parted = *planner.edited(wall);
  EXPECT_EQ(parted.plan(request).status, Status::unreachable);
  const Planner opened =
      *parted.edited(std::vector<Planner::Edit>{{{kLargeSide / 2, kLargeSide / 2}, false}});
  EXPECT_TRUE(opened.connected(request.start, request.goal));
  EXPECT_EQ(opened.plan(request).status, Status::solved);
  EXPECT_EQ(planner.plan(request).length, best.length);
}

// Ants stay where they can go, whatever the map's size: they do there what they do on a small map.
TEST_F(LargeMap, AntsPlanInACornerOfIt) {
  const Grid small = lasius::blobs(300, 200);
  const Request request = far_apart(Planner(small));
  constexpr int kAt = kLargeSide - 400;
  Grid large(kLargeSide, kLargeSide);
  large.fill(true);
  large.paste({kAt, kAt, small.width(), small.height()}, small.bytes(Nonzero::blocked),
              Nonzero::blocked);
  const auto there = [](Cell c) { return Cell{c.x + kAt, c.y + kAt}; };
  const Planner planner(std::move(large));
  for (const char* algorithm : {"fan2004", "as"}) {
    Params params = quick(algorithm);
    params.iterations = 3;
    const Result near = Planner(small).plan(request, params);
    params.threads = 2;
    const Result far =
        planner.plan({.start = there(request.start), .goal = there(request.goal)}, params);
    ASSERT_EQ(far.status, Status::solved);
    EXPECT_EQ(far.curves.mean, near.curves.mean);
    EXPECT_EQ(far.path.size(), near.path.size());
    EXPECT_NEAR(far.length, near.length, 1e-9);
  }
}

TEST_F(LargeMap, OfTwiceTheSideToo) {
  constexpr int kTwice = 2 * kLargeSide;
  Grid open(kTwice, kTwice);
  for (int x = 1; x < kTwice; ++x) open.set_blocked({x, kTwice / 2});  // a way by the left edge
  const Planner planner(std::move(open));
  const Result round = planner.plan({.start = {kTwice - 1, 0}, .goal = {kTwice - 1, kTwice - 1}});
  ASSERT_TRUE(round.optimal);
  // To the corners of the wall's end: 1 cell from the left edge, in rows kTwice / 2 and below.
  const double across = kTwice - 1.5, above = kTwice / 2 - 0.5, below = kTwice / 2 - 1.5;
  EXPECT_NEAR(round.length, std::hypot(across, above) + 1 + std::hypot(across, below), 1e-6);
}

TEST(LargeBlockedMap, IsSearchedForTheNearestFreeCellUntilASignal) {
  Grid grid(4096, 4096);
  grid.fill(true);
  grid.set_blocked({0, 0}, false);
  const Planner planner(std::move(grid));
  EXPECT_EQ(planner.nearest_free({2000, 2000}), (Cell{0, 0}));
  std::stop_source source;
  Request request{.start = {2000, 2000}, .goal = {0, 0}};
  request.stop = {.token = source.get_token(), .deadline = Clock::time_point{}};
  EXPECT_EQ(planner.plan(request).error,
            "start (2000, 2000) is blocked; the nearest free cell is (0, 0)");
  source.request_stop();
  const Result stopped = planner.plan(request);
  EXPECT_EQ(stopped.status, Status::invalid);
  EXPECT_EQ(stopped.error, "start (2000, 2000) is blocked");
}

}  // namespace
}  // namespace lasius
