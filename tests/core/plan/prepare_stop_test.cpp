// Preparation that is stopped: how often it looks at the clock, and what it leaves.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/poller.h"
#include "core/grid/components.h"
#include "lasius/grid/clearance.h"
#include "lasius/grid/generate.h"
#include "lasius/path/shortest_walk.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using Connectivity = Components::Connectivity;

// 64 tiles.
const Grid& noise() {
  static const Grid grid = generate(MapKind::random, {2048, 2048, 0.3, 1});
  return grid;
}

/// Work that can be stopped. `run` is true when all was done as without a condition.
struct Work {
  std::string name;
  std::int64_t words;  ///< that it scans
  std::function<bool(const StopCondition&)> run;
};

void PrintTo(const Work& work, std::ostream* out) { *out << work.name; }

Work labelling(Connectivity connectivity) {
  // Tiles count as 4096 words: read, and read along their borders.
  return {connectivity == Connectivity::four ? "LabellingFour" : "LabellingEight", 2 * 64 * 4096,
          [connectivity](const StopCondition& stop) {
            const auto made = Components::make(noise(), connectivity, stop);
            return made && *made == Components(noise(), connectivity);
          }};
}

// One edit a tile, on borders too.
std::vector<Cell> edited_cells() {
  std::vector<Cell> cells;
  for (int i = 0; i < 64; ++i) cells.push_back({i % 8 * 256 + i, i / 8 * 256 + 3 * i});
  return cells;
}

Work relabelling() {
  return {"Relabelling", 64 * 4096, [](const StopCondition& stop) {
            const Components before(noise(), Connectivity::four);
            const auto cells = edited_cells();
            Grid now = noise();
            for (const Cell c : cells) now.set_blocked(c, now.free(c));
            const auto made = before.updated(now, cells, stop);
            return made && *made == Components(now, Connectivity::four);
          }};
}

// Made whenever a test of this program starts, so soon made.
Grid blocks(int width, int height) {
  Grid grid(width, height);
  for (int i = 0; i < 100; ++i)
    grid.fill({97 * i % (width - 30), 61 * i % (height - 30), 10 + i % 20, 10 + i % 17}, true);
  return grid;
}

// A radius beyond the map has the first row search all columns to their ends; then rows follow.
Work growing(std::string name, Grid grid, double radius, int looks) {
  const std::int64_t cells = std::int64_t{grid.width()} * grid.height();
  return {std::move(name), looks * cells,
          [grid = std::move(grid), radius](const StopCondition& stop) {
            const auto grown = grow_obstacles(grid, radius, stop);
            return grown && *grown == grow_obstacles(grid, radius);
          }};
}

// Two sweeps over the columns, one over the rows.
Work measuring(std::string name, Grid grid) {
  const std::int64_t cells = std::int64_t{grid.width()} * grid.height();
  return {std::move(name), 3 * cells, [grid = std::move(grid)](const StopCondition& stop) {
            const auto field = clearance(grid, stop);
            return field && field->squared_half_cells == clearance(grid).squared_half_cells;
          }};
}

// Through every second row of the map: all free cells on the way there, as many on the way back.
Work walking() {
  const Grid grid = snake(301);
  return {"Walking", 2 * 4 * grid.count_free(), [grid](const StopCondition& stop) {
            return shortest_walk(grid, {0, 0}, {300, 300}, Neighbours::four, Corners::forbid, stop)
                .has_value();
          }};
}

class StoppedWork : public testing::TestWithParam<Work> {};

TEST_P(StoppedWork, PollsAtLeastEvery65536Words) {
  const CountingTime counted(1 << 30);
  EXPECT_TRUE(GetParam().run(counted.is_up()));
  EXPECT_GE(counted.polls(), GetParam().words / Poller::kWords);
  EXPECT_LE(counted.polls(), 8 * GetParam().words / Poller::kWords) << "more than is of use";
}

TEST_P(StoppedWork, EndsAtTheFirstPollThatSaysSo) {
  const CountingTime counted(1 << 30);
  ASSERT_TRUE(GetParam().run(counted.is_up()));
  ASSERT_GT(counted.polls(), 2);
  for (int polls = 0; polls < counted.polls(); polls += std::max(1, counted.polls() / 8)) {
    const CountingTime time(polls);
    EXPECT_FALSE(GetParam().run(time.is_up()));
    EXPECT_EQ(time.polls(), polls + 1);
  }
  EXPECT_FALSE(GetParam().run(fired()));
}

