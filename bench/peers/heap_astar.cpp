// A* on 8 neighbours with a binary heap: what most robots run.
#include <algorithm>
#include <bit>
#include <numbers>

#include "bench/peers/move_grid.h"
#include "bench/peers/octile_costs.h"
#include "bench/peers/peers.h"

namespace lasius::peers {
namespace {

/// Shortest octile path, no corner cutting (Hart, Nilsson & Raphael 1968): binary heap with stale
/// entries dropped when they are taken, ties broken towards the goal.
class HeapAStar final : public QueryPlanner {
 public:
  explicit HeapAStar(const Grid& grid);
  double plan(Cell start, Cell goal, std::vector<Point>& path) override;

 private:
  struct Node {
    std::uint32_t cost;
    std::uint32_t state;  // stamp << 3 | move that led here
  };
  struct Item {
    std::uint64_t key;  // bound, then the cost still to go: the smaller the better
    std::uint32_t index;
    std::uint16_t x, y;
    // The standard heap keeps the largest on top.
    bool operator<(const Item& o) const noexcept { return key > o.key; }
  };
  enum class Outcome { reached, unreachable, overflow };

  Outcome search(Cell start, Cell goal);

  MoveGrid moves_;
  std::vector<Node> nodes_;
  std::vector<Item> heap_;
  std::uint32_t stamp_ = 0;
  std::size_t scale_ = 0;
};

HeapAStar::HeapAStar(const Grid& grid) : moves_(grid), nodes_(moves_.size(), Node{0, 0}) {}

double HeapAStar::plan(Cell start, Cell goal, std::vector<Point>& path) {
  path.clear();
  Outcome outcome = search(start, goal);
  while (outcome == Outcome::overflow) {
    ++scale_;
    outcome = search(start, goal);
  }
  if (outcome == Outcome::unreachable) return kNoPath;
  std::int64_t straight = 0, diagonal = 0;
  for (Cell c = goal; c != start;) {
    path.push_back(centre(c));
    const std::uint32_t k = nodes_[moves_.index(c)].state & 7;
    ++(k < 4 ? straight : diagonal);
    c = {c.x - kMoveX[k], c.y - kMoveY[k]};
  }
  path.push_back(centre(start));
  std::reverse(path.begin(), path.end());
  return static_cast<double>(straight) + static_cast<double>(diagonal) * std::numbers::sqrt2;
}

HeapAStar::Outcome HeapAStar::search(Cell start, Cell goal) {
  if (++stamp_ == std::uint32_t{1} << 29) {
    std::fill(nodes_.begin(), nodes_.end(), Node{0, 0});
    stamp_ = 1;
  }
  heap_.clear();
  const OctileCosts costs = kOctileCosts[scale_];
  const std::uint32_t mark = stamp_ << 3;
  const std::uint32_t goal_index = moves_.index(goal);
  const auto offsets = moves_.offsets();
  const auto push = [&](std::uint32_t index, int x, int y, std::uint32_t cost) {
    const std::uint32_t rest = costs.distance(x, y, goal);
    heap_.push_back({std::uint64_t{cost + rest} << 32 | rest, index, static_cast<std::uint16_t>(x),
                     static_cast<std::uint16_t>(y)});
    std::push_heap(heap_.begin(), heap_.end());
  };
  nodes_[moves_.index(start)] = {0, mark};
  push(moves_.index(start), start.x, start.y, 0);
  while (!heap_.empty()) {
    const Item item = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    if (item.index == goal_index) return Outcome::reached;
    const auto bound = static_cast<std::uint32_t>(item.key >> 32);
    if (bound > kCostLimit) return Outcome::overflow;
    const std::uint32_t cost = bound - static_cast<std::uint32_t>(item.key);
    if (cost > nodes_[item.index].cost) continue;  // improved since it was put in
    for (unsigned mask = moves_.moves(item.index); mask != 0; mask &= mask - 1) {
      const auto k = static_cast<unsigned>(std::countr_zero(mask));
      const auto next_index = item.index + static_cast<std::uint32_t>(offsets[k]);
      const std::uint32_t next_cost = cost + (k < 4 ? costs.straight : costs.diagonal);
      Node& next = nodes_[next_index];
      if ((next.state & ~std::uint32_t{7}) == mark && next.cost <= next_cost) continue;
      next = {next_cost, mark | k};
      push(next_index, item.x + kMoveX[k], item.y + kMoveY[k], next_cost);
    }
  }
  return Outcome::unreachable;
}

}  // namespace

std::unique_ptr<QueryPlanner> heap_astar(const Grid& grid) {
  return std::make_unique<HeapAStar>(grid);
}

}  // namespace lasius::peers
