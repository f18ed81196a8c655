// The clear point nearest to one that is not.
#include <algorithm>
#include <cmath>

#include "core/base/special_values.h"
#include "core/disc/disc_space.h"
#include "core/grid/rings.h"

namespace lasius::disc {

// What is looked for, and the best so far.
struct DiscSpace::Nearest {
  const DiscSpace& space;
  Point from;
  std::optional<Cell> other;
  const std::function<bool(Point)>& taken;
  Point best = {};
  double distance = kInfinity;
  bool refused = false;  // a clear point that was nearer than the best one then

  bool leads_on(Cell c) const noexcept {
    return space.blocked_.free(c) &&
           (!other || space.components_->connected(space.blocked_, c, *other));
  }
  void offer(Point p) {
    const double far = lasius::distance(from, p);
    if (!(far < distance) || !space.clear(p)) return;
    if (taken && !taken(p)) {
      refused = true;
      return;
    }
    best = p;
    distance = far;
  }
};

// Points are the radius away from walls where that is possible.
DiscSpace::Box DiscSpace::inner_box(Cell cell) const noexcept {
  const Box whole{1.0 * cell.x, 1.0 * cell.y, cell.x + 1.0, cell.y + 1.0};
  if (!in_band(cell)) return whole;
  Box box = box_of(walls(cell.x, cell.y), cell.x, cell.y);
  const Point middle{0.5 * (box.left + box.right), 0.5 * (box.top + box.bottom)};
  if (box.left > whole.left) box.left = std::min(box.left + kMadeSlack, middle.x);
  if (box.top > whole.top) box.top = std::min(box.top + kMadeSlack, middle.y);
  if (box.right < whole.right) box.right = std::max(box.right - kMadeSlack, middle.x);
  if (box.bottom < whole.bottom) box.bottom = std::max(box.bottom - kMadeSlack, middle.y);
  return box;
}

// The same of the ends of arcs, which other circles bound.
Point DiscSpace::end_of(const Arc& arc, double end) const noexcept {
  const auto at = [&](double fraction) { return point_on(arc, normal_at(fraction), radius_); };
  const auto keeps = [&](double fraction) {
    return clearance(at(fraction), radius_) >= radius_ - 0.5 * kMadeSlack;
  };
  double inner = 0.5 * (arc.low + arc.high);
  if (keeps(end) || !keeps(inner)) return at(end);
  for (int halvings = 0; halvings < 48; ++halvings) {
    const double middle = 0.5 * (end + inner);
    (keeps(middle) ? inner : end) = middle;
  }
  return at(inner);
}

// Offers what of a cell may be nearest: its free box, where no circle covers that point, a corner
// of the box, or a point or an end of one of its arcs.
void DiscSpace::nearest_in(Cell cell, Nearest& nearest) const {
  const Point from = nearest.from;
  const Box box = inner_box(cell);
  nearest.offer({std::clamp(from.x, box.left, box.right), std::clamp(from.y, box.top, box.bottom)});
  if (!in_band(cell)) return;
  for (const double x : {box.left, box.right}) {
    for (const double y : {box.top, box.bottom}) nearest.offer({x, y});
  }
  for (const std::uint32_t number : arcs_at(cell.x, cell.y)) {
    const Arc& arc = arcs_[number];
    const double x = arc.right() * (from.x - arc.x), y = arc.down() * (from.y - arc.y);
    const double size = std::sqrt(x * x + y * y);
    if (x >= 0 && y >= 0 && size > 0 && on_arc(arc, {x / size, y / size}))
      nearest.offer(point_on(arc, {x / size, y / size}, radius_));
    for (const double end : {arc.low, arc.high}) {
      if (distance(from, point_on(arc, normal_at(end), radius_)) < nearest.distance)
        nearest.offer(end_of(arc, end));
    }
  }
}

// Offers where a ray enters or leaves what is free, from a place on it on.
void DiscSpace::nearest_along(Point direction, double place, Nearest& nearest) const {
  const Point from = nearest.from;
  const auto at = [&](double t) -> Point {
    return {from.x + t * direction.x, from.y + t * direction.y};
  };
  const auto crosses = [&](double line, double origin, double step) {
    return step == 0 ? kInfinity : (line - origin) / step;
  };
  Cell cell{static_cast<int>(at(place).x), static_cast<int>(at(place).y)};
  while (map_.free(cell) && place < nearest.distance) {
    const double right = crosses(cell.x + (direction.x > 0 ? 1 : 0), from.x, direction.x);
    const double down = crosses(cell.y + (direction.y > 0 ? 1 : 0), from.y, direction.y);
    const double leaves = std::min(right, down);
    const auto offer = [&](double t) {
      if (t >= place - kSlack && t <= leaves + kSlack) nearest.offer(at(t));
    };
    if (nearest.leads_on(cell)) {
      offer(place);
      const Box box = inner_box(cell);
      for (const double x : {box.left, box.right}) offer(crosses(x, from.x, direction.x));
      for (const double y : {box.top, box.bottom}) offer(crosses(y, from.y, direction.y));
      const auto arcs = in_band(cell) ? arcs_at(cell.x, cell.y) : std::span<const std::uint32_t>();
      for (const std::uint32_t number : arcs) {
        const double x = arcs_[number].x - from.x, y = arcs_[number].y - from.y;
        const double along = x * direction.x + y * direction.y;
        const double beside = x * direction.y - y * direction.x;
        const double half = std::sqrt(std::max(0.0, radius_ * radius_ - beside * beside));
        for (const double t : {along - half, along + half}) offer(t);
      }
    }
    place = leaves;
    if (right <= down) cell.x += direction.x > 0 ? 1 : -1;
    if (down <= right) cell.y += direction.y > 0 ? 1 : -1;
  }
}

// Offers what lies on the two rays that pass a corner as near as the point itself is to what is
// blocked: where what is nearest is hidden, the nearest that is not may lie there.
void DiscSpace::nearest_past(Point corner, double clearance, Nearest& nearest) const {
  const double x = corner.x - nearest.from.x, y = corner.y - nearest.from.y;
  const double square = x * x + y * y;
  const double length = std::sqrt(std::max(0.0, square - clearance * clearance));
  for (const double side : {clearance, -clearance}) {
    const Point direction{(x * length - y * side) / square, (y * length + x * side) / square};
    const Point touches{nearest.from.x + length * direction.x,
                        nearest.from.y + length * direction.y};
    const bool inside =
        touches.x >= 0 && touches.y >= 0 && touches.x <= map_.width() && touches.y <= map_.height();
    if (inside && length < nearest.distance && nearest.taken(touches))
      nearest_along(direction, length, nearest);
  }
}

std::optional<Point> DiscSpace::way_out(Point p, Poller& poller, const std::optional<Point>& other,
                                        const std::function<bool(Point)>& taken) const {
  Nearest nearest{*this, p, {}, taken};
  if (other && blocked_.free(cell_at(*other))) nearest.other = cell_at(*other);
  const auto words = static_cast<std::int64_t>(8 * radius_) + 32;  // looked at for a cell
  for_rings(map_, cell_at(p), nearest.distance, poller, [&](Cell c) {
    if (poller.stopped() || !nearest.leads_on(c)) return;
    nearest_in(c, nearest);
    poller.stop_after(words);
  });
  const double own = clearance(p, radius_);
  if (nearest.refused && own > 0) {
    double reach = nearest.distance + own;
    for_rings(map_, cell_at(p), reach, poller, [&](Cell c) {
      int blocked = 0;
      for (const Cell beside : {c, Cell{c.x - 1, c.y}, Cell{c.x, c.y - 1}, Cell{c.x - 1, c.y - 1}})
        blocked += map_.blocked(beside) ? 1 : 0;
      if (blocked != 1 || poller.stop_after(words)) return;
      nearest_past({1.0 * c.x, 1.0 * c.y}, own, nearest);
      reach = nearest.distance + own;
    });
  }
  if (nearest.distance == kInfinity || poller.stopped()) return std::nullopt;
  return nearest.best;
}

}  // namespace lasius::disc
