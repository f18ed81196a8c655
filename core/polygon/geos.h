// GEOS through its C interface, whose ABI is stable; every handle owned.
#pragma once

#include <geos_c.h>

#include <memory>
#include <string>
#include <vector>

#include "lasius/polygon.h"

namespace lasius::polygon {

/// A context of GEOS with the geometries' owner; not shared between threads.
class Geos {
 public:
  Geos();
  ~Geos();
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  struct Destroy {
    GEOSContextHandle_t context = nullptr;
    void operator()(GEOSGeometry* g) const noexcept { GEOSGeom_destroy_r(context, g); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

  GEOSContextHandle_t context() const noexcept { return context_; }

  /// Takes over what GEOS returned. @throws std::runtime_error with what GEOS said, for null.
  Geometry own(GEOSGeometry* g) const;

  Geometry polygon(const Polygon& p) const;
  Geometry collection(std::vector<Geometry> parts, int type = GEOS_MULTIPOLYGON) const;
  Geometry empty() const;
  /// All polygons of a geometry; other parts are left out.
  std::vector<Polygon> polygons(const GEOSGeometry* g) const;
  Geometry read_wkt(const std::string& text) const;
  std::string write_wkt(const GEOSGeometry* g) const;

  /// What GEOS said last.
  const std::string& said() const noexcept { return said_; }

 private:
  GEOSGeometry* ring(const Ring& points) const;
  Ring ring(const GEOSGeometry* g) const;

  GEOSContextHandle_t context_;
  mutable std::string said_;
};

}  // namespace lasius::polygon
