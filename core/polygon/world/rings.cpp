#include "core/polygon/world/rings.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/polygon/world/lattice_point.h"

namespace lasius::polygon {

double doubled_area(const Ring& ring) noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += (a.x - ring[0].x) * (b.y - ring[0].y) - (a.y - ring[0].y) * (b.x - ring[0].x);
  }
  return sum;
}

Bounds bounds_of(const Ring& ring) noexcept {
  Bounds box{ring[0], ring[0]};
  for (const Point p : ring) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

std::vector<const Ring*> rings_of(const Polygon& polygon) {
  std::vector<const Ring*> rings{&polygon.outer};
  for (const Ring& hole : polygon.holes) rings.push_back(&hole);
  return rings;
}

double distance_to(Point a, Point b, Point p) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double along = squared > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared : 0;
  const double share = std::clamp(along, 0.0, 1.0);
  return distance({a.x + share * dx, a.y + share * dy}, p);
}

bool inside(const Ring& ring, Point p) noexcept {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool between = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
                         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
    const double turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    if (between && turn == 0) return true;
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
  }
  return odd;
}

std::string text(Point p) { return pair_text(p.x, p.y); }

}  // namespace lasius::polygon
