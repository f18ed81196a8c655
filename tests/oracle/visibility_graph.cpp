#include "tests/oracle/visibility_graph.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <queue>
#include <utility>

namespace lasius::oracle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Entry = std::pair<double, int>;
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

}  // namespace

VisibilityGraph::VisibilityGraph(const Grid& grid) : width_(grid.width()), height_(grid.height()) {
  for (int y = -1; y <= height_; ++y) {
    for (int x = -1; x <= width_; ++x) blocked_.push_back(grid.blocked({x, y}));
  }
  for (int y = 0; y <= height_; ++y) {
    for (int x = 0; x <= width_; ++x) {
      Node corner{std::int64_t{kUnit} * x, std::int64_t{kUnit} * y, 0, 0};
      int count = 0;
      for (const int by : {-1, 1}) {
        for (const int bx : {-1, 1}) {
          if (!blocked(bx < 0 ? x - 1 : x, by < 0 ? y - 1 : y)) continue;
          ++count;
          corner.block_x = bx;
          corner.block_y = by;
        }
      }
      if (count == 1) corners_.push_back(corner);
    }
  }
}

// Along a line, which is inside a row or column or between two of them.
bool VisibilityGraph::sees_along(std::int64_t line, std::int64_t from, std::int64_t to,
                                 bool level) const {
  const auto at = [&](int along, int across) {
    return level ? blocked(along, across) : blocked(across, along);
  };
  const int last = static_cast<int>((to + kUnit - 1) / kUnit) - 1;
  const int one = static_cast<int>(line / kUnit), other = line % kUnit != 0 ? one : one - 1;
  for (int i = static_cast<int>(from / kUnit); i <= last; ++i) {
    if (at(i, one) && at(i, other)) return false;
    if (i == last) break;
    // Two diagonal blocks close the line; inside of a row this is the test above.
    if (at(i, one) && at(i + 1, other)) return false;
    if (at(i, other) && at(i + 1, one)) return false;
  }
  return true;
}

bool VisibilityGraph::sees(const Node& a, const Node& b) const {
  if (a.y == b.y) return sees_along(a.y, std::min(a.x, b.x), std::max(a.x, b.x), true);
  if (a.x == b.x) return sees_along(a.x, std::min(a.y, b.y), std::max(a.y, b.y), false);
  // Mirrored so that the segment runs right and down: u = flip_x x, v = flip_y y.
  const int flip_x = a.x < b.x ? 1 : -1;
  const int flip_y = a.y < b.y ? 1 : -1;
  const std::int64_t dx = std::abs(b.x - a.x);
  const std::int64_t dy = std::abs(b.y - a.y);
  const auto hits = [&](std::int64_t u, std::int64_t v) {  // a cell, mirrored
    const std::int64_t x = flip_x > 0 ? u : -u - 1;
    const std::int64_t y = flip_y > 0 ? v : -v - 1;
    return blocked(static_cast<int>(x), static_cast<int>(y));
  };
  const std::int64_t u0 = flip_x * a.x;
  const std::int64_t v0 = flip_y * a.y;
  const auto cell_of = [](std::int64_t n) { return (n - (n % kUnit + kUnit) % kUnit) / kUnit; };
  // From cell to cell: the next line to be crossed, upright (u) or level (v), is the nearer one.
  std::int64_t u = cell_of(u0);
  std::int64_t v = cell_of(v0);
  while (!hits(u, v)) {
    const std::int64_t to_u = ((u + 1) * kUnit - u0) * dy;  // times 1 / (dx dy) along the segment
    const std::int64_t to_v = ((v + 1) * kUnit - v0) * dx;
    if (std::min(to_u, to_v) >= dx * dy) return true;
    if (to_u == to_v) {
      if (hits(u + 1, v) && hits(u, v + 1)) return false;
    }
    if (to_u <= to_v) ++u;
    if (to_v <= to_u) ++v;
  }
  return false;
}

double VisibilityGraph::octile(Cell start, Cell goal) const {
  std::vector<double> g(blocked_.size(), kInfinity);
  const int stride = width_ + 2;
  const int from = (start.y + 1) * stride + start.x + 1;
  const int to = (goal.y + 1) * stride + goal.x + 1;
  if (blocked_[from] != 0 || blocked_[to] != 0) return kInfinity;
  Queue queue;
  g[from] = 0;
  queue.push({0, from});
  while (!queue.empty()) {
    const auto [distance, at] = queue.top();
    queue.pop();
    if (at == to) return distance;
    if (distance > g[at]) continue;
    for (const int dy : {-stride, 0, stride}) {
      for (const int dx : {-1, 0, 1}) {
        if (blocked_[at + dx] != 0 || blocked_[at + dy] != 0 || blocked_[at + dx + dy] != 0) {
          continue;
        }
        const double length = distance + (dx != 0 && dy != 0 ? std::sqrt(2.0) : 1.0);
        if (length >= g[at + dx + dy]) continue;
        g[at + dx + dy] = length;
        queue.push({length, at + dx + dy});
      }
    }
  }
  return kInfinity;
}

