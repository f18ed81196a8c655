// Component lasius::arm: manipulators among obstacles that they learn by meeting them.
//
// Lengths are metres, angles radians, times seconds; z is up. A robot is a chain of joints, each
// with the capsules that move with it; obstacles are boxes, spheres, cylinders and meshes.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lasius/arm_export.h"

namespace lasius::arm {

struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// A rotation matrix, row by row.
using Rotation = std::array<double, 9>;
inline constexpr Rotation kNoRotation{1, 0, 0, 0, 1, 0, 0, 0, 1};

/// All points within `radius` of the segment; a sphere where both ends are one point.
struct Capsule {
  Vec3 from;
  Vec3 to;
  double radius = 0;
};

/// A joint and what moves with it. Its frame at value 0 is `origin`, `rotation` in the frame of the
/// joint before it (the base's for the first); `axis` and `capsules` are in its own frame.
struct Joint {
  enum class Kind { revolute, prismatic };
  std::string name;
  Kind kind = Kind::revolute;
  Vec3 origin;
  Rotation rotation = kNoRotation;
  Vec3 axis{0, 0, 1};  ///< unit
  double low = 0;      ///< limits of the joint's value, low <= high
  double high = 0;
  double velocity = 1;      ///< largest |dq/dt|, above 0
  double acceleration = 1;  ///< largest |d2q/dt2|, above 0
  std::vector<Capsule> capsules;
};

/// A chain of 1 to kMaxJoints joints on a base that stands still.
struct Robot {
  static constexpr int kMaxJoints = 16;

  std::string name;
  std::vector<Capsule> base;  ///< in the base's frame, which is the world's
  std::vector<Joint> joints;
  Vec3 tip;  ///< in the frame of the last joint
  /// Pairs of bodies that may touch: 0 is the base, i what moves with joint i - 1. Neighbours may
  /// in any case.
  std::vector<std::pair<int, int>> may_touch;

  int size() const noexcept { return static_cast<int>(joints.size()); }
};

/// Which part of a URDF file is the chain.
struct Chain {
  std::string base = {};  ///< link; empty: the root
  std::string tip = {};   ///< link; empty: the only leaf
};

/// Reads a robot: a URDF file, or the short description in JSON (format "lasius-arm/1", see
/// maps/README.md), told apart by content. Of a URDF's chain every joint counts, and the collision
/// geometry inside capsules that enclose it (a box or a mesh's bounding box inside up to four);
/// `velocity` is 1 where the file says 0 or nothing, as files do that know none; `acceleration`,
/// which URDF does not have, is four times the velocity. Pairs of bodies that touch with all joints
/// at 0 (or the limit nearest to it) may touch.
/// @throws Error(file_missing, file_broken, file_unsupported) naming the file, the place in it and
///         the remedy; Error(invalid_parameter) for a chain that the file does not have.
LASIUS_ARM_EXPORT Robot read_robot(const std::string& path, const Chain& chain = {});

/// The same from text; `file` names it in errors and is where meshes are looked for.
LASIUS_ARM_EXPORT Robot parse_robot(std::string_view text, const std::string& file,
                                    const Chain& chain = {});

/// @throws Error(invalid_parameter) for the first field out of its range.
LASIUS_ARM_EXPORT void validate(const Robot& robot);

/// Where the tip is at joint values `q`.
/// @throws Error(invalid_parameter) as `validate`, and where `q` has not a number for each joint.
LASIUS_ARM_EXPORT Vec3 tip_position(const Robot& robot, std::span<const double> q);

/// The capsules of all bodies in the world, the base's first, then joint by joint.
/// @throws as tip_position.
LASIUS_ARM_EXPORT std::vector<Capsule> place_capsules(const Robot& robot,
                                                      std::span<const double> q);

/// The corners of a surface's triangles, one after another.
using Triangles = std::vector<std::array<Vec3, 3>>;

struct Obstacle {
  enum class Shape { box, sphere, cylinder, mesh };
  Shape shape = Shape::box;
  std::string name;
  Vec3 position;  ///< of the centre (of the mesh's origin)
  Rotation rotation = kNoRotation;
  Vec3 size;            ///< of a box, edge to edge
  double radius = 0;    ///< of a sphere or cylinder
  double length = 0;    ///< of a cylinder, along its own z
  Triangles triangles;  ///< of a mesh, in its own frame; a surface: what is inside is free
};

/// What stands around a robot, in metres; the robot's base is at the origin.
struct Scene {
  std::string name;
  std::vector<Obstacle> obstacles;
};

/// Reads a scene in JSON (format "lasius-scene/1", see maps/README.md); meshes are STL files, their
/// paths relative to the scene's. @throws as read_robot.
LASIUS_ARM_EXPORT Scene read_scene(const std::string& path);
/// The same from text; `file` names it in errors and is where meshes are looked for.
LASIUS_ARM_EXPORT Scene parse_scene(std::string_view text, const std::string& file);

/// @throws Error(invalid_parameter) for the first field out of its range.
LASIUS_ARM_EXPORT void validate(const Scene& scene);

/// Reads an STL file, binary or text. @throws Error(file_missing, file_broken, file_unsupported).
LASIUS_ARM_EXPORT Triangles read_stl(const std::string& path);

}  // namespace lasius::arm
