#include "core/polygon/free_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/polygon/arrangement.h"
#include "core/polygon/grow.h"
#include "core/polygon/touching.h"
#include "core/polygon/world/geos.h"
#include "core/polygon/world/rings.h"

namespace lasius::polygon {
namespace {

constexpr int kLatticeBits = 42;
/// Points that are so near touch: computed ones are rounded a few times on their way here.
constexpr double kRoundings = 8;
/// In grid units. A wall that has grown by less may have gone in the rounding.
constexpr double kSafeGrowth = 8;

int exponent_of(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  return exponent;
}

/// The grid of a world, and how far apart on it points are that touch. A grid finer than that would
/// tell apart what rounding has parted, and open slits.
std::pair<Lattice, double> lattice_of(const World& world) {
  const auto [low, high] = bounds_of(world.boundary.outer);
  const int size = exponent_of(std::max(high.x - low.x, high.y - low.y));
  const int most = exponent_of(std::max({-low.x, -low.y, high.x, high.y}));
  const double touching = kRoundings * std::ldexp(1.0, most - std::numeric_limits<double>::digits);
  const double spacing = std::max(std::ldexp(1.0, size - kLatticeBits), 2 * touching);
  return {{low.x, low.y, spacing}, touching / spacing};
}

Polygon scaled(const Lattice& lattice, const Polygon& polygon) {
  Polygon result;
  for (const Point p : polygon.outer) result.outer.push_back(lattice.scaled(p));
  for (const Ring& hole : polygon.holes) {
    Ring& ring = result.holes.emplace_back();
    for (const Point p : hole) ring.push_back(lattice.scaled(p));
  }
  return result;
}

/// Adds a ring with free space on its left.
void add_ring(FreeSpace& space, Ring ring, bool outer) {
  if ((doubled_area(ring) > 0) != outer) std::ranges::reverse(ring);
  const int first = static_cast<int>(space.corners.size());
  const int count = static_cast<int>(ring.size());
  for (int i = 0; i < count; ++i) {
    space.corners.push_back({{std::llrint(ring[i].x), std::llrint(ring[i].y)},
                             first + (i + 1) % count,
                             first + (i + count - 1) % count,
                             outer});
  }
}

/// Where rings touch, each way out of the point is paired with the way in that is met first
/// counter-clockwise: between the two lies free space, and nothing else.
void part_touching_rings(std::vector<Corner>& corners) {
  std::map<LatticePoint, std::vector<int>> meetings;
  for (int c = 0; c < static_cast<int>(corners.size()); ++c) meetings[corners[c].at].push_back(c);
  std::vector<std::pair<int, int>> joined;  // corners before and at the point
  for (const auto& [at, group] : meetings) {
    if (group.size() == 1) continue;
    for (const int c : group) {
      const LatticePoint out = corners[corners[c].next].at - at;
      int first = corners[c].previous;
      for (const int other : group) {
        const int before = corners[other].previous;
        // The other side of a wall is met last, after a full turn.
        const LatticePoint last = corners[first].at - at, way = corners[before].at - at;
        if (same_direction(out, way)) continue;
        if (same_direction(out, last) || turns_after(out, way, last)) first = before;
      }
      joined.emplace_back(first, c);
    }
  }
  for (const auto& [before, c] : joined) {
    corners[before].next = c;
    corners[c].previous = before;
  }
}

/// Takes out corners in the middle of a straight edge, unless another ring touches there.
void drop_flat_corners(std::vector<Corner>& corners) {
  std::map<LatticePoint, int> uses;
  for (const Corner& c : corners) ++uses[c.at];
  std::vector<char> dropped(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& c = corners[i];
    const LatticePoint ahead = corners[c.next].at - c.at, back = corners[c.previous].at - c.at;
    if (uses[c.at] > 1 || cross(ahead, back) != 0 || dot(ahead, back) >= 0) continue;
    corners[c.previous].next = c.next;
    corners[c.next].previous = c.previous;
    dropped[i] = 1;
  }
  std::vector<int> place(corners.size());
  int kept = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    place[i] = kept;
    if (dropped[i] == 0) corners[kept++] = corners[i];
  }
  corners.resize(kept);
  for (Corner& c : corners) {
    c.next = place[c.next];
    c.previous = place[c.previous];
  }
}

/// What lies so near to the boundary's box that its growth could reach it.
Geos::Geometry clipped(const Geos& geos, const Geos::Geometry& obstacles, const Ring& boundary,
                       double margin) {
  auto [low, high] = bounds_of(boundary);
  low = {low.x - 4 * margin, low.y - 4 * margin};
  high = {high.x + 4 * margin, high.y + 4 * margin};
  const auto box = geos.polygon({{low, {high.x, low.y}, high, {low.x, high.y}}, {}});
  return geos.own(GEOSIntersection_r(geos.context(), obstacles.get(), box.get()));
}

void remember(FreeSpace& space, const Ring& points) {
  for (const Point at : points) space.written.try_emplace(space.lattice.nearest(at), at);
}
void remember(FreeSpace& space, const Polygon& p) {
  for (const Ring* ring : rings_of(p)) remember(space, *ring);
}

/// The lines as far as they are near the boundary's box. Clipped point by point: what touches is
/// noded later, and once.
Geos::Geometry clipped_lines(const Geos& geos, std::vector<Ring> lines, const Ring& boundary,
                             double margin) {
  std::vector<Geos::Geometry> parts;
  for (Ring& line : lines) {
    line.erase(std::unique(line.begin(), line.end()), line.end());
    if (line.size() > 1) parts.push_back(geos.line(line));
  }
  const auto [low, high] = bounds_of(boundary);
  const double around = std::max({4 * margin, high.x - low.x, high.y - low.y});
  const auto all = geos.collection(std::move(parts), GEOS_MULTILINESTRING);
  return geos.own(GEOSClipByRect_r(geos.context(), all.get(), low.x - around, low.y - around,
                                   high.x + around, high.y + around));
}

/// Coordinates back in the world.
std::vector<Polygon> unscaled(const FreeSpace& space, std::vector<Polygon> list) {
  const auto back = [&](Ring& ring) {
    for (Point& p : ring) p = space.point({std::llrint(p.x), std::llrint(p.y)});
  };
  for (Polygon& p : list) {
    back(p.outer);
    for (Ring& hole : p.holes) back(hole);
  }
  return list;
}

void set_corners(FreeSpace& space, std::optional<Arrangement>& walled,
                 const std::vector<Polygon>& pieces) {
  if (walled) {
    std::vector<Corner> sides = walled->sides();
    part_touching_rings(sides);
    space.corners = walled->free_sides(sides);
  } else {
    for (const Polygon& piece : pieces) {
      add_ring(space, piece.outer, true);
      for (const Ring& hole : piece.holes) add_ring(space, hole, false);
    }
    part_touching_rings(space.corners);
  }
  drop_flat_corners(space.corners);
}

}  // namespace

