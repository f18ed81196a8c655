#include "core/cost/path_cost.h"

#include "lasius/cost/field.h"

namespace lasius {

std::optional<double> path_cost(const Grid& grid, const CostField& costs,
                                std::span<const Point> path) {
  costs.range(grid);  // the sizes agree
  const auto inside = [&](Point p) {
    return p.x >= 0 && p.y >= 0 && p.x <= grid.width() && p.y <= grid.height();
  };
  const auto weight = [&](int x, int y) {
    return grid.free({x, y}) ? costs.weight({x, y}) : kInfinity;
  };
  cost::PathCost sum(weight);
  for (std::size_t i = 0; i < path.size(); ++i)
    if (!inside(path[i]) || (i > 0 && !sum.add(path[i - 1], path[i]))) return std::nullopt;
  return sum.sum();
}

}  // namespace lasius
