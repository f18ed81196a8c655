// Theta* and Lazy Theta*: A* on 8 neighbours whose parents need only be in sight.
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "bench/peers/move_grid.h"
#include "bench/peers/peers.h"
#include "bench/peers/sight.h"

namespace lasius::peers {
namespace {

/// Any-angle paths over cell centres, close to the shortest but not exact. Basic Theta* (Nash,
/// Daniel, Koenig & Felner 2007) looks for sight when a neighbour is generated, Lazy Theta* (Nash,
/// Koenig & Tovey 2010) once, when a cell is expanded. Sight is looked for only where it can
/// shorten, which changes no path.
class ThetaStar final : public QueryPlanner {
 public:
  enum class Kind { basic, lazy };
  ThetaStar(const Grid& grid, Kind kind);
  double plan(Cell start, Cell goal, std::vector<Point>& path) override;

 private:
  struct Node {
    double cost;
    std::uint32_t parent;
    std::uint32_t state;  // 2 * stamp, + 1 when closed
  };
  struct Item {
    double bound, cost;
    std::uint32_t index;
    std::uint16_t x, y;
    bool operator<(const Item& o) const noexcept {
      return bound != o.bound ? bound > o.bound : cost < o.cost;
    }
  };

  template <Kind kKind>
  void expand(const Item& item, Cell goal);
  void find_parent(const Item& item);
  void offer(std::uint32_t index, Cell c, double cost, std::uint32_t parent, Cell goal);

  const Grid* grid_;
  Kind kind_;
  MoveGrid moves_;
  std::vector<Node> nodes_;
  std::vector<Item> heap_;
  std::uint32_t mark_ = 0;
};

double distance(Cell a, Cell b) noexcept {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

ThetaStar::ThetaStar(const Grid& grid, Kind kind)
    : grid_(&grid), kind_(kind), moves_(grid), nodes_(moves_.size(), Node{0, 0, 0}) {}

double ThetaStar::plan(Cell start, Cell goal, std::vector<Point>& path) {
  path.clear();
  heap_.clear();
  mark_ += 2;
  const std::uint32_t start_index = moves_.index(start), goal_index = moves_.index(goal);
  nodes_[start_index] = {0, start_index, mark_};
  heap_.push_back({distance(start, goal), 0, start_index, static_cast<std::uint16_t>(start.x),
                   static_cast<std::uint16_t>(start.y)});
  bool reached = false;
  while (!heap_.empty() && !reached) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Item item = heap_.back();
    heap_.pop_back();
    Node& node = nodes_[item.index];
    if (node.state != mark_ || item.cost > node.cost) continue;  // closed, or improved since
    if (kind_ == Kind::lazy) find_parent(item);
    reached = item.index == goal_index;
    node.state = mark_ + 1;
    if (reached) break;
    kind_ == Kind::lazy ? expand<Kind::lazy>(item, goal) : expand<Kind::basic>(item, goal);
  }
  if (!reached) return kNoPath;
  for (std::uint32_t i = goal_index; i != start_index; i = nodes_[i].parent) {
    path.push_back(centre(moves_.cell(i)));
  }
  path.push_back(centre(start));
  std::reverse(path.begin(), path.end());
  return nodes_[goal_index].cost;
}

void ThetaStar::offer(std::uint32_t index, Cell c, double cost, std::uint32_t parent, Cell goal) {
  nodes_[index] = {cost, parent, mark_};
  heap_.push_back({cost + distance(c, goal), cost, index, static_cast<std::uint16_t>(c.x),
                   static_cast<std::uint16_t>(c.y)});
  std::push_heap(heap_.begin(), heap_.end());
}

// Offers the open neighbours the way over the cell's parent. Theta* looks whether the parent sees
// them, and where not offers the way over the cell; Lazy Theta* takes it that it does.
template <ThetaStar::Kind kKind>
void ThetaStar::expand(const Item& item, Cell goal) {
  const std::uint32_t parent = nodes_[item.index].parent;
  const Cell parent_cell = moves_.cell(parent);
  const double parent_cost = nodes_[parent].cost;
  for (unsigned mask = moves_.moves(item.index); mask != 0; mask &= mask - 1) {
    const auto k = static_cast<unsigned>(std::countr_zero(mask));
    const auto index = item.index + static_cast<std::uint32_t>(moves_.offsets()[k]);
    const Node& next = nodes_[index];
    if (next.state == mark_ + 1) continue;
    const double known = next.state == mark_ ? next.cost : kNoPath;
    const Cell c{item.x + kMoveX[k], item.y + kMoveY[k]};
    // By the triangle inequality the way over the parent is the shorter one.
    const double over_parent = parent_cost + distance(parent_cell, c);
    if (over_parent >= known) continue;
    if (kKind == Kind::lazy || clear_line(*grid_, parent_cell, c)) {
      offer(index, c, over_parent, parent, goal);
      continue;
    }
    const double over_cell = item.cost + (k < 4 ? 1.0 : std::numbers::sqrt2);
    if (over_cell < known) offer(index, c, over_cell, item.index, goal);
  }
}

// Lazy Theta*: the parent was taken to be in sight; where it is not, the best closed neighbour.
void ThetaStar::find_parent(const Item& item) {
  Node& node = nodes_[item.index];
  const Cell here{item.x, item.y};
  if (clear_line(*grid_, moves_.cell(node.parent), here)) return;
  node.cost = kNoPath;
  for (unsigned mask = moves_.moves(item.index); mask != 0; mask &= mask - 1) {
    const auto k = static_cast<unsigned>(std::countr_zero(mask));
    const auto index = item.index + static_cast<std::uint32_t>(moves_.offsets()[k]);
    const Node& next = nodes_[index];
    if (next.state != mark_ + 1) continue;
    const double cost = next.cost + (k < 4 ? 1.0 : std::numbers::sqrt2);
    if (cost >= node.cost) continue;
    node.cost = cost;
    node.parent = index;
  }
}

}  // namespace

std::unique_ptr<QueryPlanner> theta_star(const Grid& grid) {
  return std::make_unique<ThetaStar>(grid, ThetaStar::Kind::basic);
}
std::unique_ptr<QueryPlanner> lazy_theta_star(const Grid& grid) {
  return std::make_unique<ThetaStar>(grid, ThetaStar::Kind::lazy);
}

}  // namespace lasius::peers
