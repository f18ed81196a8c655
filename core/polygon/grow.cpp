#include "core/polygon/grow.h"

#include <algorithm>
#include <utility>

#include "core/polygon/world/rings.h"

namespace lasius::polygon {
namespace {

constexpr double kMitreLimit = 5;
constexpr int kQuadrantSegments = 8;

using BufferParams = Geos::Owned<GEOSBufferParams, GEOSBufferParams_destroy_r>;

/// Lines end in half a circle, or a square where joins are mitres.
Geos::Geometry buffered(const Geos& geos, const Geos::Geometry& area, double margin, Join join) {
  const auto context = geos.context();
  const auto how = geos.own<BufferParams>(GEOSBufferParams_create_r(context));
  GEOSBufferParams_setJoinStyle_r(context, how.get(),
                                  join == Join::mitre   ? GEOSBUF_JOIN_MITRE
                                  : join == Join::bevel ? GEOSBUF_JOIN_BEVEL
                                                        : GEOSBUF_JOIN_ROUND);
  if (join == Join::mitre)
    GEOSBufferParams_setEndCapStyle_r(context, how.get(), GEOSBUF_CAP_SQUARE);
  GEOSBufferParams_setMitreLimit_r(context, how.get(), kMitreLimit);
  GEOSBufferParams_setQuadrantSegments_r(context, how.get(), kQuadrantSegments);
  return geos.own(GEOSBufferWithParams_r(context, area.get(), how.get(), margin));
}

/// What a ring grows by on its right, an edge at a time: the strip along the edge, with the sectors
/// that are swept around its ends where the way turns left. It reaches to the left as well: pieces
/// that only shared an edge would leave slivers between them where corners are rounded.
void append_strips(const Ring& ring, const std::vector<Ring>& arcs, double margin, const Geos& geos,
                   std::vector<Geos::Geometry>& parts) {
  const auto off = [margin](Point p, Point direction) {
    return Point{p.x + margin * direction.x, p.y + margin * direction.y};
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point right = normal(ring, i), left{-right.x / 2, -right.y / 2};
    const std::size_t next = i + 1 < ring.size() ? i + 1 : 0;
    Ring strip{off(ring[i], left), off(ring[next], left)};
    const auto turn = [&](std::size_t corner, bool at_end) {
      const Ring& around = arcs[corner];
      if (around.empty()) return strip.push_back(off(ring[corner], right));
      if (at_end) strip.push_back(ring[corner]);
      strip.insert(strip.end(), around.rbegin(), around.rend());
      if (!at_end) strip.push_back(ring[corner]);
    };
    turn(next, true);
    turn(i, false);
    parts.push_back(geos.polygon({std::move(strip), {}}));
  }
}

/// With what grows on its left.
Ring turned(Ring ring, bool area_inside) {
  if ((doubled_area(ring) > 0) != area_inside) std::ranges::reverse(ring);
  return ring;
}

Geos::Geometry merged(const Geos& geos, std::vector<Geos::Geometry> parts) {
  const auto all = geos.collection(std::move(parts));
  return geos.own(GEOSUnaryUnion_r(geos.context(), all.get()));
}

/// A wall as the outline of an area of no width, there and back.
Ring around(Ring wall) {
  for (std::size_t i = wall.size() - 1; i-- > 1;) wall.push_back(wall[i]);
  return wall;
}

Grown round_grown(const Geos& geos, const Geos::Geometry& obstacles, const std::vector<Ring>& walls,
                  const Ring& boundary, bool shrinks, double margin, Tangents tangents) {
  std::vector<Geos::Geometry> parts, strips;
  std::vector<Ring> rings;
  for (const Polygon& p : geos.polygons(obstacles.get())) {
    rings.push_back(turned(p.outer, true));
    for (const Ring& hole : p.holes) rings.push_back(turned(hole, false));
    parts.push_back(geos.polygon(p));
  }
  for (const Ring& wall : walls) rings.push_back(around(wall));
  rings.push_back(turned(boundary, false));  // also where it stays: few tangents keep off it
  const Arcs arcs = arcs_of(rings, margin, tangents);
  for (std::size_t r = 0; r + 1 < rings.size(); ++r)
    append_strips(rings[r], arcs[r], margin, geos, parts);
  auto inside = geos.polygon({boundary, {}});
  if (shrinks) {
    append_strips(rings.back(), arcs.back(), margin, geos, strips);
    const auto taken = merged(geos, std::move(strips));
    inside = geos.own(GEOSDifferencePrec_r(geos.context(), inside.get(), taken.get(), 1));
  }
  return {merged(geos, std::move(parts)), std::move(inside)};
}

}  // namespace

Grown grow(const Geos& geos, Geos::Geometry obstacles, const std::vector<Ring>& walls,
           const Ring& boundary, double margin, const GrowOptions& options, Tangents tangents) {
  const bool shrinks = options.boundary == Boundary::shrink;
  if (options.join == Join::round)
    return round_grown(geos, obstacles, walls, boundary, shrinks, margin, tangents);
  auto inside = geos.polygon({boundary, {}});
  if (shrinks) inside = buffered(geos, inside, -margin, options.join);
  std::vector<Geos::Geometry> parts;
  parts.reserve(walls.size());
  for (const Ring& wall : walls) parts.push_back(geos.line(wall));
  const auto lines = geos.collection(std::move(parts), GEOS_MULTILINESTRING);
  parts.clear();
  parts.push_back(buffered(geos, obstacles, margin, options.join));
  if (!walls.empty()) parts.push_back(buffered(geos, lines, margin, options.join));
  return {walls.empty() ? std::move(parts[0]) : merged(geos, std::move(parts)), std::move(inside)};
}

}  // namespace lasius::polygon
