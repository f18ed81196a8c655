// Free space that walls of no width stand in: edges on the grid, both sides of a wall among them.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/polygon/free_space.h"
#include "core/polygon/world/geos.h"

namespace lasius::polygon {

/// The edges that outlines and walls make on the grid, noded with each other in one go: what
/// touched touches still, so nothing slips between them. Each edge bars the way, whatever it was.
class Arrangement {
 public:
  /// All in grid units, rounded or not; `boundary` and `obstacles` areas, perhaps in several parts.
  Arrangement(const Geos& geos, const Geos::Geometry& boundary, const Geos::Geometry& obstacles,
              const Geos::Geometry& walls);

  /// Pieces of free space, without the walls that part none.
  const std::vector<Polygon>& pieces() const noexcept { return pieces_; }
  /// The two sides of each edge, a ring of two corners each.
  std::vector<Corner> sides() const;
  /// Those of `sides` that bound free space, joined to rings where edges meet, numbered anew.
  std::vector<Corner> free_sides(const std::vector<Corner>& sides) const;

 private:
  using DirectedEdge = std::pair<LatticePoint, LatticePoint>;
  using Prepared = Geos::Owned<const GEOSPreparedGeometry, GEOSPreparedGeom_destroy_r>;

  Prepared prepared(const Geos::Geometry& area) const;
  void add_edges(const Polygon& piece);
  bool inside(LatticePoint p) const;

  const Geos& geos_;
  std::vector<DirectedEdge> edges_;
  std::vector<Polygon> pieces_;
  std::vector<Geos::Geometry> areas_;  // of the pieces
  std::vector<Prepared> prepared_;     // of areas_
  // Edges of pieces, free space on their left; true: an outer ring's.
  std::map<DirectedEdge, bool> along_;
};

}  // namespace lasius::polygon
