// Areas by GEOS, for worlds and judges that share nothing with the library.
#pragma once

#include <geos_c.h>

#include <memory>
#include <vector>

#include "lasius/polygon/world.h"

namespace lasius::polygon {

class Areas {
 public:
  struct Destroy {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(context, g); }
  };
  using Area = std::unique_ptr<GEOSGeometry, Destroy>;

  Areas() : context_(GEOS_init_r()) {}
  ~Areas() { GEOS_finish_r(context_); }
  Areas(const Areas&) = delete;
  Areas& operator=(const Areas&) = delete;

  GEOSContextHandle_t context() const { return context_; }
  Area own(GEOSGeometry* g) const { return {g, {context_}}; }

  Area line(const std::vector<Point>& points) const {
    return own(GEOSGeom_createLineString_r(context_, sequence(points, false)));
  }
  Area of(const Polygon& p) const {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : p.holes) holes.push_back(ring(hole));
    return own(GEOSGeom_createPolygon_r(context_, ring(p.outer), holes.data(),
                                        static_cast<unsigned>(holes.size())));
  }
  Area all_of(const std::vector<Polygon>& polygons) const {
    std::vector<GEOSGeometry*> parts;
    for (const Polygon& p : polygons) parts.push_back(of(p).release());
    const Area all = own(GEOSGeom_createCollection_r(context_, GEOS_MULTIPOLYGON, parts.data(),
                                                     static_cast<unsigned>(parts.size())));
    return own(GEOSUnaryUnion_r(context_, all.get()));
  }
  Area both(const Area& a, const Area& b) const {
    return own(GEOSIntersection_r(context_, a.get(), b.get()));
  }
  Area less(const Area& a, const Area& b) const {
    return own(GEOSDifference_r(context_, a.get(), b.get()));
  }
  /// With round joins of four chords a quarter turn, or with mitres.
  Area grown(const Area& a, double by, bool round) const {
    return own(GEOSBufferWithStyle_r(context_, a.get(), by, 4, GEOSBUF_CAP_FLAT,
                                     round ? GEOSBUF_JOIN_ROUND : GEOSBUF_JOIN_MITRE, 5));
  }

  std::vector<Polygon> polygons(const Area& area) const {
    std::vector<Polygon> list;
    for (int i = 0; i < GEOSGetNumGeometries_r(context_, area.get()); ++i) {
      const GEOSGeometry* part = GEOSGetGeometryN_r(context_, area.get(), i);
      if (GEOSGeomTypeId_r(context_, part) != GEOS_POLYGON || GEOSisEmpty_r(context_, part) == 1)
        continue;
      Polygon& p = list.emplace_back();
      p.outer = points(GEOSGetExteriorRing_r(context_, part));
      for (int k = 0; k < GEOSGetNumInteriorRings_r(context_, part); ++k)
        p.holes.push_back(points(GEOSGetInteriorRingN_r(context_, part, k)));
    }
    return list;
  }

 private:
  GEOSCoordSequence* sequence(const std::vector<Point>& points, bool closed) const {
    const auto count = static_cast<unsigned>(points.size() + (closed ? 1 : 0));
    GEOSCoordSequence* s = GEOSCoordSeq_create_r(context_, count, 2);
    for (unsigned i = 0; i < count; ++i) {
      const Point p = points[i % points.size()];
      GEOSCoordSeq_setXY_r(context_, s, i, p.x, p.y);
    }
    return s;
  }
  GEOSGeometry* ring(const Ring& points) const {
    return GEOSGeom_createLinearRing_r(context_, sequence(points, true));
  }
  Ring points(const GEOSGeometry* ring) const {
    const GEOSCoordSequence* s = GEOSGeom_getCoordSeq_r(context_, ring);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(context_, s, &count);
    Ring list(count - 1);
    for (unsigned i = 0; i + 1 < count; ++i)
      GEOSCoordSeq_getXY_r(context_, s, i, &list[i].x, &list[i].y);
    return list;
  }

  GEOSContextHandle_t context_;
};

}  // namespace lasius::polygon
