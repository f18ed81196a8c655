// The clear point nearest to one that is not.
#include <algorithm>
#include <cmath>

#include "core/base/special_values.h"
#include "core/disc/disc_space.h"

namespace lasius::disc {

struct DiscSpace::Nearest {
  Point from;
  Point best = {};
  double distance = kInfinity;
};

// Offers what of a cell may be nearest: its free box, where no circle covers that point, a corner
// of the box, or a point or an end of one of its arcs.
void DiscSpace::nearest_in(Cell cell, Nearest& nearest) const {
  const Point from = nearest.from;
  const auto offer = [&](Point p) {
    const double distance =
        std::sqrt((p.x - from.x) * (p.x - from.x) + (p.y - from.y) * (p.y - from.y));
    if (!(distance < nearest.distance) || !clear(p)) return;
    nearest.best = p;
    nearest.distance = distance;
  };
  const bool band = in_band(cell);
  const Box whole{1.0 * cell.x, 1.0 * cell.y, cell.x + 1.0, cell.y + 1.0};
  Box box = band ? box_of(walls(cell.x, cell.y), cell.x, cell.y) : whole;
  // Points are the radius away from walls where that is possible.
  const Point middle{0.5 * (box.left + box.right), 0.5 * (box.top + box.bottom)};
  if (box.left > whole.left) box.left = std::min(box.left + kMadeSlack, middle.x);
  if (box.top > whole.top) box.top = std::min(box.top + kMadeSlack, middle.y);
  if (box.right < whole.right) box.right = std::max(box.right - kMadeSlack, middle.x);
  if (box.bottom < whole.bottom) box.bottom = std::max(box.bottom - kMadeSlack, middle.y);
  offer({std::clamp(from.x, box.left, box.right), std::clamp(from.y, box.top, box.bottom)});
  if (!band) return;
  for (const double x : {box.left, box.right}) {
    for (const double y : {box.top, box.bottom}) offer({x, y});
  }
  for (const std::uint32_t number : arcs_at(cell.x, cell.y)) {
    const Arc& arc = arcs_[number];
    const double x = arc.right() * (from.x - arc.x), y = arc.down() * (from.y - arc.y);
    const double size = std::sqrt(x * x + y * y);
    if (x >= 0 && y >= 0 && size > 0 && on_arc(arc, {x / size, y / size})) {
      offer(point_on(arc, {x / size, y / size}, radius_));
    }
    offer(point_on(arc, normal_at(arc.low), radius_));
    offer(point_on(arc, normal_at(arc.high), radius_));
  }
}

std::optional<Point> DiscSpace::way_out(Point p) const {
  Nearest nearest{p};
  const Cell at{std::clamp(static_cast<int>(p.x), 0, map_.width() - 1),
                std::clamp(static_cast<int>(p.y), 0, map_.height() - 1)};
  const auto look = [&](int x, int y) {
    if (map_.contains({x, y}) && blocked_.free({x, y})) nearest_in({x, y}, nearest);
  };
  const int rings = std::max(map_.width(), map_.height());
  for (int ring = 0; ring < rings && ring - 1 <= nearest.distance; ++ring) {
    const int top = std::max(0, at.y - ring), bottom = std::min(map_.height() - 1, at.y + ring);
    for (int y = top; y <= bottom; ++y) {
      const bool edge = y == at.y - ring || y == at.y + ring;
      for (int x = at.x - ring; x <= at.x + ring; x += edge || ring == 0 ? 1 : 2 * ring) look(x, y);
    }
  }
  if (nearest.distance == kInfinity) return std::nullopt;
  return nearest.best;
}

}  // namespace lasius::disc
