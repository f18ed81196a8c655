#include "bench/peers/weighted_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lasius::peers {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNothing = 1e-9;  // cells: what is shorter is rounding

/// Where on its way from `from` to `to`, 0 to 1, a coordinate is whole.
void cut_axis(double from, double to, std::vector<double>& cuts) {
  cuts.clear();
  const double low = std::floor(std::min(from, to)) + 1, high = std::max(from, to);
  for (double line = low; line < high; ++line) cuts.push_back((line - from) / (to - from));
  if (from > to) std::ranges::reverse(cuts);
}

}  // namespace

WeightedMap::WeightedMap(const Grid& grid, const CostField& costs)
    : width_(grid.width()),
      height_(grid.height()),
      weights_(stride() * (static_cast<std::size_t>(height_) + 2), kInfinite) {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (grid.blocked({x, y})) continue;
      const double weight = costs.weight({x, y});
      weights_[index({x, y})] = weight;
      least_ = std::min(least_, weight);
    }
  }
}

void PathIntegral::cut(Point a, Point b) {
  cut_axis(a.x, b.x, cuts_x_);
  cut_axis(a.y, b.y, cuts_y_);
  cuts_.assign(1, 0);
  std::ranges::merge(cuts_x_, cuts_y_, std::back_inserter(cuts_));
  cuts_.push_back(1);
}

double PathIntegral::of(std::span<const Point> path) {
  double sum = 0;
  Cell last{};
  bool begun = false;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point a = path[i - 1], b = path[i];
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    cut(a, b);
    for (std::size_t piece = 1; piece < cuts_.size(); ++piece) {
      const double share = cuts_[piece] - cuts_[piece - 1];
      if (share * length <= kNothing) continue;
      const double middle = (cuts_[piece] + cuts_[piece - 1]) / 2;
      const double x = a.x + middle * dx, y = a.y + middle * dy;
      Cell cell{static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
      if (cell.x < 0 || cell.y < 0 || cell.x > map_->width() || cell.y > map_->height())
        return kInfinite;
      const Cell beside{cell.x - (dx == 0 && x == cell.x ? 1 : 0),
                        cell.y - (dy == 0 && y == cell.y ? 1 : 0)};
      if (map_->weight(beside.x, beside.y) < map_->weight(cell.x, cell.y)) cell = beside;
      if (!map_->free(cell.x, cell.y) || (begun && !map_->joined(last, cell))) return kInfinite;
      sum += map_->weight(cell.x, cell.y) * share * length;
      last = cell;
      begun = true;
    }
  }
  return sum;
}

}  // namespace lasius::peers
