#include "tests/oracle/cost_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace lasius::oracle {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

// Nodes are points of the boundary of one cell; those of two cells are joined at no cost where the
// cells share the edge that the point lies on, so that nobody squeezes through a corner.
double cost_over_points(const Grid& grid, const WeightOf& weight, Point start, Point goal,
                        int points) {
  struct Node {
    Cell cell;
    Point at;
  };
  std::vector<Node> nodes;
  std::map<std::pair<int, int>, std::vector<int>> of_cell;
  for (const Point end : {start, goal}) {
    const Cell cell{static_cast<int>(end.x), static_cast<int>(end.y)};
    of_cell[{cell.x, cell.y}].push_back(static_cast<int>(nodes.size()));
    nodes.push_back({cell, end});
  }
  const int steps = points + 1;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.blocked({x, y})) continue;
      for (int i = 0; i < 4 * steps; ++i) {
        const double t = static_cast<double>(i % steps) / steps;
        const Point sides[4] = {
            {x + t, y + 0.0}, {x + 1.0, y + t}, {x + 1 - t, y + 1.0}, {x + 0.0, y + 1 - t}};
        of_cell[{x, y}].push_back(static_cast<int>(nodes.size()));
        nodes.push_back({{x, y}, sides[i / steps]});
      }
    }
  }
  std::vector<double> cost(nodes.size(), kNever);
  std::vector<bool> done(nodes.size(), false);
  cost[0] = 0;
  for (;;) {
    int at = -1;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
      if (!done[i] && cost[i] < kNever && (at < 0 || cost[i] < cost[at])) at = i;
    }
    if (at < 0 || at == 1) return cost[1];
    done[at] = true;
    const auto [cell, from] = nodes[at];
    for (const int other : of_cell[{cell.x, cell.y}]) {
      const double length = std::hypot(nodes[other].at.x - from.x, nodes[other].at.y - from.y);
      cost[other] = std::min(cost[other], cost[at] + weight(cell) * length);
    }
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const auto beside = of_cell.find({cell.x + dx, cell.y + dy});
      if (beside == of_cell.end()) continue;
      for (const int other : beside->second) {
        if (std::hypot(nodes[other].at.x - from.x, nodes[other].at.y - from.y) < 1e-9)
          cost[other] = std::min(cost[other], cost[at]);
      }
    }
  }
}

double sampled_cost(const Grid& grid, const WeightOf& weight, std::span<const Point> path,
                    int samples) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double dx = path[i].x - path[i - 1].x, dy = path[i].y - path[i - 1].y;
    const double length = std::hypot(dx, dy);
    double of_segment = 0;
    for (int s = 0; s < samples; ++s) {
      const double t = (s + 0.5) / samples;
      double least = kNever;
      for (const double side : {-1e-9, 1e-9}) {
        const Point p{path[i - 1].x + t * dx + side * dy, path[i - 1].y + t * dy - side * dx};
        const Cell cell{static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))};
        if (grid.free(cell)) least = std::min(least, weight(cell));
      }
      of_segment += least;
    }
    sum += length > 0 ? of_segment / samples * length : 0;
  }
  return sum;
}

}  // namespace lasius::oracle
