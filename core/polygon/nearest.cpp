#include "core/polygon/nearest.h"

#include <algorithm>
#include <cmath>

#include "core/base/special_values.h"
#include "core/polygon/world/rings.h"

namespace lasius::polygon {
namespace {

/// The point of a segment nearest to p.
Point nearest_on(Point a, Point b, Point p) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double share = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  if (!(share > 0)) return a;
  return share >= 1 ? b : Point{a.x + share * dx, a.y + share * dy};
}

/// The nearest of the points that it is shown.
class Nearest {
 public:
  Nearest(const Ring& boundary, Point p) : p_(p) {
    const auto [low, high] = bounds_of(boundary);
    q_ = {std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)};
    // Of what is far beyond the world the direction alone counts; products stay finite.
    constexpr double kFar = 1e100;
    const double dx = p.x / 4 - q_.x / 4, dy = p.y / 4 - q_.y / 4;
    const double far = std::max(std::abs(dx), std::abs(dy));
    if (far > kFar) p_ = {q_.x + dx / far * kFar, q_.y + dy / far * kFar};
  }

  void look(Point a, Point b) {
    const Point near = nearest_on(a, b, p_);
    // Squared distances from p, but for that of p from q, the nearest point of the box around the
    // world: else all points would be as near to a p that is far away, by rounding.
    const double dx = near.x - q_.x, dy = near.y - q_.y;
    const double compared = dx * (dx - 2 * (p_.x - q_.x)) + dy * (dy - 2 * (p_.y - q_.y));
    if (!(compared < least_)) return;
    least_ = compared;
    best_ = near;
  }
  const std::optional<Point>& best() const noexcept { return best_; }

 private:
  Point p_, q_;
  double least_ = kInfinity;
  std::optional<Point> best_;
};

}  // namespace

Place place_in(const Regions& regions, Point p, const RegionFilter& counts) {
  Place place{p, regions.space().lattice.nearest(p), {}};
  const double limit = std::ldexp(1.0, 44);
  const Point s = regions.space().lattice.scaled(p);
  if (!(std::abs(s.x) < limit && std::abs(s.y) < limit)) return place;
  constexpr std::int64_t kReach = 2;
  for (std::int64_t reach = 0; reach <= kReach; ++reach) {
    for (std::int64_t dy = -reach; dy <= reach; ++dy) {
      for (std::int64_t dx = -reach; dx <= reach; ++dx) {
        if (std::max(std::abs(dx), std::abs(dy)) != reach) continue;
        const LatticePoint at{place.at.x + dx, place.at.y + dy};
        auto holding = regions.holding(at);
        if (counts) std::erase_if(holding, [&](int region) { return !counts(region); });
        if (!holding.empty()) return {p, at, std::move(holding)};
      }
    }
  }
  return place;
}

bool joined(const Regions& regions, const Place& start, const Place& goal) {
  return std::ranges::any_of(start.regions, [&](int a) {
    return std::ranges::any_of(goal.regions,
                               [&](int b) { return regions.piece(a) == regions.piece(b); });
  });
}

std::optional<Point> nearest_point(const FreeSpace& space, const Ring& boundary, Point p) {
  Nearest nearest(boundary, p);
  for (const Polygon& piece : space.pieces) {
    for (const Ring* ring : rings_of(piece)) {
      for (std::size_t i = 0; i < ring->size(); ++i)
        nearest.look((*ring)[i], (*ring)[i + 1 < ring->size() ? i + 1 : 0]);
    }
  }
  return nearest.best();
}

double far_distance(Point a, Point b) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double most = std::max(std::abs(dx), std::abs(dy));
  if (most < 1e150) return distance(a, b);
  return most * std::sqrt(dx / most * (dx / most) + dy / most * (dy / most));
}

Place nearest_joined(const Regions& regions, const Ring& boundary, const Place& from, Point p) {
  const auto counts = [&](int region) {
    return std::ranges::any_of(
        from.regions, [&](int mine) { return regions.piece(mine) == regions.piece(region); });
  };
  Nearest nearest(boundary, p);
  for (std::size_t r = 0; r < regions.regions().size(); ++r) {
    if (!counts(static_cast<int>(r))) continue;
    const auto& sides = regions.regions()[r].sides;
    const auto at = [&](std::size_t i) {
      return regions.space().point(regions.at(sides[i].corner));
    };
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (sides[i].link < 0) nearest.look(at(i), at(i + 1 < sides.size() ? i + 1 : 0));
  }
  return place_in(regions, *nearest.best(), counts);
}

}  // namespace lasius::polygon
