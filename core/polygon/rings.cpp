#include "core/polygon/rings.h"

#include <algorithm>

#include "core/base/number_text.h"

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

std::string text(double value) { return number_text(value); }

std::string text(Point p) { return '(' + text(p.x) + ", " + text(p.y) + ')'; }

}  // namespace lasius::polygon
