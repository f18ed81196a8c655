// Free MAKLINK lines: which corners of free space are joined so that it falls into convex regions.
#pragma once

#include <vector>

#include "core/base/poller.h"
#include "core/polygon/free_space.h"
#include "core/polygon/spatial_index.h"

namespace lasius::polygon {

/// A free line between two corners, indices of FreeSpace::corners.
struct Link {
  int a = 0;
  int b = 0;
};

/// Draws links by the lecture's rules (E2, after Habib & Asama 1991), all decisions in integers.
///
/// Lines that cross nothing are taken shortest first, those alone that split an angle of free space
/// of more than 180 degrees: corner to corner, or square onto a wall where the foot is exact, that
/// is onto walls along an axis. That leaves convex regions, because a corner with such an angle
/// always sees another corner inside it. Then lines are taken away again, longest first, where
/// both ends stay convex: no line is left without which the regions would be convex too.
class LinkBuilder {
 public:
  /// Feet on walls become corners of `space`. Where the poller says stop, some links are missing.
  LinkBuilder(FreeSpace& space, Poller& poller);

  const std::vector<Link>& links() const noexcept { return links_; }
  /// Links at a corner, counter-clockwise from its `next`.
  const std::vector<std::vector<int>>& fans() const noexcept { return fans_; }

 private:
  struct Candidate {
    double length;
    int from;  // a corner
    int to;    // a corner, or where `wall` holds the foot on the wall from that corner on
    bool wall;
  };
  struct Edge {
    LatticePoint from, to, low, high;
  };
  enum class Sector { closed, convex, reflex };

  LatticePoint at(int corner) const { return space_.corners[corner].at; }
  LatticePoint direction(int link, int corner) const;
  bool reflex(int corner) const;
  Sector sector(int corner, LatticePoint direction) const;
  bool clear(LatticePoint from, LatticePoint to, const Edge* ignored) const;
  bool crossed(LatticePoint from, LatticePoint to, const Edge& edge) const;
  SpatialIndex empty_index() const;

  static Edge edge_between(LatticePoint a, LatticePoint b);
  void draw(double longest);
  void set_edge(int corner);
  std::vector<Candidate> candidates(double above, double upto) const;
  LatticePoint foot(int corner, int wall) const;
  void try_corner(int from, int to);
  void try_wall(int from, int wall);
  void add(int a, int b);
  bool removable(int link, int corner) const;
  void remove_redundant();
  void renumber();

  FreeSpace& space_;
  Poller& poller_;
  std::vector<Link> links_;
  std::vector<std::vector<int>> fans_;
  std::vector<Edge> edges_;  // from each corner to its next
  SpatialIndex corner_index_, edge_index_, link_index_;
  std::vector<int> walls_;  // corners whose edge is a wall along an axis, before any foot
  std::vector<LatticePoint> wall_ends_;
};

}  // namespace lasius::polygon
