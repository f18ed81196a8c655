#include "bench/peers/bucket_astar.h"

#include <algorithm>
#include <bit>
#include <numbers>

#include "bench/peers/octile_costs.h"

namespace lasius::peers {
BucketAStar::BucketAStar(const Grid& grid) : moves_(grid), nodes_(moves_.size(), Node{0, 0}) {
  use_scale(0);
}

void BucketAStar::use_scale(std::size_t scale) {
  scale_ = scale;
  // A bucket is a fifth of a cell wide; the largest rise of a step, 2 sqrt 2, fits the ring.
  bucket_shift_ = static_cast<unsigned>(
      std::max<int>(0, static_cast<int>(std::bit_width(kOctileCosts[scale].straight)) - 3));
}

double BucketAStar::plan(Cell start, Cell goal, std::vector<Point>& path) {
  const double length = plan_cells(start, goal, cells_);
  path.clear();
  for (const Cell c : cells_) path.push_back(centre(c));
  return length;
}

double BucketAStar::plan_cells(Cell start, Cell goal, std::vector<Cell>& cells) {
  cells.clear();
  for (;;) {
    switch (search(start, goal)) {
      case Outcome::reached:
        return trace(start, goal, cells);
      case Outcome::unreachable:
        return kNoPath;
      case Outcome::overflow:
        use_scale(scale_ + 1);
    }
  }
}

BucketAStar::Outcome BucketAStar::search(Cell start, Cell goal) {
  ++stamp_;
  if (stamp_ == std::uint32_t{1} << 28) {
    std::fill(nodes_.begin(), nodes_.end(), Node{0, 0});
    stamp_ = 1;
  }
  for (auto& bucket : buckets_) bucket.clear();
  const std::uint32_t mark = stamp_ << 4;
  const OctileCosts costs = kOctileCosts[scale_];
  const std::uint32_t goal_index = moves_.index(goal);
  const std::uint32_t start_index = moves_.index(start);
  Node* const nodes = nodes_.data();
  const auto offsets = moves_.offsets();
  const unsigned shift = bucket_shift_;

  nodes[start_index] = {0, mark};
  std::uint32_t bucket = costs.distance(start.x, start.y, goal) >> shift;
  const std::uint32_t last_bucket = (kCostLimit >> shift) - kBuckets;
  buckets_[bucket % kBuckets].push_back(
      {start_index, static_cast<std::uint16_t>(start.x), static_cast<std::uint16_t>(start.y)});
  std::uint32_t best = ~std::uint32_t{0};  // cost of the goal so far

  for (std::uint32_t empty = 0; empty < kBuckets;) {
    auto& queue = buckets_[bucket % kBuckets];
    if (queue.empty()) {
      if (best != ~std::uint32_t{0} && best >> shift <= bucket) break;
      if (bucket >= last_bucket) return Outcome::overflow;
      ++bucket;
      ++empty;
      continue;
    }
    empty = 0;
    const Item item = queue.back();
    queue.pop_back();
    Node& node = nodes[item.index];
    if ((node.state & kClosed) != 0) continue;
    const std::uint32_t cost = node.cost;
    if (best != ~std::uint32_t{0} && cost + costs.distance(item.x, item.y, goal) >= best) continue;
    node.state |= kClosed;
    for (unsigned mask = moves_.moves(item.index); mask != 0; mask &= mask - 1) {
      const auto k = static_cast<unsigned>(std::countr_zero(mask));
      const auto next_index = item.index + static_cast<std::uint32_t>(offsets[k]);
      const std::uint32_t next_cost = cost + (k < 4 ? costs.straight : costs.diagonal);
      Node& next = nodes[next_index];
      if ((next.state & ~std::uint32_t{15}) == mark && next.cost <= next_cost) continue;
      next = {next_cost, mark | k};
      const int x = item.x + kMoveX[k], y = item.y + kMoveY[k];
      if (next_index == goal_index) {
        best = next_cost;
      } else {
        buckets_[((next_cost + costs.distance(x, y, goal)) >> shift) % kBuckets].push_back(
            {next_index, static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
      }
    }
  }
  return best != ~std::uint32_t{0} || start == goal ? Outcome::reached : Outcome::unreachable;
}

double BucketAStar::trace(Cell start, Cell goal, std::vector<Cell>& cells) const {
  std::int64_t straight = 0, diagonal = 0;
  Cell c = goal;
  cells.push_back(c);
  while (c != start) {
    const unsigned k = nodes_[moves_.index(c)].state & 7;
    ++(k < 4 ? straight : diagonal);
    c = {c.x - kMoveX[k], c.y - kMoveY[k]};
    cells.push_back(c);
  }
  std::reverse(cells.begin(), cells.end());
  return static_cast<double>(straight) + static_cast<double>(diagonal) * std::numbers::sqrt2;
}

}  // namespace lasius::peers
