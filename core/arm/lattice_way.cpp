#include "core/arm/lattice_way.h"

#include <array>
#include <cstdlib>

namespace lasius::arm {

KnownWay shortest_known_way(const Lattice& lattice, Unknown unknown, const StopCondition& stop) {
  // The estimate changes by one with each move, so a point's total is that of the one before it or
  // two more: two stacks make the queue.
  ZeroArray<std::uint8_t> closed(lattice.nodes());
  struct Entry {
    Node at;
    std::int64_t moves;
  };
  std::vector<Entry> now, later;
  now.push_back({lattice.start(), 0});
  LatticePoller poller(lattice, stop, 1024);  // kinematics takes its time
  while (!now.empty() || !later.empty()) {
    if (now.empty()) now.swap(later);
    const Entry entry = now.back();
    now.pop_back();
    if (closed[entry.at] != 0) continue;
    closed[entry.at] = 1;
    if (entry.at == lattice.goal()) return {.moves = entry.moves};
    if (poller.stop_after(1)) return {.cause = poller.cause(), .moves = {}};
    const int left = lattice.manhattan(entry.at);
    for (int k = 0; k < kMoves; ++k) {
      const Node next = lattice.to(entry.at, k);
      if (closed[next] != 0) continue;
      const bool open = unknown == Unknown::is_asked ? lattice.open(entry.at, k)
                                                     : lattice.maybe_open(entry.at, k);
      if (poller.stop_after(0)) return {.cause = poller.cause(), .moves = {}};
      if (!open) continue;
      (lattice.manhattan(next) < left ? now : later).push_back({next, entry.moves + 1});
    }
  }
  return {};
}

std::vector<int> straight_moves(const Lattice& lattice) {
  const auto goal = lattice.coordinates(lattice.goal());
  const int count = lattice.manhattan(lattice.start());
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