// The edge from `a` in direction (dx, dy) neither enters a's block nor points straight away from
// it: only then can a taut path bend round it.
bool VisibilityGraph::along(const Node& a, std::int64_t dx, std::int64_t dy) {
  return dx * a.block_x * dy * a.block_y <= 0;
}

// Going on from u, reached from p, bends towards u's block or not at all.
bool VisibilityGraph::taut(const Node& p, const Node& u, const Node& v) {
  const std::int64_t dx = u.x - p.x;
  const std::int64_t dy = u.y - p.y;
  const std::int64_t turn = dx * (v.y - u.y) - dy * (v.x - u.x);
  const std::int64_t block = dx * u.block_y - dy * u.block_x;
  return block > 0 ? turn >= 0 : turn <= 0;
}

// Of king's moves between cells that the ends touch, and ways to their centres.
double VisibilityGraph::known(const Node& from, const Node& to) const {
  const auto touched = [](const Node& at) {
    std::vector<Cell> cells;
    for (const std::int64_t y : {(at.y + kUnit - 1) / kUnit - 1, at.y / kUnit})
      for (const std::int64_t x : {(at.x + kUnit - 1) / kUnit - 1, at.x / kUnit})
        cells.push_back({static_cast<int>(x), static_cast<int>(y)});
    return cells;
  };
  double least = kInfinity;
  for (const Cell a : touched(from))
    for (const Cell b : touched(to))
      least = std::min(least, a == b && !blocked(a.x, a.y) ? 0 : octile(a, b));
  return kUnit * (least + 2) * (1 + 1e-9);
}

std::optional<Shortest> VisibilityGraph::shortest(Point start, Point goal) const {
  const auto units = [](double v) { return static_cast<std::int64_t>(std::llround(v * kUnit)); };
  const Node from{units(start.x), units(start.y), 0, 0}, to{units(goal.x), units(goal.y), 0, 0};
  // No path leaves the ellipse of a known one, so neither do edges worth a look.
  const double bound = known(from, to);
  if (bound == kInfinity) return std::nullopt;
  const int count = static_cast<int>(corners_.size());
  const int goal_node = count + 1;
  std::vector<Node> nodes = corners_;
  nodes.push_back(from);
  nodes.push_back(to);

  const auto distance = [&](int a, int b) {
    const auto dx = static_cast<double>(nodes[a].x - nodes[b].x);
    const auto dy = static_cast<double>(nodes[a].y - nodes[b].y);
    return std::sqrt(dx * dx + dy * dy);
  };
  std::vector<double> g(nodes.size(), kInfinity);
  std::vector<double> h(nodes.size());
  for (int i = 0; i <= goal_node; ++i) h[i] = distance(i, goal_node);
  std::vector<int> parent(nodes.size(), -1);
  std::vector<char> closed(nodes.size(), 0);
  Queue queue;
  g[count] = 0;
  queue.push({h[count], count});
  while (!queue.empty()) {
    const int u = queue.top().second;
    queue.pop();
    if (u == goal_node) break;
    if (std::exchange(closed[u], 1) != 0) continue;
    for (int v = 0; v <= goal_node; ++v) {
      const std::int64_t dx = nodes[v].x - nodes[u].x;
      const std::int64_t dy = nodes[v].y - nodes[u].y;
      if (closed[v] != 0 || !along(nodes[u], dx, dy) || !along(nodes[v], -dx, -dy)) continue;
      if (parent[u] >= 0 && !taut(nodes[parent[u]], nodes[u], nodes[v])) continue;
      const double length = g[u] + distance(u, v);
      if (length >= g[v] || length + h[v] > bound || !sees(nodes[u], nodes[v])) continue;
      g[v] = length;
      parent[v] = u;
      queue.push({length + h[v], v});
    }
  }
  if (g[goal_node] == kInfinity) return std::nullopt;
  std::vector<Point> path;
  for (int i = goal_node; i >= 0; i = parent[i])
    path.push_back(
        {static_cast<double>(nodes[i].x) / kUnit, static_cast<double>(nodes[i].y) / kUnit});
  std::reverse(path.begin(), path.end());
  return Shortest{g[goal_node] / kUnit, std::move(path)};
}

}  // namespace lasius::oracle
