#include "core/polygon/arcs.h"

#include <algorithm>
#include <cmath>

#include "core/polygon/spatial_index.h"
#include "core/polygon/world/rings.h"

namespace lasius::polygon {
namespace {

constexpr double kLeastExcess = 0.005, kMostExcess = 1.0;  // of the margin

Point at(const Ring& ring, std::size_t i) { return ring[i < ring.size() ? i : i - ring.size()]; }

Ring arc_of(const Ring& ring, std::size_t i, double margin, double excess) {
  const Point from = normal(ring, i > 0 ? i - 1 : ring.size() - 1), to = normal(ring, i);
  const double turn = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
  Ring points;
  if (!(turn > 0)) return points;
  const int steps = static_cast<int>(std::ceil(turn / (2 * std::acos(1 / (1 + excess)))));
  const double step = turn / steps, reach = margin / std::cos(step / 2);
  for (int k = 0; k < steps; ++k) {
    const double angle = (k + 0.5) * step;
    const double c = reach * std::cos(angle), s = reach * std::sin(angle);
    points.push_back({ring[i].x + c * from.x - s * from.y, ring[i].y + s * from.x + c * from.y});
  }
  return points;
}

double turn(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double apart(Point a, Point b, Point c, Point d) {
  if ((turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0))
    return 0;
  return std::min(
      {distance_to(a, b, c), distance_to(a, b, d), distance_to(c, d, a), distance_to(c, d, b)});
}

/// Looks for corners whose few tangents could reach what grows elsewhere.
class CrowdedCorners {
 public:
  CrowdedCorners(const std::vector<Ring>& rings, const Arcs& arcs, double margin)
      : rings_(rings), arcs_(arcs), margin_(margin), index_(empty_index()) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      for (std::size_t i = 0; i < rings[r].size(); ++i) {
        index_.add(static_cast<int>(places_.size()), rounded(rings[r][i]),
                   rounded(at(rings[r], i + 1)));
        places_.push_back({r, i});
      }
    }
  }

  bool crowded(std::size_t r, std::size_t i) const {
    const Ring mine = outline(r, i);
    const std::size_t count = rings_[r].size(), before = i > 0 ? i - 1 : count - 1;
    bool found = false;
    const double reach = 2 * margin_ * (1 + kMostExcess);
    index_.within(rounded(rings_[r][i]), reach + 1, [&](int number) {
      if (found) return;
      const auto [ring, edge] = places_[number];
      if (ring == r && (edge == i || edge == before)) return;
      found = nearer(mine, {rings_[ring][edge], at(rings_[ring], edge + 1)}, margin_);
      for (const std::size_t corner : {edge, edge + 1 < rings_[ring].size() ? edge + 1 : 0}) {
        const bool beside =
            ring == r && (corner == i || corner == before || corner == (i + 1 < count ? i + 1 : 0));
        if (found || beside || arcs_[ring][corner].empty()) continue;
        found = nearer(mine, outline(ring, corner), 0);
      }
    });
    return found;
  }

 private:
  struct Place {
    std::size_t ring, corner;
  };

  static LatticePoint rounded(Point p) { return {std::llrint(p.x), std::llrint(p.y)}; }

  SpatialIndex empty_index() const {
    Bounds box = bounds_of(rings_.front());
    std::size_t count = 0;
    for (const Ring& ring : rings_) {
      const Bounds one = bounds_of(ring);
      box.low = {std::min(box.low.x, one.low.x), std::min(box.low.y, one.low.y)};
      box.high = {std::max(box.high.x, one.high.x), std::max(box.high.y, one.high.y)};
      count += ring.size();
    }
    return {rounded(box.low), rounded(box.high), count};
  }

  /// From the end of one edge's growth to the start of the next one's.
  Ring outline(std::size_t r, std::size_t i) const {
    const Ring& ring = rings_[r];
    const Point from = normal(ring, i > 0 ? i - 1 : ring.size() - 1), to = normal(ring, i);
    Ring line{{ring[i].x + margin_ * from.x, ring[i].y + margin_ * from.y}};
    line.insert(line.end(), arcs_[r][i].begin(), arcs_[r][i].end());
    line.push_back({ring[i].x + margin_ * to.x, ring[i].y + margin_ * to.y});
    return line;
  }

  /// Whether two lines come nearer than that, a hair more to be safe.
  bool nearer(const Ring& a, const Ring& b, double than) const {
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      for (std::size_t j = 0; j + 1 < b.size(); ++j)
        if (apart(a[i], a[i + 1], b[j], b[j + 1]) < than + 1e-6 * margin_) return true;
    }
    return false;
  }

  const std::vector<Ring>& rings_;
  const Arcs& arcs_;
  double margin_;
  std::vector<Place> places_;  // of edges, by number
  SpatialIndex index_;
};

}  // namespace

Point normal(const Ring& ring, std::size_t i) {
  const Point a = ring[i], b = at(ring, i + 1);
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  return {(b.y - a.y) / length, (a.x - b.x) / length};
}

Arcs arcs_of(const std::vector<Ring>& rings, double margin, Tangents tangents) {
  const double excess = tangents == Tangents::few ? kMostExcess : kLeastExcess;
  Arcs arcs;
  for (const Ring& ring : rings) {
    auto& of_ring = arcs.emplace_back();
    for (std::size_t i = 0; i < ring.size(); ++i)
      of_ring.push_back(arc_of(ring, i, margin, excess));
  }
  if (tangents == Tangents::many || rings.empty()) return arcs;
  const CrowdedCorners few(rings, arcs, margin);
  Arcs result = arcs;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      if (!arcs[r][i].empty() && few.crowded(r, i))
        result[r][i] = arc_of(rings[r], i, margin, kLeastExcess);
    }
  }
  return result;
}

}  // namespace lasius::polygon
