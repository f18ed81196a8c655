// A solid of a link or an obstacle, prepared for measuring distances.
#pragma once

#include <memory>

#include "core/arm/convex.h"
#include "core/arm/mesh_tree.h"

namespace lasius::arm {

/// A ball around all points of a thing, metres.
struct Ball {
  Vec3 centre;
  double radius = 0;
};

/// Between the balls' surfaces, negative where they meet.
inline double gap_between(const Ball& a, const Ball& b) noexcept {
  return distance(a.centre, b.centre) - a.radius - b.radius;
}

/// Precondition: a solid that `validate` accepts.
class Part {
 public:
  explicit Part(const Solid& solid);

  /// The part in the world, by the place of its body.
  struct Placed {
    const Part* part = nullptr;
    Placement pose;
    Segment axis;  // of a sphere or capsule
    Ball ball;
  };
  Placed place(const Placement& body) const noexcept;

 private:
  friend double distance_between(const Placed& a, const Placed& b, double enough) noexcept;

  /// All points within `radius_` of a point or segment.
  bool round() const noexcept {
    return shape_ == Solid::Shape::sphere || shape_ == Solid::Shape::capsule;
  }
  Block block(const Placement& at) const noexcept;
  double distance_to(const Segment& axis, double limit) const noexcept;
  static double distance_to(const Placed& round, const Placed& other, double enough) noexcept;

  Solid::Shape shape_;
  Placement pose_;
  Segment axis_;
  Vec3 half_;      // of a box, of a cylinder along its axis
  double radius_;  // but of a box and a mesh
  Ball ball_;      // in its own frame, of which only a mesh's is not about 0
  std::shared_ptr<const MeshTree> mesh_;
};

/// Between two parts where that is below `enough`, else a value from `enough` up to the distance.
double distance_between(const Part::Placed& a, const Part::Placed& b, double enough) noexcept;

}  // namespace lasius::arm
