#include "bench/peers/dstar_lite.h"

#include <algorithm>
#include <limits>

#include "bench/peers/octile_costs.h"

namespace lasius::peers {
namespace {

constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();
constexpr OctileCosts kCosts = kOctileCosts[1];

constexpr std::uint32_t plus(std::uint32_t a, std::uint32_t b) noexcept {
  return a == kFar || b == kFar ? kFar : a + b;
}

}  // namespace

DStarLite::DStarLite(Grid map, Cell robot, Cell goal)
    : map_(std::move(map)),
      moves_(map_),
      robot_(moves_.index(robot)),
      goal_(moves_.index(goal)),
      nodes_(moves_.size(), Node{kFar, kFar, 0}),
      heap_(1) {
  nodes_[goal_].rhs = 0;
  update(goal_);
}

template <class Visit>
void DStarLite::each_move(Index from, const Visit& visit) const {
  for (unsigned k = 0; k < 8; ++k) {
    if ((moves_.moves(from) >> k & 1) == 0) continue;
    visit(static_cast<Index>(static_cast<std::int32_t>(from) + moves_.offsets()[k]),
          k < 4 ? kCosts.straight : kCosts.diagonal);
  }
}

DStarLite::Cost DStarLite::heuristic(Index i) const noexcept {
  const Cell c = moves_.cell(i);
  return kCosts.distance(c.x, c.y, moves_.cell(robot_));
}

DStarLite::Key DStarLite::key(Index i) const noexcept {
  const std::int64_t least = std::min(nodes_[i].g, nodes_[i].rhs);
  return {least + heuristic(i) + km_, least};
}

DStarLite::Cost DStarLite::best_rhs(Index i) const noexcept {
  if (i == goal_) return 0;
  Cost best = kFar;
  each_move(i, [&](Index to, Cost cost) { best = std::min(best, plus(cost, nodes_[to].g)); });
  return best;
}

// UpdateVertex of the paper.
void DStarLite::update(Index i) {
  if (nodes_[i].g != nodes_[i].rhs) {
    set_key(i, key(i));
  } else if (nodes_[i].place != 0) {
    remove(i);
  }
}

void DStarLite::expand(Index u) {
  Node& node = nodes_[u];
  const bool lowered = node.g > node.rhs;
  const Cost before = node.g;
  node.g = lowered ? node.rhs : kFar;
  if (lowered) {
    remove(u);
  } else {
    update(u);
  }
  each_move(u, [&](Index s, Cost cost) {  // moves are legal both ways
    if (s == goal_) return;
    if (lowered) {
      nodes_[s].rhs = std::min(nodes_[s].rhs, plus(cost, node.g));
    } else if (nodes_[s].rhs == plus(cost, before)) {
      nodes_[s].rhs = best_rhs(s);
    }
    update(s);
  });
}

// ComputeShortestPath of the paper.
void DStarLite::search() {
  while (heap_.size() > 1 &&
         (heap_[1].first < key(robot_) || nodes_[robot_].rhs > nodes_[robot_].g)) {
    const auto [old, u] = heap_[1];
    const Key now = key(u);
    if (old < now) {
      set_key(u, now);
    } else {
      expand(u);
    }
  }
}

double DStarLite::plan(Cell robot) {
  // Keys in the heap are of where the robot was; k_m keeps them below those of where it is.
  km_ += kCosts.distance(robot.x, robot.y, moves_.cell(robot_));
  robot_ = moves_.index(robot);
  search();
  const Cost length = nodes_[robot_].rhs;
  return length == kFar ? std::numeric_limits<double>::infinity()
                        : static_cast<double>(length) / kCosts.straight;
}

Cell DStarLite::next() const {
  if (robot_ == goal_) return moves_.cell(robot_);
  Cost best = kFar;
  Index to = robot_;
  each_move(robot_, [&](Index s, Cost cost) {
    const Cost length = plus(cost, nodes_[s].g);
    if (length >= best) return;
    best = length;
    to = s;
  });
  return moves_.cell(to);
}

void DStarLite::observe(std::span<const Cell> cells, bool blocked) {
  for (const Cell c : cells) map_.set_blocked(c, blocked);
  const auto around_each = [&](const auto& renew) {
    for (const Cell c : cells) {
      for (int y = c.y - 1; y <= c.y + 1; ++y) {
        for (int x = c.x - 1; x <= c.x + 1; ++x) {
          if (map_.contains({x, y})) renew(Cell{x, y});
        }
      }
    }
  };
  around_each([&](Cell c) { moves_.renew(map_, c); });
  around_each([&](Cell c) {
    const Index i = moves_.index(c);
    nodes_[i].rhs = best_rhs(i);
    update(i);
  });
}

void DStarLite::put(std::size_t place, const std::pair<Key, Index>& entry) noexcept {
  heap_[place] = entry;
  nodes_[entry.second].place = static_cast<std::uint32_t>(place);
}

void DStarLite::sift_up(std::size_t place) {
  const auto entry = heap_[place];
  for (; place > 1 && entry.first < heap_[place / 2].first; place /= 2)
    put(place, heap_[place / 2]);
  put(place, entry);
}

void DStarLite::sift_down(std::size_t place) {
  const auto entry = heap_[place];
  while (2 * place < heap_.size()) {
    std::size_t child = 2 * place;
    if (child + 1 < heap_.size() && heap_[child + 1].first < heap_[child].first) ++child;
    if (!(heap_[child].first < entry.first)) break;
    put(place, heap_[child]);
    place = child;
  }
  put(place, entry);
}

void DStarLite::remove(Index i) {
  const std::size_t place = nodes_[i].place;
  nodes_[i].place = 0;
  const auto last = heap_.back();
  heap_.pop_back();
  if (place == heap_.size()) return;
  put(place, last);
  sift_up(place);
  sift_down(nodes_[last.second].place);
}

void DStarLite::set_key(Index i, const Key& key) {
  if (nodes_[i].place == 0) {
    heap_.emplace_back(key, i);
    sift_up(heap_.size() - 1);
  } else {
    heap_[nodes_[i].place].first = key;
    sift_up(nodes_[i].place);
    sift_down(nodes_[i].place);
  }
}

}  // namespace lasius::peers