FreeSpace make_free_space(const World& world, const GrowOptions& growth, Tangents tangents) {
  FreeSpace space;
  const auto [lattice, touching] = lattice_of(world);
  space.lattice = lattice;
  const Geos geos;
  const auto context = geos.context();

  std::vector<Polygon> given{scaled(lattice, world.boundary)};
  for (const Polygon& p : world.obstacles) given.push_back(scaled(lattice, p));
  std::vector<Ring> lines;
  for (const Ring& w : world.walls) lines.push_back(scaled(lattice, {w, {}}).outer);
  const double margin = *growth.margin / lattice.spacing;
  if (margin <= touching)
    join_touching(given, lines, touching);  // else what touches grows together
  const Polygon& wall = given.front();
  std::vector<Geos::Geometry> parts;
  for (std::size_t i = 1; i < given.size(); ++i) parts.push_back(geos.polygon(given[i]));
  for (const Ring& hole : wall.holes) parts.push_back(geos.polygon({hole, {}}));
  Geos::Geometry obstacles = geos.collection(std::move(parts));
  obstacles = geos.own(GEOSUnaryUnion_r(context, obstacles.get()));
  Geos::Geometry boundary = geos.polygon({wall.outer, {}});
  const auto walls = clipped_lines(geos, std::move(lines), wall.outer, margin);
  if (margin > 0) {
    if (tangents == Tangents::few) obstacles = clipped(geos, obstacles, wall.outer, margin);
    auto [more, less] = grow(geos, std::move(obstacles), geos.lines(walls.get()), wall.outer,
                             margin, growth, tangents);
    obstacles = std::move(more);
    boundary = std::move(less);
  }
  std::optional<Arrangement> walled;
  if (!world.walls.empty() && margin < kSafeGrowth)
    walled.emplace(geos, boundary, obstacles, walls);
  // The overlay rounds to whole numbers and stays valid.
  obstacles = geos.own(GEOSIntersectionPrec_r(context, obstacles.get(), boundary.get(), 1));
  // Obstacles that only touch the boundary leave points and lines behind.
  const std::vector<Polygon> inside = geos.polygons(obstacles.get());
  parts.clear();
  for (const Polygon& p : inside) parts.push_back(geos.polygon(p));
  obstacles = geos.collection(std::move(parts));
  const Geos::Geometry free =
      geos.own(GEOSDifferencePrec_r(context, boundary.get(), obstacles.get(), 1));

  const std::vector<Polygon> pieces = walled ? walled->pieces() : geos.polygons(free.get());
  set_corners(space, walled, pieces);
  remember(space, world.boundary);
  for (const Polygon& p : world.obstacles) remember(space, p);
  for (const Ring& w : world.walls) remember(space, w);
  space.pieces = unscaled(space, pieces);
  space.obstacles = unscaled(space, inside);
  return space;
}

}  // namespace lasius::polygon
