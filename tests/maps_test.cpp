// The maps of maps/: what its README says of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <set>
#include <vector>

#include "lasius/grid/generate.h"
#include "lasius/grid/map_io.h"
#include "lasius/path/path.h"
#include "lasius/path/smooth.h"
#include "tests/oracle/visibility_graph.h"

namespace lasius {
namespace {

class Fan400x200 : public testing::Test {
 protected:
  static constexpr Cell kStart{14, 14};
  static constexpr Cell kGoal{380, 179};
  const Grid grid_ = read_map(LASIUS_MAPS_DIR "/fan400x200.map").grid;

  double optimum() const {
    const auto shortest = oracle::VisibilityGraph(grid_).shortest(kStart, kGoal);
    return shortest ? shortest->length : -1;
  }
};

// Parents of a breadth-first search by steps to the four sides, from a cell.
class Walks {
 public:
  Walks(const Grid& grid, Cell root) : width_(grid.width()), parent_(grid.height() * width_, -1) {
    std::deque<Cell> queue = {root};
    parent_[index(root)] = index(root);
    for (; !queue.empty(); queue.pop_front()) {
      const Cell c = queue.front();
      for (const Cell next :
           {Cell{c.x + 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x - 1, c.y}, Cell{c.x, c.y - 1}}) {
        if (grid.blocked(next) || parent_[index(next)] >= 0) continue;
        parent_[index(next)] = index(c);
        queue.push_back(next);
      }
    }
  }
  /// From a cell back to the root; empty where there is no way.
  std::vector<Point> from(Cell c) const {
    std::vector<Point> walk;
    for (int i = index(c); parent_[i] >= 0; i = parent_[i]) {
      walk.push_back(centre({i % width_, i / width_}));
      if (parent_[i] == i) break;
    }
    return walk;
  }

 private:
  int index(Cell c) const { return c.y * width_ + c.x; }
  int width_;
  std::vector<int> parent_;
};

// A point inside every obstacle of some size that does not touch the border.
std::vector<Point> obstacles(const Grid& grid) {
  constexpr int kSomeSize = 50;
  Grid left = grid;
  std::vector<Point> points;
  for (int i = 0; i < grid.width() * grid.height(); ++i) {
    const Cell seed{i % grid.width(), i / grid.width()};
    int cells = 0;
    bool at_border = false;
    std::vector<Cell> stack = {seed};
    while (!stack.empty()) {
      const Cell c = stack.back();
      stack.pop_back();
      at_border = at_border || (!grid.contains(c) && cells > 0);
      if (!left.contains(c) || left.free(c)) continue;
      left.set_blocked(c, false);
      ++cells;
      for (int k = 0; k < 9; ++k) stack.push_back({c.x + k % 3 - 1, c.y + k / 3 - 1});
    }
    if (cells >= kSomeSize && !at_border) points.push_back(centre(seed));
  }
  return points;
}

// For every obstacle, how often the path passes over it to the right, less to the left. Paths that
// differ in this belong to different homotopy classes.
std::vector<int> passes(const std::vector<Point>& path, const std::vector<Point>& points) {
  std::vector<int> counts;
  for (const Point p : points) {
    int count = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Point a = path[i - 1];
      const Point b = path[i];
      if ((a.x < p.x) == (b.x < p.x)) continue;
      const double y = a.y + (b.y - a.y) * (p.x - a.x) / (b.x - a.x);
      if (y < p.y) count += b.x > a.x ? 1 : -1;
    }
    counts.push_back(count);
  }
  return counts;
}

TEST_F(Fan400x200, IsMadeByItsCommand) {
  EXPECT_EQ(grid_, generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));
}

TEST_F(Fan400x200, BlocksTheStraightLine) {
  EXPECT_FALSE(visible(grid_, kStart, kGoal));
  const double straight = path_length(std::vector<Point>{centre(kStart), centre(kGoal)});
  EXPECT_NEAR(straight, 401.474, 0.0005);
  EXPECT_NEAR(optimum(), 445.001, 0.0005);
  EXPECT_GE(optimum(), 1.1 * straight);
}

TEST_F(Fan400x200, OffersSeveralHomotopyClasses) {
  const double limit = 1.05 * optimum();
  const std::vector<Point> points = obstacles(grid_);
  EXPECT_GE(points.size(), 20U) << "many obstacles";
  const Walks from_start(grid_, kStart);
  const Walks from_goal(grid_, kGoal);
  std::set<std::vector<int>> classes;
  for (int y = 4; y < grid_.height(); y += 8) {
    for (int x = 4; x < grid_.width(); x += 8) {
      std::vector<Point> walk = from_start.from({x, y});
      std::reverse(walk.begin(), walk.end());
      const std::vector<Point> rest = from_goal.from({x, y});
      if (walk.empty() || rest.empty()) continue;
      walk.insert(walk.end(), rest.begin() + 1, rest.end());
      const std::vector<Point> taut = pull_taut(grid_, walk);
      if (path_length(taut) <= limit) classes.insert(passes(taut, points));
    }
  }
  EXPECT_EQ(classes.size(), 7U);
}

}  // namespace
}  // namespace lasius
