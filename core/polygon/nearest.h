// Where points lie in free space, and the points of free space nearest to others.
#pragma once

#include <functional>
#include <optional>

#include "core/polygon/regions.h"
#include "core/polygon/route.h"

namespace lasius::polygon {

/// True for regions that count; empty: all do.
using RegionFilter = std::function<bool(int region)>;

/// A point's place, no region where it is not free. On the grid a point of the border may fall just
/// outside: then the free point of the grid that is nearest to it stands for it.
Place place_in(const Regions& regions, Point p, const RegionFilter& counts = {});

/// Whether two places lie in one piece of free space.
bool joined(const Regions& regions, const Place& start, const Place& goal);

/// The point of free space nearest to one that is not free, in a world with this boundary; nothing
/// where all is blocked.
std::optional<Point> nearest_point(const FreeSpace& space, const Ring& boundary, Point p);

/// A distance whose square may be more than doubles hold.
double far_distance(Point a, Point b) noexcept;

/// The point nearest to p of the pieces of free space that hold `from`, as a place. Precondition:
/// `from` lies in some, and p in none of them.
Place nearest_joined(const Regions& regions, const Ring& boundary, const Place& from, Point p);

}  // namespace lasius::polygon
