// Dijkstra's algorithm (1959) over few nodes, any two of which may be joined.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace lasius::oracle {

inline constexpr double kUnreached = std::numeric_limits<double>::infinity();

/// The nodes' shortest distances, from those that some of them are known to have at most; the
/// others are unreached. Nodes a and b are `between(a, b)` apart where they are `joined(a, b)`.
template <class Between, class Joined>
std::vector<double> shortest_distances(std::vector<double> distances, const Between& between,
                                       const Joined& joined) {
  std::vector<bool> done(distances.size());
  for (;;) {
    std::size_t next = distances.size();
    for (std::size_t i = 0; i < distances.size(); ++i) {
      if (done[i] || std::isinf(distances[i])) continue;
      if (next == distances.size() || distances[i] < distances[next]) next = i;
    }
    if (next == distances.size()) return distances;
    done[next] = true;
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double offer = distances[next] + between(next, i);
      if (offer < distances[i] && joined(next, i)) distances[i] = offer;
    }
  }
}

}  // namespace lasius::oracle
