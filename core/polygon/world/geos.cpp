#include "core/polygon/world/geos.h"

#include <new>

#include "core/base/invalid_parameter.h"

namespace lasius::polygon {
namespace {

using Sequence = Geos::Owned<GEOSCoordSequence, GEOSCoordSeq_destroy_r>;
using Writer = Geos::Owned<GEOSWKTWriter, GEOSWKTWriter_destroy_r>;

void free_text(GEOSContextHandle_t context, char* text) { GEOSFree_r(context, text); }
using Text = Geos::Owned<char, free_text>;

void keep(const char* text, void* said) { *static_cast<std::string*>(said) = text; }

std::vector<GEOSGeometry*> released(std::vector<Geos::Geometry>& parts) {
  std::vector<GEOSGeometry*> raw;
  raw.reserve(parts.size());
  for (Geos::Geometry& part : parts) raw.push_back(part.release());
  return raw;
}

}  // namespace

Geos::Geos() : context_(GEOS_init_r()) {
  if (context_ == nullptr) throw std::bad_alloc();
  GEOSContext_setErrorMessageHandler_r(context_, keep, &said_);
  GEOSContext_setNoticeMessageHandler_r(
      context_, [](const char*, void*) {}, nullptr);
}

Geos::~Geos() { GEOS_finish_r(context_); }

void Geos::fail() const { refuse("GEOS cannot work with this geometry: " + said_, "simplify it"); }

// GEOS takes over the parts of what it makes, also where that fails.

Sequence Geos::sequence(const Ring& points, bool closed) const {
  const auto count = static_cast<unsigned>(points.size());
  auto made = own<Sequence>(GEOSCoordSeq_create_r(context_, count + (closed ? 1 : 0), 2));
  for (unsigned i = 0; i < count + (closed ? 1 : 0); ++i) {
    const Point p = points[i < count ? i : 0];
    GEOSCoordSeq_setXY_r(context_, made.get(), i, p.x, p.y);
  }
  return made;
}

Geos::Geometry Geos::ring(const Ring& points) const {
  return own(GEOSGeom_createLinearRing_r(context_, sequence(points, true).release()));
}

Geos::Geometry Geos::line(const Ring& points) const {
  return own(GEOSGeom_createLineString_r(context_, sequence(points, false).release()));
}

Geos::Geometry Geos::polygon(const Polygon& p) const {
  Geometry shell = ring(p.outer);
  std::vector<Geometry> holes;
  holes.reserve(p.holes.size());
  for (const Ring& hole : p.holes) holes.push_back(ring(hole));
  std::vector<GEOSGeometry*> raw = released(holes);
  return own(GEOSGeom_createPolygon_r(context_, shell.release(), raw.data(),
                                      static_cast<unsigned>(raw.size())));
}

Geos::Geometry Geos::collection(std::vector<Geometry> parts, int type) const {
  std::vector<GEOSGeometry*> raw = released(parts);
  return own(
      GEOSGeom_createCollection_r(context_, type, raw.data(), static_cast<unsigned>(raw.size())));
}

Ring Geos::points(const GEOSGeometry* line) const {
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(context_, line);
  unsigned count = 0;
  GEOSCoordSeq_getSize_r(context_, sequence, &count);
  Ring points(count);
  for (unsigned i = 0; i < count; ++i)
    GEOSCoordSeq_getXY_r(context_, sequence, i, &points[i].x, &points[i].y);
  return points;
}

Ring Geos::ring(const GEOSGeometry* g) const {
  Ring all = points(g);
  if (!all.empty()) all.pop_back();
  return all;
}

std::vector<Ring> Geos::lines(const GEOSGeometry* g) const {
  const int type = GEOSGeomTypeId_r(context_, g);
  if (type == GEOS_POINT || type == GEOS_POLYGON || GEOSisEmpty_r(context_, g) == 1) return {};
  if (type == GEOS_LINESTRING || type == GEOS_LINEARRING) return {points(g)};
  std::vector<Ring> list;
  for (int i = 0; i < GEOSGetNumGeometries_r(context_, g); ++i) {
    for (Ring& line : lines(GEOSGetGeometryN_r(context_, g, i))) list.push_back(std::move(line));
  }
  return list;
}

std::vector<Polygon> Geos::polygons(const GEOSGeometry* g) const {
  std::vector<Polygon> list;
  const int type = GEOSGeomTypeId_r(context_, g);
  if (type == GEOS_POLYGON) {
    if (GEOSisEmpty_r(context_, g) == 1) return list;
    Polygon p{ring(GEOSGetExteriorRing_r(context_, g)), {}};
    const int holes = GEOSGetNumInteriorRings_r(context_, g);
    for (int i = 0; i < holes; ++i) p.holes.push_back(ring(GEOSGetInteriorRingN_r(context_, g, i)));
    list.push_back(std::move(p));
  } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    const int parts = GEOSGetNumGeometries_r(context_, g);
    for (int i = 0; i < parts; ++i) {
      for (Polygon& p : polygons(GEOSGetGeometryN_r(context_, g, i))) list.push_back(std::move(p));
    }
  }
  return list;
}

std::string Geos::write_wkt(const GEOSGeometry* g) const {
  const auto writer = own<Writer>(GEOSWKTWriter_create_r(context_));
  GEOSWKTWriter_setTrim_r(context_, writer.get(), 1);
  GEOSWKTWriter_setRoundingPrecision_r(context_, writer.get(), 17);
  return own<Text>(GEOSWKTWriter_write_r(context_, writer.get(), g)).get();
}

}  // namespace lasius::polygon
