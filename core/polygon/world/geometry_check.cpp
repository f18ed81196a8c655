#include "core/polygon/world/geometry_check.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/special_values.h"
#include "core/polygon/world/rings.h"

namespace lasius::polygon {
namespace {

/// The ring and the edge that are nearest to where GEOS found a fault.
std::string place_of(const Polygon& polygon, Point at) {
  const auto rings = rings_of(polygon);
  double least = kInfinity;
  std::size_t ring = 0, edge = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& points = *rings[r];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = distance_to(points[i], points[(i + 1) % points.size()], at);
      if (!(d < least)) continue;
      least = d;
      ring = r;
      edge = i;
    }
  }
  std::string place = "near " + text(at);
  place += ", on ring " + std::to_string(ring) + " between its points " + std::to_string(edge);
  return place += " and " + std::to_string((edge + 1) % rings[ring]->size());
}

/// `least`: of distinct points.
std::optional<std::string> points_fault(const Ring& ring, std::string which, std::size_t least) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point p = ring[i];
    if (std::abs(p.x) <= kMostCoordinate && std::abs(p.y) <= kMostCoordinate) continue;
    which += " has point " + std::to_string(i) + " at " + text(p);
    return which += ", which is no number within 1e12";
  }
  Ring distinct = ring;
  std::ranges::sort(distinct, [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() >= least) {
    const auto [low, high] = bounds_of(ring);
    if (std::max(high.x - low.x, high.y - low.y) >= kLeastExtent) return std::nullopt;
    return which += ", at " + text(ring[0]) + ", is less than 1e-100 wide";
  }
  which += " has only " + std::to_string(distinct.size()) + " distinct points";
  if (!distinct.empty()) which += ", the first " + text(ring[0]);
  return which;
}

}  // namespace

void drop_repeats(Ring& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

std::optional<std::string> fault(const Geos& geos, const Polygon& polygon) {
  const auto rings = rings_of(polygon);
  for (std::size_t r = 0; r < rings.size(); ++r)
    if (auto wrong = points_fault(*rings[r], "ring " + std::to_string(r), 3)) return wrong;
  const auto context = geos.context();
  const auto geometry = geos.polygon(polygon);
  char* reason = nullptr;
  GEOSGeometry* where = nullptr;
  const char valid = GEOSisValidDetail_r(context, geometry.get(), 0, &reason, &where);
  if (valid == 1) return std::nullopt;
  std::string problem = reason != nullptr ? reason : geos.said();
  GEOSFree_r(context, reason);
  if (where != nullptr) {
    Point at;
    GEOSGeomGetX_r(context, where, &at.x);
    GEOSGeomGetY_r(context, where, &at.y);
    GEOSGeom_destroy_r(context, where);
    problem += ' ';
    problem += place_of(polygon, at);
  }
  return problem;
}

std::optional<std::string> wall_fault(const Ring& line) {
  return points_fault(line, "the line", 2);
}

std::optional<std::string> margin_fault(double margin) {
  if (margin >= 0 && margin <= kMostCoordinate) return std::nullopt;
  return "margin is " + number_text(margin);
}

}  // namespace lasius::polygon
