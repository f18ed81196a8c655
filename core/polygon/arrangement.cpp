#include "core/polygon/arrangement.h"

#include <algorithm>
#include <cmath>

#include "core/polygon/world/rings.h"

namespace lasius::polygon {
namespace {

LatticePoint rounded(Point p) { return {std::llrint(p.x), std::llrint(p.y)}; }

/// The outlines of areas, added to lines.
void add_outlines(const Geos& geos, const Geos::Geometry& areas,
                  std::vector<Geos::Geometry>& lines) {
  const auto add = [&](Ring ring) {
    ring.push_back(ring.front());
    lines.push_back(geos.line(ring));
  };
  for (const Polygon& area : geos.polygons(areas.get())) {
    for (const Ring* ring : rings_of(area)) add(*ring);
  }
}

/// To clip by; not the boundary: what ends at it would be cut a hair before.
Geos::Geometry box_around(const Geos& geos, const std::vector<Geos::Geometry>& lines) {
  Point low, high;
  for (const auto& line : lines) {
    const Bounds box = bounds_of(geos.lines(line.get()).front());
    low = {std::min(low.x, box.low.x), std::min(low.y, box.low.y)};
    high = {std::max(high.x, box.high.x), std::max(high.y, box.high.y)};
  }
  const double more = high.x - low.x + high.y - low.y;
  low = {low.x - more, low.y - more};
  high = {high.x + more, high.y + more};
  return geos.polygon({{low, {high.x, low.y}, high, {low.x, high.y}}, {}});
}

}  // namespace

Arrangement::Arrangement(const Geos& geos, const Geos::Geometry& boundary,
                         const Geos::Geometry& obstacles, const Geos::Geometry& walls)
    : geos_(geos) {
  const auto context = geos.context();
  std::vector<Geos::Geometry> lines;
  add_outlines(geos, boundary, lines);
  if (lines.empty()) return;
  const auto around = box_around(geos, lines);
  add_outlines(geos, obstacles, lines);
  for (const Ring& wall : geos.lines(walls.get())) lines.push_back(geos.line(wall));
  const auto all = geos.collection(std::move(lines), GEOS_MULTILINESTRING);
  const auto noded = geos.own(GEOSIntersectionPrec_r(context, all.get(), around.get(), 1));

  std::vector<Geos::Geometry> noded_lines;
  for (const Ring& line : geos.lines(noded.get())) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      edges_.emplace_back(rounded(line[i]), rounded(line[i + 1]));
    noded_lines.push_back(geos.line(line));
  }
  std::vector<const GEOSGeometry*> raw;
  raw.reserve(noded_lines.size());
  for (const auto& line : noded_lines) raw.push_back(line.get());
  const auto faces =
      geos.own(GEOSPolygonize_r(context, raw.data(), static_cast<unsigned>(raw.size())));
  // A sliver may be judged either way: its edges bar the way to it.
  const Prepared room = prepared(boundary), taken = prepared(obstacles);
  for (const Polygon& face : geos.polygons(faces.get())) {
    Geos::Geometry area = geos.polygon(face);
    const auto within = geos.own(GEOSPointOnSurface_r(context, area.get()));
    if (GEOSPreparedIntersects_r(context, room.get(), within.get()) != 1 ||
        GEOSPreparedIntersects_r(context, taken.get(), within.get()) == 1)
      continue;
    add_edges(face);
    pieces_.push_back(face);
    prepared_.push_back(prepared(area));
    areas_.push_back(std::move(area));
  }
}

void Arrangement::add_edges(const Polygon& piece) {
  for (const Ring* ring : rings_of(piece)) {
    const bool outer = ring == &piece.outer, turned = (doubled_area(*ring) > 0) != outer;
    for (std::size_t i = 0; i < ring->size(); ++i) {
      DirectedEdge way{rounded((*ring)[i]), rounded((*ring)[i + 1 < ring->size() ? i + 1 : 0])};
      if (turned) std::swap(way.first, way.second);
      along_[way] = outer;
    }
  }
}

Arrangement::Prepared Arrangement::prepared(const Geos::Geometry& area) const {
  return geos_.own<Prepared>(GEOSPrepare_r(geos_.context(), area.get()));
}

std::vector<Corner> Arrangement::sides() const {
  std::vector<Corner> corners;
  for (const auto& [from, to] : edges_) {
    const int i = static_cast<int>(corners.size());
    corners.push_back({from, i + 1, i + 1, false});
    corners.push_back({to, i, i, false});
  }
  return corners;
}

/// Within a piece, its edges left out.
bool Arrangement::inside(LatticePoint p) const {
  const auto context = geos_.context();
  const auto point = geos_.own(
      GEOSGeom_createPointFromXY_r(context, static_cast<double>(p.x), static_cast<double>(p.y)));
  return std::ranges::any_of(prepared_, [&](const Prepared& piece) {
    return GEOSPreparedContains_r(context, piece.get(), point.get()) == 1;
  });
}

std::vector<Corner> Arrangement::free_sides(const std::vector<Corner>& sides) const {
  const int count = static_cast<int>(sides.size());
  std::vector<char> done(sides.size());
  std::vector<int> place(sides.size(), -1);
  std::vector<Corner> kept;
  for (int first = 0; first < count; ++first) {
    if (done[first] != 0) continue;
    // One side of all edges that hang together. It is free where an edge of a piece is among them,
    // or, walls that stand alone, where they stand within one.
    bool free = false;
    std::vector<int> ring;
    for (int c = first; done[c] == 0; c = sides[c].next) {
      done[c] = 1;
      ring.push_back(c);
      free = free || along_.contains({sides[c].at, sides[sides[c].next].at});
    }
    if (!free && !inside(sides[first].at)) continue;
    for (const int c : ring) {
      place[c] = static_cast<int>(kept.size());
      kept.push_back(sides[c]);
    }
  }
  for (Corner& c : kept) {
    const auto side = along_.find({c.at, sides[c.next].at});
    c.wall = side != along_.end() && side->second && !along_.contains({side->first.second, c.at});
  }
  for (Corner& c : kept) {
    c.next = place[c.next];
    c.previous = place[c.previous];
  }
  return kept;
}

}  // namespace lasius::polygon
