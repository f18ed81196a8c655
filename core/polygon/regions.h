// The convex regions that free lines cut free space into, and who neighbours whom.
#pragma once

#include <vector>

#include "core/base/poller.h"
#include "core/polygon/free_space.h"
#include "core/polygon/link_builder.h"

namespace lasius::polygon {

/// One side of a region, from a corner to the next; the region lies on its left.
struct Side {
  int corner = 0;
  int link = -1;    ///< -1: an edge of free space
  int across = -1;  ///< the region behind the link
};

struct Region {
  std::vector<Side> sides;  ///< counter-clockwise
};

/// Free space cut up; of no use where the poller has said stop.
class Regions {
 public:
  Regions(FreeSpace space, Poller& poller);

  const FreeSpace& space() const noexcept { return space_; }
  const std::vector<Link>& links() const noexcept { return links_; }
  const std::vector<Region>& regions() const noexcept { return regions_; }
  LatticePoint at(int corner) const { return space_.corners[corner].at; }
  /// Regions on the left and the right of the way from a link's a to its b.
  std::pair<int, int> beside(int link) const { return beside_[link]; }
  /// Regions around a corner.
  const std::vector<int>& around(int corner) const { return around_[corner]; }
  /// True for corners that paths bend around.
  bool reflex(int corner) const { return reflex_[corner] != 0; }
  /// Regions that hold a point, border included.
  std::vector<int> holding(LatticePoint p) const;
  /// Pieces of free space; which one a region is part of.
  int pieces() const noexcept { return pieces_; }
  int piece(int region) const { return piece_[region]; }

 private:
  void cut(const LinkBuilder& builder);
  void join_pieces();

  FreeSpace space_;
  std::vector<Link> links_;
  std::vector<Region> regions_;
  std::vector<std::pair<int, int>> beside_;
  std::vector<std::vector<int>> around_;
  std::vector<char> reflex_;
  std::vector<int> piece_;
  int pieces_ = 0;
};

}  // namespace lasius::polygon
