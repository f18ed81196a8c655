// Free space: the boundary less the obstacles as they have grown, on the grid of the world.
#pragma once

#include <map>
#include <vector>

#include "core/polygon/arcs.h"
#include "core/polygon/world/lattice_point.h"
#include "lasius/polygon/plan.h"

namespace lasius::polygon {

/// A corner of free space, a vertex of one of its rings. Free space lies on the left of the way
/// from corner to `next`. Points where rings touch have several corners.
struct Corner {
  LatticePoint at;
  int next = 0;
  int previous = 0;
  bool wall = false;  ///< the edge to `next` is part of a piece's outer ring
};

struct FreeSpace {
  Lattice lattice;
  std::vector<Corner> corners;
  std::vector<Polygon> pieces;            ///< for people: in coordinates of the world
  std::vector<Polygon> obstacles;         ///< as grown and merged, clipped to the boundary
  std::map<LatticePoint, Point> written;  ///< corners of the input, as they were written

  Point point(LatticePoint p) const {
    const auto known = written.find(p);
    return known != written.end() ? known->second : lattice.point(p);
  }
};

/// `growth` names the margin. Without pieces where nothing is left.
FreeSpace make_free_space(const World& world, const GrowOptions& growth, Tangents tangents);

}  // namespace lasius::polygon
