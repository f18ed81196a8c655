// What is seen from a place, region by region.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/polygon/regions.h"

namespace lasius::polygon {

/// Follows cones of sight through the free lines. Keeps its memory; one thread at a time.
class Sight {
 public:
  explicit Sight(const Regions& regions) : regions_(regions) {}

  /// Calls corner(c) for each corner in sight of a place that some regions hold, and region(r,
  /// seen) for each region in sight, where seen(p) tells whether a point of it is; for some more
  /// than once. Not all of them once the poller has said stop.
  template <class Corner, class Region>
  void from(LatticePoint eye, std::span<const int> regions, Poller& poller, const Corner& corner,
            const Region& region) {
    for (const int r : regions) look_around(eye, r, corner, region);
    while (!cones_.empty() && !poller.stopped()) {
      const Cone cone = cones_.back();
      cones_.pop_back();
      poller.stop_after(static_cast<std::int64_t>(regions_.regions()[cone.region].sides.size()));
      look(eye, cone, corner, region);
    }
    cones_.clear();
  }

 private:
  /// What is seen through a link: the part of a region between two rays.
  struct Cone {
    int region;
    int through;  // the link
    LatticePoint left, right;
  };

  /// A region that the eye stands in: all of it is seen.
  template <class Corner, class Region>
  void look_around(LatticePoint eye, int r, const Corner& corner, const Region& region) {
    region(r, [](LatticePoint) { return true; });
    const auto& sides = regions_.regions()[r].sides;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      corner(sides[i].corner);
      const LatticePoint right = regions_.at(sides[i].corner);
      const LatticePoint left = regions_.at(sides[i + 1 < sides.size() ? i + 1 : 0].corner);
      if (sides[i].link < 0 || side(eye, right, left) <= 0) continue;
      cones_.push_back({sides[i].across, sides[i].link, left, right});
    }
  }

  template <class Corner, class Region>
  void look(LatticePoint eye, const Cone& cone, const Corner& corner, const Region& region) {
    const auto seen = [&](LatticePoint p) {
      return side(eye, cone.right, p) >= 0 && side(eye, cone.left, p) <= 0;
    };
    const auto& sides = regions_.regions()[cone.region].sides;
    region(cone.region, seen);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      LatticePoint right = regions_.at(sides[i].corner);
      if (seen(right)) corner(sides[i].corner);
      if (sides[i].link < 0 || sides[i].link == cone.through) continue;
      LatticePoint left = regions_.at(sides[i + 1 < sides.size() ? i + 1 : 0].corner);
      if (side(eye, cone.right, right) < 0) right = cone.right;
      if (side(eye, cone.left, left) > 0) left = cone.left;
      if (side(eye, right, left) <= 0) continue;
      cones_.push_back({sides[i].across, sides[i].link, left, right});
    }
  }

  const Regions& regions_;
  std::vector<Cone> cones_;
};

}  // namespace lasius::polygon
