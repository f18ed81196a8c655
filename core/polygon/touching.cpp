#include "core/polygon/touching.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "core/polygon/world/lattice_point.h"

namespace lasius::polygon {
namespace {

bool from_left(Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Every point moves to the first from the left that is near enough.
void join_points(std::vector<Point*>& points, double reach) {
  std::ranges::sort(points, [](const Point* a, const Point* b) { return from_left(*a, *b); });
  std::size_t first = 0;
  std::vector<Point> known;  // in that order, no two of them near
  for (Point* const p : points) {
    while (first < known.size() && known[first].x < p->x - reach) ++first;
    const auto at = std::find_if(
        known.begin() + static_cast<std::ptrdiff_t>(first), known.end(),
        [&](Point q) { return std::abs(p->y - q.y) <= reach && distance(*p, q) <= reach; });
    if (at != known.end())
      *p = *at;
    else
      known.push_back(*p);
  }
}

/// Whether p lies beside the edge from a to b, no farther off than `reach`. Exact but for a few
/// roundings of the way from p to the nearer end, so that the other may be far out of the world.
bool beside(Point a, Point b, Point p, double reach) {
  const Point to_a{a.x - p.x, a.y - p.y}, to_b{b.x - p.x, b.y - p.y}, edge{b.x - a.x, b.y - a.y};
  if (to_a.x * edge.x + to_a.y * edge.y >= 0 || to_b.x * edge.x + to_b.y * edge.y <= 0)
    return false;
  // Kahan's difference of products.
  const double second = to_a.y * to_b.x;
  const double cross = std::fma(to_a.x, to_b.y, -second) + std::fma(-to_a.y, to_b.x, second);
  return std::abs(cross) <= reach * std::sqrt(edge.x * edge.x + edge.y * edge.y);
}

/// The ring or line with the points that lie on its edges; `known`: all points from the left.
Ring with_points(const Ring& ring, bool closed, const std::vector<Point>& known, double reach) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!closed && i + 1 == ring.size()) {
      result.push_back(ring[i]);
      break;
    }
    const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    result.push_back(a);
    const auto first = static_cast<std::ptrdiff_t>(result.size());
    const double low = std::min(a.y, b.y) - reach, high = std::max(a.y, b.y) + reach;
    const double last = std::max(a.x, b.x) + reach;
    for (auto p = std::ranges::lower_bound(known, std::min(a.x, b.x) - reach, {}, &Point::x);
         p != known.end() && p->x <= last; ++p) {
      if (p->y < low || p->y > high || *p == a || *p == b) continue;
      if (beside(a, b, *p, reach)) result.push_back(*p);
    }
    const auto along = [&](Point p) {
      return std::tuple((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y), p.x, p.y);
    };
    std::ranges::sort(result.begin() + first, result.end(), {}, along);
  }
  return result;
}

}  // namespace

void join_touching(std::vector<Polygon>& polygons, std::vector<Ring>& lines, double reach) {
  std::vector<Ring*> rings;
  for (Polygon& polygon : polygons) {
    rings.push_back(&polygon.outer);
    for (Ring& hole : polygon.holes) rings.push_back(&hole);
  }
  const std::size_t closed = rings.size();
  for (Ring& line : lines) rings.push_back(&line);
  std::vector<Point*> points;
  for (Ring* ring : rings)
    for (Point& p : *ring) points.push_back(&p);
  join_points(points, reach);
  std::vector<Point> known;
  for (const Point* p : points)
    if (known.empty() || known.back() != *p) known.push_back(*p);
  std::ranges::sort(known, from_left);
  known.erase(std::unique(known.begin(), known.end()), known.end());
  for (std::size_t r = 0; r < rings.size(); ++r)
    *rings[r] = with_points(*rings[r], r < closed, known, reach);
}

}  // namespace lasius::polygon
