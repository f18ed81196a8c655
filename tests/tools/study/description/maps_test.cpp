// The maps of the studies: what maps/README.md and the studies say of them.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "lasius/path/shortest_walk.h"
#include "lasius/plan/planner.h"
#include "tests/worlds/grids.h"
#include "tools/study/bitmaps.h"
#include "tools/study/description/study_file.h"
#include "tools/study/map_source.h"

namespace lasius::study {
namespace {

const std::string kMaps = LASIUS_MAPS_DIR;

TEST(Catalogue, EveryQuestionHasAWay) {
  for (const std::string_view name : study_names()) {
    const Study study = make_study(name);
    EXPECT_EQ(study.name, name);
    if (study.kind != ProblemKind::bitmap) continue;
    std::set<std::string> experiments;
    for (const Experiment& e : study.experiments) {
      EXPECT_TRUE(experiments.insert(e.name).second) << e.name;
      std::set<std::string> names;
      for (const Contender& c : e.contenders) EXPECT_TRUE(names.insert(c.name).second) << c.name;
      for (const Question& q : e.questions) {
        EXPECT_TRUE(names.insert(q.name).second) << q.name;
        const Planner planner(load_map(q.map, kMaps));
        EXPECT_TRUE(planner.connected(q.start, q.goal)) << study.name << " " << q.name;
        for (const Published& p : q.published) EXPECT_TRUE(names.contains(p.contender));
      }
    }
  }
}

double steps(const Grid& grid, Cell start, Cell goal) {
  return shortest_walk(grid, start, goal, Neighbours::four).value_or(INFINITY);
}

using Maze = std::pair<std::string, int>;  // name and side
class Mazes : public testing::TestWithParam<Maze> {};
INSTANTIATE_TEST_SUITE_P(Study, Mazes,
                         testing::Values(Maze{"maze1-10x10", 10}, Maze{"maze2-10x10", 10},
                                         Maze{"maze3-12x12", 12}, Maze{"maze4-16x16", 16},
                                         Maze{"maze5-16x16", 16}, Maze{"maze6-20x20", 20},
                                         Maze{"maze7-24x24", 24}, Maze{"maze8-32x32", 32}),
                         [](const auto& test) { return test.param.first.substr(0, 5); });

TEST_P(Mazes, HaveLoopsAndASecondRoute) {
  const auto& [name, side] = GetParam();
  Grid grid = load_map(name + ".map", kMaps);
  ASSERT_EQ(grid.width(), side);
  ASSERT_EQ(grid.height(), side);
  const Cell start{0, side - 1}, goal{side - 1, 0};
  const double best = steps(grid, start, goal);

  // Corridors are one cell wide, so every cycle of the cells' graph is a loop of the maze.
  int cells = 0, joins = 0;
  double second = INFINITY;
  for (const Cell c : cells_of(grid)) {
    if (grid.blocked(c)) continue;
    ++cells;
    joins += grid.free({c.x + 1, c.y}) + grid.free({c.x, c.y + 1});
    if (c == start || c == goal) continue;
    if (steps(grid, start, c) + steps(grid, c, goal) != best) continue;
    grid.set_blocked(c);  // on a best route: which one misses it?
    second = std::min(second, steps(grid, start, goal));
    grid.set_blocked(c, false);
  }
  EXPECT_GE(joins - cells + 1, 3);
  EXPECT_LE(second, 1.1 * best);
}

TEST(Grid20a, HasTheLengthThatFigure3EndsWith) {
  const Grid grid = load_map("grid20a.map", kMaps);
  EXPECT_NEAR(shortest_walk(grid, {0, 19}, {19, 0}, Neighbours::eight).value(),
              14 + 12 * std::sqrt(2.0), 1e-9);
}

// The lecture's best lengths of its colony, and start and goal of each pair.
TEST(Workspaces, OptimaLieALittleBelowTheLecturesLengths) {
  const Study lecture_grid = make_study("lecture-grid");
  for (const Experiment& e : lecture_grid.experiments) {
    for (const Question& q : e.questions) {
      if (q.published.empty()) continue;
      const Planner planner(load_map(q.map, kMaps));
      const auto optimum = true_optimum(planner, q, {}, {});
      ASSERT_TRUE(optimum);
      EXPECT_LE(*optimum, q.published[0].length) << e.name << " " << q.name;
      EXPECT_GE(*optimum, 0.96 * q.published[0].length) << e.name << " " << q.name;
    }
  }
}

}  // namespace
}  // namespace lasius::study
