// What the links of a URDF file are made of.
#pragma once

#include <cstddef>
#include <vector>

#include "core/arm/robot/urdf_file.h"
#include "core/arm/robot/vec3.h"

namespace lasius::arm {

/// Lengths and turns as urdfdom has them, in a fixed order.
Placement placement(const urdf::Pose& pose);
inline Vec3 vec(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

/// Reads the solids of links one after another.
class LinkGeometry {
 public:
  LinkGeometry(const UrdfFile& source, const Chain& chain) : source_(source), chain_(chain) {}

  /// Of a link at `at` in its body; meshes are read, their files and what is odd of
  /// them added to `robot`.
  /// @throws Error for geometry that is less than it should be: it would not collide.
  std::vector<Solid> read(const urdf::Link& link, const Placement& at, Robot& robot);

 private:
  Solid solid(const urdf::Geometry& shape, const urdf::Link& link, Robot& robot);
  Solid mesh(const urdf::Mesh& mesh, const urdf::Link& link, Robot& robot);

  const UrdfFile& source_;
  const Chain& chain_;
  std::size_t triangles_ = 0;
};

}  // namespace lasius::arm
