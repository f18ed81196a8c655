// A mesh's triangles in a tree of boxes, for the distance to the nearest one.
#pragma once

#include <span>
#include <vector>

#include "core/arm/convex.h"
#include "core/arm/proximity.h"

namespace lasius::arm {

/// The smallest upright box around triangles. Precondition: there are some.
struct Bounds {
  Vec3 low, high;
};
Bounds bounds_of(std::span<const Triangle> triangles) noexcept;

class MeshTree {
 public:
  explicit MeshTree(std::vector<Triangle> triangles);

  /// Distance from the segment to the nearest triangle where that is below `limit`, else `limit`.
  double distance(const Segment& s, double limit) const noexcept;
  /// From a block in this mesh's frame; capped at `limit`, as exact as `distance_between`.
  double distance(const Block& block, double limit) const noexcept;
  /// From another mesh, whose frame is at `pose` in this one's; capped at `limit`.
  double distance(const MeshTree& other, const Placement& pose, double limit) const noexcept;

 private:
  struct Node {
    Vec3 centre, half;
    int first = 0;  // leaf: its first triangle; else: its second child, the first follows the node
    int count = 0;  // triangles of a leaf; 0: not one
  };
  int build(int first, int count);
  /// Lowers `least` to what to_triangle(triangle, least) says of any triangle, but for those in
  /// boxes for which to_box(node, least) says no less.
  template <class ToBox, class ToTriangle>
  void descend(int node, const ToBox& to_box, const ToTriangle& to_triangle,
               double& least) const noexcept;
  void descend(int node, const MeshTree& other, int others, const Placement& pose,
               double& least) const noexcept;

  static constexpr int kLeaf = 4;
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace lasius::arm
