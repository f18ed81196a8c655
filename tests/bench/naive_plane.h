// Shortest paths in the plane the naive way: every cell and every pair of corners is looked at.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "lasius/grid.h"

namespace lasius::naive {

/// A point in half cells: cell centres are odd, lattice points even.
struct HalfPoint {
  std::int64_t x, y;
};

inline bool blocked_at(const Grid& g, std::int64_t x, std::int64_t y) {
  return g.blocked({static_cast<int>(x), static_cast<int>(y)});
}

/// Which side of the line p -> q the point is on.
inline std::int64_t side(HalfPoint p, HalfPoint q, std::int64_t x, std::int64_t y) {
  return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
}

/// True when the segment p - q keeps the rule of lasius/path.h. Both ends are taken to be legal
/// places; squeezing is judged at lattice points strictly inside.
inline bool segment_free(const Grid& g, HalfPoint p, HalfPoint q) {
  const auto [x0, x1] = std::minmax(p.x, q.x);
  const auto [y0, y1] = std::minmax(p.y, q.y);
  for (std::int64_t r = y0 / 2 - 1; 2 * r <= y1; ++r) {
    for (std::int64_t c = x0 / 2 - 1; 2 * c <= x1; ++c) {
      if (!blocked_at(g, c, r)) continue;
      const std::int64_t l = 2 * c, t = 2 * r;
      if (x1 <= l || x0 >= l + 2 || y1 <= t || y0 >= t + 2) continue;
      const std::int64_t s[4] = {side(p, q, l, t), side(p, q, l + 2, t), side(p, q, l, t + 2),
                                 side(p, q, l + 2, t + 2)};
      const auto [least, most] = std::minmax_element(s, s + 4);
      if (*least < 0 && *most > 0) return false;
    }
  }
  if (p.x == q.x && p.x % 2 == 0) {
    for (std::int64_t y = y0; y < y1; ++y) {
      if (blocked_at(g, p.x / 2 - 1, y / 2) && blocked_at(g, p.x / 2, y / 2)) return false;
    }
  }
  if (p.y == q.y && p.y % 2 == 0) {
    for (std::int64_t x = x0; x < x1; ++x) {
      if (blocked_at(g, x / 2, p.y / 2 - 1) && blocked_at(g, x / 2, p.y / 2)) return false;
    }
  }
  for (std::int64_t y = (y0 + 1) / 2; 2 * y <= y1; ++y) {
    for (std::int64_t x = (x0 + 1) / 2; 2 * x <= x1; ++x) {
      if (side(p, q, 2 * x, 2 * y) != 0) continue;
      if ((2 * x == p.x && 2 * y == p.y) || (2 * x == q.x && 2 * y == q.y)) continue;
      // Two diagonal blocks always stop a line through their common corner.
      if (blocked_at(g, x - 1, y - 1) && blocked_at(g, x, y)) {
        if (!blocked_at(g, x, y - 1) && !blocked_at(g, x - 1, y)) return false;
      }
      if (blocked_at(g, x, y - 1) && blocked_at(g, x - 1, y)) {
        if (!blocked_at(g, x - 1, y - 1) && !blocked_at(g, x, y)) return false;
      }
    }
  }
  return true;
}

/// Length of the shortest path between the centres of two free cells; infinity without one.
inline double shortest(const Grid& g, Cell start, Cell goal) {
  std::vector<HalfPoint> points = {{2 * start.x + 1, 2 * start.y + 1},
                                   {2 * goal.x + 1, 2 * goal.y + 1}};
  for (int y = 0; y <= g.height(); ++y) {
    for (int x = 0; x <= g.width(); ++x) {
      const int blocks = g.blocked({x - 1, y - 1}) + g.blocked({x, y - 1}) + g.blocked({x - 1, y}) +
                         g.blocked({x, y});
      if (blocks == 1) points.push_back({2 * x, 2 * y});
    }
  }
  // Dijkstra over all pairs that see each other.
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<double> cost(points.size(), inf);
  std::vector<bool> done(points.size(), false);
  cost[0] = 0;
  for (;;) {
    std::size_t u = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!done[i] && cost[i] < inf && (u == points.size() || cost[i] < cost[u])) u = i;
    }
    if (u == points.size() || u == 1) return cost[1];
    done[u] = true;
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (done[v]) continue;
      const double d = std::hypot(static_cast<double>(points[v].x - points[u].x),
                                  static_cast<double>(points[v].y - points[u].y)) /
                       2;
      if (cost[u] + d < cost[v] && segment_free(g, points[u], points[v])) cost[v] = cost[u] + d;
    }
  }
}

}  // namespace lasius::naive
