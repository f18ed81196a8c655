#include "core/disc/labels.h"

#include <algorithm>

namespace lasius::disc {

Curve trace(const DiscSpace& space, const Labels& labels, std::uint32_t last, Normal leaves,
            Point start, Point goal) {
  // Pieces of no length, where circles touch, are left out, and arcs that rounding may turn back.
  constexpr double kNoTurn = 1e-9;
  Curve curve;
  Point to = goal;
  for (std::uint32_t i = last; i != Labels::kStart; i = labels[i].parent) {
    const Label& label = labels[i];
    const Arc& arc = space.arcs()[label.arc];
    const Point off = point_on(arc, leaves, space.radius());
    const Point on = point_on(arc, label.normal, space.radius());
    if (!(off == to)) curve.push_back({.from = off, .to = to});
    const double angle = (label.rising ? 1 : -1) * (leaves.angle() - label.angle);
    if (angle > kNoTurn) {
      const int turn = (arc.right() == arc.down()) == label.rising ? 1 : -1;
      curve.push_back({on, off, turn, {1.0 * arc.x, 1.0 * arc.y}, angle, space.asked_radius()});
    }
    to = angle > kNoTurn ? on : off;
    leaves = label.normal;
  }
  if (!(start == to) || curve.empty()) curve.push_back({.from = start, .to = to});
  std::ranges::reverse(curve);
  return curve;
}

}  // namespace lasius::disc