INSTANTIATE_TEST_SUITE_P(Preparation, StoppedWork,
                         testing::Values(labelling(Connectivity::four),
                                         labelling(Connectivity::eight), relabelling(),
                                         growing("GrowingFar", Grid(1000, 700), 1e6, 2),
                                         growing("GrowingFarInTallMaps", Grid(20, 32768), 1e6, 2),
                                         growing("GrowingNear", blocks(1000, 500), 3, 1),
                                         growing("GrowingWideMaps", Grid(30000, 8), 1, 1),
                                         measuring("Measuring", blocks(900, 400)),
                                         measuring("MeasuringWideMaps", Grid(32768, 5)), walking()),
                         [](const auto& tested) { return tested.param.name; });

TEST(StoppedPlanner, LeavesTheGridAsItWas) {
  Grid grid = noise();
  EXPECT_FALSE(Planner::make(std::move(grid), {}, fired()));
  EXPECT_EQ(grid, noise());
  EXPECT_FALSE(Planner::make_prepared(std::move(grid), {.stop = fired()}));
  EXPECT_EQ(grid, noise());
  const auto planner = Planner::make(std::move(grid));
  ASSERT_TRUE(planner);
  EXPECT_EQ(planner->grid(), noise());
  EXPECT_EQ(planner->preparation().state, Preparation::State::none);
}

TEST(StoppedPlanner, WithoutTheHeavierPreparationItPlansOn) {
  const CountingTime counted(1 << 30);
  ASSERT_TRUE(Planner::make(Grid(noise()), {}, counted.is_up()));
  const CountingTime time(counted.polls());
  const auto planner = Planner::make_prepared(Grid(noise()), {.stop = time.is_up()});
  ASSERT_TRUE(planner);
  EXPECT_EQ(planner->preparation().state, Preparation::State::stopped);
  EXPECT_EQ(planner->footprint().components, Planner(noise()).footprint().components);
}

// Joined through diagonal steps only.
Grid diagonals(int side) {
  Grid grid(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) grid.set_blocked({x, y}, (x + y) % 2 != 0);
  }
  return grid;
}

TEST(StoppedPlanner, APlanPaysForTheRuleThatItIsFirstToAskFor) {
  const Planner planner(diagonals(2048));
  Params params("as");
  params.corners = Corners::allow;
  params.iterations = 1;
  Request request{.start = {0, 0}, .goal = {1, 1}};
  const CountingTime up(0);
  request.stop = up.is_up();
  EXPECT_EQ(planner.plan(request, params).status, Status::limit);
  EXPECT_EQ(up.polls(), 2);
  EXPECT_FALSE(planner.label(Corners::allow, up.is_up()));
  request.stop = fired();
  EXPECT_EQ(planner.plan(request, params).status, Status::interrupted);

  EXPECT_TRUE(planner.label(Corners::forbid, up.is_up())) << "is labelled since it was made";
  EXPECT_TRUE(planner.label(Corners::allow));
  EXPECT_TRUE(planner.label(Corners::allow, fired())) << "is labelled by now";
  request.stop = {};
  EXPECT_EQ(planner.plan(request, params).status, Status::solved);
}

TEST(StoppedPlanner, AnEditIsMadeOrNot) {
  const Planner planner(noise());
  Grid now = noise();
  std::vector<Planner::Edit> edits;
  std::vector<Planner::Direction> directions;
  for (const Cell c : edited_cells()) {
    edits.push_back({c, noise().free(c)});
    now.set_blocked(c, noise().free(c));
    directions.push_back({c, c.x > 0 ? -1 : 1, 0});
  }
  EXPECT_FALSE(planner.edited(edits, fired()));
  EXPECT_FALSE(planner.exclude(directions, fired()));
  EXPECT_EQ(planner.grid(), noise());
  EXPECT_TRUE(planner.excluded().empty());

  const auto edited = planner.edited(edits);
  const auto excluded = planner.exclude(directions);
  ASSERT_TRUE(edited && excluded);
  EXPECT_EQ(edited->grid(), now);
  EXPECT_NE(excluded->grid(), noise());
  EXPECT_FALSE(excluded->allow(directions, fired()));
  EXPECT_EQ(excluded->excluded().size(), directions.size());
  const auto allowed = excluded->allow(directions);
  ASSERT_TRUE(allowed);
  EXPECT_EQ(allowed->grid(), noise());
}

}  // namespace
}  // namespace lasius
