// A* over costs on 8 neighbours: with a binary heap, with buckets, and as Theta*.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "bench/peers/cost_peers.h"

namespace lasius::peers {
namespace {

constexpr std::array<Cell, 8> kSteps{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

struct Item {
  double key, cost;
  std::uint32_t index;
  bool operator<(const Item& o) const noexcept { return key > o.key; }
};

class Heap {
 public:
  void reset(double) { items_.clear(); }
  void push(const Item& item) {
    items_.push_back(item);
    std::push_heap(items_.begin(), items_.end());
  }
  bool empty() { return items_.empty(); }
  Item pop() {
    std::pop_heap(items_.begin(), items_.end());
    const Item item = items_.back();
    items_.pop_back();
    return item;
  }
  /// Pops come in the order of keys up to this.
  double slack() const noexcept { return 0; }

 private:
  std::vector<Item> items_;
};

/// Last in, first out within buckets of a width.
class Buckets {
 public:
  void reset(double width) {
    width_ = width;
    current_ = 0;
    for (auto& bucket : buckets_) bucket.clear();
  }
  void push(const Item& item) {
    const auto place = static_cast<std::size_t>(item.key / width_);
    if (place >= buckets_.size()) buckets_.resize(place + 64);
    current_ = std::min(current_, place);
    buckets_[place].push_back(item);
  }
  bool empty() {
    while (current_ < buckets_.size() && buckets_[current_].empty()) ++current_;
    return current_ >= buckets_.size();
  }
  Item pop() {
    const Item item = buckets_[current_].back();
    buckets_[current_].pop_back();
    return item;
  }
  double slack() const noexcept { return width_; }

 private:
  double width_ = 1;
  std::size_t current_ = 0;
  std::vector<std::vector<Item>> buckets_;
};

/// A* with the distance at the least weight; a step costs its length times the mean of both
/// weights, which is its integral. With `kAnyAngle` it is basic Theta* (Nash, Daniel, Koenig &
/// Felner 2007): a neighbour's parent may be that of the cell, where the straight way from there,
/// by its exact integral, is cheaper.
template <class Frontier, bool kAnyAngle>
class CostAStar final : public QueryPlanner {
 public:
  explicit CostAStar(const WeightedMap& map)
      : map_(&map), integral_(map), cost_(map.size()), parent_(map.size()) {}

  double plan(Cell start, Cell goal, std::vector<Point>& path) override {
    path.clear();
    std::ranges::fill(cost_, kNoPath);
    frontier_.reset(0.1 * map_->least());
    const std::size_t first = map_->index(start), last = map_->index(goal);
    cost_[first] = 0;
    parent_[first] = static_cast<std::uint32_t>(first);
    frontier_.push({rest(start, goal), 0, parent_[first]});
    while (!frontier_.empty()) {
      const Item item = frontier_.pop();
      if (item.key >= cost_[last] + frontier_.slack()) break;
      if (item.cost <= cost_[item.index]) expand(item, goal, last);
    }
    if (cost_[last] == kNoPath) return kNoPath;
    for (std::size_t i = last;; i = parent_[i]) {
      path.push_back(centre(map_->cell(i)));
      if (i == first) break;
    }
    std::ranges::reverse(path);
    return cost_[last];
  }

 private:
  double rest(Cell c, Cell goal) const noexcept {
    const double dx = std::abs(c.x - goal.x), dy = std::abs(c.y - goal.y);
    if constexpr (kAnyAngle) return map_->least() * std::hypot(dx, dy);
    return map_->least() * (std::max(dx, dy) + (std::numbers::sqrt2 - 1) * std::min(dx, dy));
  }

  void expand(const Item& item, Cell goal, std::size_t last) {
    const Cell here = map_->cell(item.index);
    const double weight = map_->weight(here.x, here.y);
    for (const Cell step : kSteps) {
      const Cell there{here.x + step.x, here.y + step.y};
      if (!map_->joined(here, there)) continue;
      const std::size_t to = map_->index(there);
      const double length = step.x != 0 && step.y != 0 ? std::numbers::sqrt2 : 1;
      double cost = item.cost + length * (weight + map_->weight(there.x, there.y)) / 2;
      std::uint32_t parent = item.index;
      if constexpr (kAnyAngle) {
        const std::uint32_t over = parent_[item.index];
        const std::array<Point, 2> straight{centre(map_->cell(over)), centre(there)};
        const double way = cost_[over] + integral_.of(straight);
        if (way <= cost) {
          cost = way;
          parent = over;
        }
      }
      if (cost >= cost_[to]) continue;
      const double key = cost + rest(there, goal);
      if (key >= cost_[last]) continue;
      cost_[to] = cost;
      parent_[to] = parent;
      frontier_.push({key, cost, static_cast<std::uint32_t>(to)});
    }
  }

  const WeightedMap* map_;
  PathIntegral integral_;
  Frontier frontier_;
  std::vector<double> cost_;
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::unique_ptr<QueryPlanner> cost_heap_astar(const WeightedMap& map) {
  return std::make_unique<CostAStar<Heap, false>>(map);
}
std::unique_ptr<QueryPlanner> cost_bucket_astar(const WeightedMap& map) {
  return std::make_unique<CostAStar<Buckets, false>>(map);
}
std::unique_ptr<QueryPlanner> cost_theta_star(const WeightedMap& map) {
  return std::make_unique<CostAStar<Heap, true>>(map);
}

}  // namespace lasius::peers
