#include "core/vehicle/prices.h"

#include <limits>

namespace lasius::vehicle {
namespace {

double price(const Vehicle& vehicle, int gear) noexcept {
  return gear == 0 ? vehicle.rotation_cost : gear < 0 ? vehicle.reverse_cost : 1;
}

}  // namespace

Prices::Prices(const Grid& grid, const Vehicle& vehicle, const CostField* costs)
    : vehicle_(vehicle), width_(grid.width()), height_(grid.height()) {
  if (costs == nullptr) return;
  CostField::Range range = costs->range(grid);
  // Where the reference point may be anywhere, all cells count.
  if (inscribed_radius(vehicle) <= 0) {
    const auto [least, most] = std::ranges::minmax_element(costs->weights());
    range = {*least, *most};
  }
  unit_ = range.least;
  if (range.least == range.most) return;
  weights_.reserve(costs->weights().size());
  for (const double weight : costs->weights()) weights_.push_back(std::max(1.0, weight / unit_));
}

double Prices::part(const Segment& s, double at) const {
  const double cell = price(vehicle_, s.gear);
  if (!weighted()) return at * cell;
  if (s.gear == 0) return at * cell * weight(s.begin);
  const auto weight_at = [&](int x, int y) { return weight(x, y); };
  cost::PathCost sum(weight_at);
  const double longer = walk_cells(s, at, sum);
  return sum.sum() * longer * cell;
}

double Prices::of(std::span<const Segment> segments) const {
  if (!weighted()) return cost(vehicle_, segments);
  double sum = 0;
  int gear = 0;
  for (const Segment& s : segments) {
    sum += part(s, s.extent());
    if (s.gear == 0) continue;
    if (gear != 0 && s.gear != gear) sum += vehicle_.cusp_cost * weight(s.begin);
    gear = s.gear;
  }
  return sum;
}

EdgePrices::EdgePrices(const Prices& prices, const Vehicle& vehicle, const Lattice& lattice)
    : prices_(prices) {
  std::vector<Segment> motions;
  for (const Edge& edge : lattice.edges()) {
    first_.push_back(static_cast<int>(parts_.size()));
    if (edge.gear == 0) {
      parts_.push_back({0, 0, static_cast<double>(edge.cost)});
      continue;
    }
    motions.clear();
    lattice.append(edge, 0, 0, motions);
    for (const Segment& s : motions) {
      Point from{s.begin.x, s.begin.y};
      const std::size_t begin = parts_.size();
      const auto weight = [](int, int) { return 1.0; };
      const auto take = [&](Cell cell, Point to) {
        parts_.push_back({cell.x, cell.y, distance(from, to)});
        from = to;
      };
      cost::PathCost sum(weight, take);
      const double longer = walk_cells(s, s.length, sum) * price(vehicle, s.gear);
      for (std::size_t i = begin; i < parts_.size(); ++i) parts_[i].price *= longer;
    }
    // One entry a cell, summed as it is driven.
    const auto mine = parts_.begin() + first_.back();
    std::stable_sort(mine, parts_.end(), [](const Part& a, const Part& b) {
      return a.dy != b.dy ? a.dy < b.dy : a.dx < b.dx;
    });
    auto last = mine;
    for (auto it = mine; it != parts_.end(); ++it) {
      if (it == last) continue;
      if (it->dx == last->dx && it->dy == last->dy)
        last->price += it->price;
      else
        *++last = *it;
    }
    parts_.erase(last + 1, parts_.end());
  }
  first_.push_back(static_cast<int>(parts_.size()));
}

}  // namespace lasius::vehicle
