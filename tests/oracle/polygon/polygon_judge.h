// The shortest path among polygons by brute force, by GEOS alone.
#pragma once

#include <cmath>
#include <vector>

#include "tests/oracle/dense_dijkstra.h"
#include "tests/worlds/areas.h"

namespace lasius::polygon {

/// What is left of a boundary's inside when walls grow. That closes what only touches: so the
/// verdict hangs on no rounding.
class PolygonJudge {
 public:
  /// Walls grow, by mitres, so little that lengths stay what they are.
  PolygonJudge(const Ring& boundary, const std::vector<Polygon>& walls, double touching)
      : free_(areas_.less(areas_.of({boundary, {}}),
                          areas_.grown(areas_.all_of(walls), touching, false))) {
    prepare();
  }
  /// Walls and boundary keep a margin; at corners less than that, by chords of arcs.
  PolygonJudge(double margin, const Ring& boundary, const std::vector<Polygon>& walls)
      : free_(areas_.less(areas_.grown(areas_.of({boundary, {}}), -margin, false),
                          areas_.grown(areas_.all_of(walls), margin, true))) {
    prepare();
  }
  ~PolygonJudge() { GEOSPreparedGeom_destroy_r(areas_.context(), prepared_); }
  PolygonJudge(const PolygonJudge&) = delete;
  PolygonJudge& operator=(const PolygonJudge&) = delete;

  bool sees(Point a, Point b) const {
    const auto line = areas_.line({a, b});
    return GEOSPreparedCovers_r(areas_.context(), prepared_, line.get()) == 1;
  }
  bool free(Point p) const { return sees(p, {p.x, std::nextafter(p.y, INFINITY)}); }

  /// Infinity where there is no way.
  double shortest(Point start, Point goal) {
    corners_[0] = start;
    corners_[1] = goal;
    std::vector<double> known(corners_.size(), oracle::kUnreached);
    known[0] = 0;
    return oracle::shortest_distances(
        std::move(known),
        [&](std::size_t a, std::size_t b) {
          return std::hypot(corners_[b].x - corners_[a].x, corners_[b].y - corners_[a].y);
        },
        [&](std::size_t a, std::size_t b) { return sees(corners_[a], corners_[b]); })[1];
  }

 private:
  void prepare() {
    for (const Polygon& piece : areas_.polygons(free_)) {
      corners_.insert(corners_.end(), piece.outer.begin(), piece.outer.end());
      for (const Ring& hole : piece.holes)
        corners_.insert(corners_.end(), hole.begin(), hole.end());
    }
    prepared_ = GEOSPrepare_r(areas_.context(), free_.get());
  }

  Areas areas_;
  Areas::Area free_;
  const GEOSPreparedGeometry* prepared_ = nullptr;
  std::vector<Point> corners_{{}, {}};  // start and goal first
};

}  // namespace lasius::polygon
