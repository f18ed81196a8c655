#include "core/arm/mesh_tree.h"

#include <algorithm>
#include <utility>

#include "core/arm/robot/vec3.h"

namespace lasius::arm {

Bounds bounds_of(std::span<const Triangle> triangles) noexcept {
  Bounds box{triangles[0][0], triangles[0][0]};
  for (const Triangle& triangle : triangles) {
    for (const Vec3 corner : triangle) {
      for (const auto axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        box.low.*axis = std::min(box.low.*axis, corner.*axis);
        box.high.*axis = std::max(box.high.*axis, corner.*axis);
      }
    }
  }
  return box;
}

MeshTree::MeshTree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  if (!triangles_.empty()) build(0, static_cast<int>(triangles_.size()));
}

int MeshTree::build(int first, int count) {
  const auto begin = triangles_.begin() + first, end = begin + count;
  const auto [low, high] = bounds_of({begin, end});
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back({0.5 * (low + high), 0.5 * (high - low), first, count});
  if (count <= kLeaf) return index;

  // Half of them to either side of the median, along the longest side.
  const Vec3 size = high - low;
  const auto axis = size.x >= size.y && size.x >= size.z ? &Vec3::x
                    : size.y >= size.z                   ? &Vec3::y
                                                         : &Vec3::z;
  const auto middle = begin + count / 2;
  std::nth_element(begin, middle, end, [axis](const auto& a, const auto& b) {
    return a[0].*axis + a[1].*axis + a[2].*axis < b[0].*axis + b[1].*axis + b[2].*axis;
  });
  build(first, count / 2);
  const int second = build(first + count / 2, count - count / 2);
  nodes_[index].first = second;
  nodes_[index].count = 0;
  return index;
}

template <class ToBox, class ToTriangle>
void MeshTree::descend(int node, const ToBox& to_box, const ToTriangle& to_triangle,
                       double& least) const noexcept {
  const Node& n = nodes_[node];
  if (to_box(n, least) >= least) return;
  if (n.count > 0) {
    for (int i = n.first; i < n.first + n.count; ++i) {
      least = std::min(least, to_triangle(triangles_[i], least));
    }
    return;
  }
  descend(node + 1, to_box, to_triangle, least);
  descend(n.first, to_box, to_triangle, least);
}

double MeshTree::distance(const Segment& s, double limit) const noexcept {
  double least = limit;
  const auto to_box = [&](const Node& n, double) {
    return distance_to_box({s.from - n.centre, s.to - n.centre}, n.half);
  };
  const auto to_triangle = [&](const Triangle& t, double) { return distance_to_triangle(s, t); };
  if (!nodes_.empty()) descend(0, to_box, to_triangle, least);
  return least;
}

double MeshTree::distance(const Block& block, double limit) const noexcept {
  double least = limit;
  const auto to_box = [&](const Node& n, double most) {
    return distance_between(block, Block{.pose = {.position = n.centre}, .half = n.half}, most);
  };
  const auto to_triangle = [&](const Triangle& t, double most) {
    return distance_between(block, t, most);
  };
  if (!nodes_.empty()) descend(0, to_box, to_triangle, least);
  return least;
}

double MeshTree::distance(const MeshTree& other, const Placement& pose,
                          double limit) const noexcept {
  double least = limit;
  if (!nodes_.empty() && !other.nodes_.empty()) descend(0, other, 0, pose, least);
  return least;
}

void MeshTree::descend(int node, const MeshTree& other, int others, const Placement& pose,
                       double& least) const noexcept {
  const Node &n = nodes_[node], &o = other.nodes_[others];
  const Block box{.pose = {.position = n.centre}, .half = n.half};
  const Block his{.pose = {pose.rotation, pose * o.centre}, .half = o.half};
  if (distance_between(box, his, least) >= least) return;
  if (n.count > 0 && o.count > 0) {
    for (int k = o.first; k < o.first + o.count; ++k) {
      const auto& [a, b, c] = other.triangles_[k];
      const Triangle moved{pose * a, pose * b, pose * c};
      for (int i = n.first; i < n.first + n.count; ++i) {
        least = std::min(least, distance_between(triangles_[i], moved, least));
      }
    }
  } else if (o.count > 0 || (n.count == 0 && length(n.half) >= length(o.half))) {
    descend(node + 1, other, others, pose, least);
    descend(n.first, other, others, pose, least);
  } else {
    descend(node, other, others + 1, pose, least);
    descend(node, other, o.first, pose, least);
  }
}

}  // namespace lasius::arm
