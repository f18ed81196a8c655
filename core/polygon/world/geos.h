// GEOS through its C interface, whose ABI is stable; every handle owned.
#pragma once

#include <geos_c.h>

#include <memory>
#include <string>
#include <vector>

#include "lasius/polygon/world.h"

namespace lasius::polygon {

/// A context of GEOS with the geometries' owner; not shared between threads.
class Geos {
 public:
  Geos();
  ~Geos();
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  template <class T, void (*kDestroy)(GEOSContextHandle_t, T*)>
  struct Destroy {
    GEOSContextHandle_t context = nullptr;
    void operator()(T* handle) const noexcept { kDestroy(context, handle); }
  };
  template <class T, void (*kDestroy)(GEOSContextHandle_t, T*)>
  using Owned = std::unique_ptr<T, Destroy<T, kDestroy>>;
  using Geometry = Owned<GEOSGeometry, GEOSGeom_destroy_r>;

  GEOSContextHandle_t context() const noexcept { return context_; }

  /// Takes over what GEOS returned. @throws Error(invalid_parameter) with what it said, for null.
  template <class Handle = Geometry>
  Handle own(typename Handle::pointer made) const {
    if (made == nullptr) fail();
    return Handle(made, {context_});
  }

  Geometry polygon(const Polygon& p) const;
  /// A closed line.
  Geometry ring(const Ring& points) const;
  Geometry line(const Ring& points) const;
  /// Of polygons, if any, or of what the type says; it takes over the parts.
  Geometry collection(std::vector<Geometry> parts, int type = GEOS_MULTIPOLYGON) const;
  /// All polygons of a geometry; other parts are left out.
  std::vector<Polygon> polygons(const GEOSGeometry* g) const;
  /// All its lines, their points in order; rings of polygons are not among them.
  std::vector<Ring> lines(const GEOSGeometry* g) const;
  std::string write_wkt(const GEOSGeometry* g) const;

  /// What GEOS said last.
  const std::string& said() const noexcept { return said_; }

 private:
  [[noreturn]] void fail() const;
  Owned<GEOSCoordSequence, GEOSCoordSeq_destroy_r> sequence(const Ring& points, bool closed) const;
  Ring points(const GEOSGeometry* line) const;
  Ring ring(const GEOSGeometry* g) const;

  GEOSContextHandle_t context_;
  mutable std::string said_;
};

}  // namespace lasius::polygon
