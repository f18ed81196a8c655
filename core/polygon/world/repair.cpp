#include "core/polygon/world/repair.h"

#include <utility>

#include "core/polygon/world/geometry_check.h"
#include "core/polygon/world/rings.h"

namespace lasius::polygon {
namespace {

/// How often a ring winds around a point. What it goes along to and fro cancels out, also where the
/// point lies on it.
int winding(const Ring& ring, Point p) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const bool rises = b.y > a.y;
    const Point low = rises ? a : b, high = rises ? b : a;
    if ((high.x - low.x) * (p.y - low.y) > (high.y - low.y) * (p.x - low.x))
      turns += rises ? 1 : -1;
  }
  return turns;
}

class Repairer {
 public:
  Repairer(const Geos& geos, bool is_boundary)
      : geos_(geos), context_(geos.context()), is_boundary_(is_boundary) {}

  Repair repaired(Polygon polygon) {
    drop_repeats(polygon.outer);
    const auto outer = enclosed(polygon.outer, !is_boundary_);
    std::vector<Geos::Geometry> parts;
    std::vector<Ring> holes;
    for (Ring& hole : polygon.holes) {
      drop_repeats(hole);
      const auto area = enclosed(hole, is_boundary_);
      for (const Polygon& part : geos_.polygons(area.get())) parts.push_back(geos_.polygon(part));
      if (hole.size() >= 3) holes.push_back(std::move(hole));
    }
    if (polygon.outer.size() < 3) return std::move(repair_);
    const bool has_holes = !holes.empty();
    polygon.holes = std::move(holes);
    const auto taken = merged(std::move(parts));
    const auto left = geos_.own(GEOSDifference_r(context_, outer.get(), taken.get()));
    // Where GEOS makes areas equal to ours, its own are taken: recorded results have those.
    const auto valid = geos_.own(GEOSMakeValid_r(context_, geos_.polygon(polygon).get()));
    repair_.areas = geos_.polygons(valid.get());
    const bool same = GEOSEquals_r(context_, merged_of(repair_.areas).get(), left.get()) == 1;
    if (same && (!is_boundary_ || !has_holes || repair_.areas.size() == 1))
      return std::move(repair_);
    repair_.areas = geos_.polygons(is_boundary_ ? outer.get() : left.get());
    if (is_boundary_) repair_.holes = geos_.polygons(taken.get());
    return std::move(repair_);
  }

 private:
  Geos::Geometry merged(std::vector<Geos::Geometry> parts) const {
    return geos_.own(GEOSUnaryUnion_r(context_, geos_.collection(std::move(parts)).get()));
  }
  Geos::Geometry merged_of(const std::vector<Polygon>& polygons) const {
    std::vector<Geos::Geometry> parts;
    parts.reserve(polygons.size());
    for (const Polygon& p : polygons) parts.push_back(geos_.polygon(p));
    return merged(std::move(parts));
  }

  /// The faces that a ring winds around, merged; notes what is left of it if it is a wall.
  Geos::Geometry enclosed(const Ring& ring, bool is_wall) {
    if (ring.size() < 3) {
      if (is_wall) repair_.lines.push_back(ring);
      return merged({});
    }
    const auto edges = geos_.own(GEOSUnaryUnion_r(context_, geos_.ring(ring).get()));
    GEOSGeometry *cuts = nullptr, *dangles = nullptr, *invalid = nullptr;
    const auto faces =
        geos_.own(GEOSPolygonize_full_r(context_, edges.get(), &cuts, &dangles, &invalid));
    const auto bridges = geos_.own(cuts), spikes = geos_.own(dangles);
    const auto rest = geos_.own(invalid);
    std::vector<Geos::Geometry> parts;
    for (const Polygon& face : geos_.polygons(faces.get())) {
      auto part = geos_.polygon(face);
      const auto within = geos_.own(GEOSPointOnSurface_r(context_, part.get()));
      Point p;
      GEOSGeomGetX_r(context_, within.get(), &p.x);
      GEOSGeomGetY_r(context_, within.get(), &p.y);
      if (winding(ring, p) != 0) parts.push_back(std::move(part));
    }
    auto area = merged(std::move(parts));
    // A line between two faces of a boundary leads to a hole and back.
    if (is_wall) note_lines(GEOSDifference_r(context_, bridges.get(), area.get()));
    note_lines(is_wall ? GEOSDifference_r(context_, spikes.get(), area.get())
                       : GEOSIntersection_r(context_, spikes.get(), area.get()));
    return area;
  }

  void note_lines(GEOSGeometry* made) {
    const auto lines = geos_.lines(geos_.own(made).get());
    repair_.lines.insert(repair_.lines.end(), lines.begin(), lines.end());
  }

  const Geos& geos_;
  GEOSContextHandle_t context_;
  bool is_boundary_;
  Repair repair_;
};

}  // namespace

Repair repaired(const Geos& geos, const Polygon& polygon, bool is_boundary) {
  return Repairer(geos, is_boundary).repaired(polygon);
}

}  // namespace lasius::polygon
