#include "core/arm/lattice_way.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <queue>

namespace lasius::arm {
namespace {

/// A way to `from` and the move that goes on from there, to be looked at in the order of `total`.
struct QueueEntry {
  double total;         // at least, to a goal
  double so_far;        // to `from`, or where it is `tried` over the move
  std::int64_t number;  // of equals the last comes first
  Node from;
  int move;
  bool tried;
  friend bool operator<(const QueueEntry& a, const QueueEntry& b) {
    return a.total != b.total ? a.total > b.total : a.number < b.number;
  }
};

class WaySearch {
 public:
  WaySearch(Lattice& lattice, Unknown unknown)
      : lattice_(lattice), unknown_(unknown), from_(lattice.nodes()), by_(lattice.nodes()) {}

  KnownWay run(const StopCondition& stop) {
    LatticePoller poller(lattice_, stop, 1024);  // kinematics takes its time
    settle(lattice_.start(), 0, lattice_.least(lattice_.start()));
    while (!queue_.empty()) {
      const QueueEntry entry = queue_.top();
      queue_.pop();
      const Node at = lattice_.to(entry.from, entry.move);
      if (by_[at] != 0 || at == lattice_.start()) continue;
      if (poller.stop_after(1)) return {.cause = poller.cause()};
      double so_far = entry.so_far;
      if (!entry.tried) {
        if (!open(entry.from, entry.move)) continue;
        so_far += lattice_.cost(entry.from, entry.move);
        const double total = std::max(entry.total, so_far + lattice_.least(at));
        if (total > entry.total) {
          queue_.push({total, so_far, number_++, entry.from, entry.move, true});
          continue;
        }
      }
      from_[at] = entry.from;
      by_[at] = static_cast<std::uint8_t>(entry.move + 1);
      if (lattice_.arrived(at)) return {.cost = so_far};
      settle(at, so_far, entry.total);
    }
    return {.cause = lattice_.cut()};
  }

 private:
  bool open(Node v, int move) const {
    return unknown_ == Unknown::is_asked ? lattice_.open(v, move) : lattice_.maybe_open(v, move);
  }

  void settle(Node v, double so_far, double total) {
    const float* guidance = lattice_.guidance(v);
    for (int k = 0; k < lattice_.moves(); ++k) {
      if (!(guidance[k] > 0)) continue;
      const Node next = lattice_.to(v, k);
      if (by_[next] != 0) continue;
      const double least = lattice_.counts_moves() ? so_far + 1 + lattice_.least(next) : 0;
      queue_.push({std::max(total, least), so_far, number_++, v, k, false});
    }
  }

  Lattice& lattice_;
  Unknown unknown_;
  ZeroArray<Node> from_;
  ZeroArray<std::uint8_t> by_;  // the move, from 1; 0: not reached
  std::priority_queue<QueueEntry> queue_;
  std::int64_t number_ = 0;
};

}  // namespace

KnownWay shortest_known_way(Lattice& lattice, Unknown unknown, const StopCondition& stop) {
  return WaySearch(lattice, unknown).run(stop);
}

std::vector<int> straight_moves(const Lattice& lattice) {
  const auto goal = lattice.nearest_target(lattice.start());
  const int count = std::abs(goal[0]) + std::abs(goal[1]) + std::abs(goal[2]);
  std::array<int, 3> done{};
  std::vector<int> moves;
  for (int i = 1; i <= count; ++i) {
    int next = 0;
    double most = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const int all = std::abs(goal[axis]);
      const double behind = static_cast<double>(i) * all / count - done[axis];
      if (done[axis] < all && behind > most) {
        most = behind;
        next = axis;
      }
    }
    ++done[next];
    moves.push_back(2 * next + (goal[next] > 0 ? 0 : 1));
  }
  return moves;
}

}  // namespace lasius::arm
