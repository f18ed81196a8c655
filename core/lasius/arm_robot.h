// Robots and scenes: what they are made of, and how they are read from files.
//
// Lengths are metres, angles radians, times seconds; z is up. A robot is a chain of joints, each
// with the capsules that move with it; obstacles are boxes, spheres, cylinders and meshes.
//
// Vectors, poses and joint values are Eigen's. A member of these types begins as zero (a pose as
// the identity); `{}` in its place leaves it without a value, as everywhere in Eigen.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lasius/arm_export.h"
#include "lasius/enum_names.h"

namespace lasius::arm {

/// A value for each joint, from the base to the tip: radians, or metres where it is prismatic.
using JointVector = Eigen::VectorXd;
/// Joint values as functions take them: a JointVector, a part or column of a matrix or an
/// Eigen::Map over numbers side by side, none of them copied.
using JointRef = Eigen::Ref<const JointVector>;
/// Where a frame is in another one. Not aligned: it may be a member of anything.
using Pose = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

/// Eigen's vectors cross the border to this library: your code frees what it allocated, so both
/// must allocate alike, which in Eigen depends on compiler flags. Where they do not (yours has
/// -mavx, -march=native or GCC's -fsanitize=address, the library has not), linking fails: this
/// function exists for the library's own flags only. Either leave those flags out of the files that
/// include lasius/arm, or add -DEIGEN_DONT_VECTORIZE -DEIGEN_MAX_ALIGN_BYTES=16 to -mavx or
/// -march=native there, or compile FCL, KDL and lasius with them, too.
template <int AlignBytes, bool ByMalloc>
LASIUS_ARM_EXPORT bool compile_with_the_Eigen_alignment_of_lasius() noexcept;
namespace internal {
inline const bool kSameAlignment =
    compile_with_the_Eigen_alignment_of_lasius<EIGEN_DEFAULT_ALIGN_BYTES,
                                               EIGEN_MALLOC_ALREADY_ALIGNED>();
}

/// All points within `radius` of the segment; a sphere where both ends are one point.
struct Capsule {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< one end of its axis
  Eigen::Vector3d to = Eigen::Vector3d::Zero();    ///< the other end
  double radius = 0;                               ///< at least 0, metres
};

/// A joint and what moves with it; `axis` and `capsules` are in its own frame.
struct Joint {
  /// How it moves.
  enum class Kind {
    revolute,   ///< turns about its axis, the value in radians
    prismatic,  ///< slides along its axis, the value in metres
  };
  std::string name;            ///< for messages; may be empty
  Kind kind = Kind::revolute;  ///< how it moves
  /// Where its frame is at value 0, in the frame of the joint before it (the base's for the first).
  Pose frame = Pose::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< of length 1
  double low = 0;                                   ///< least value, -1000 or more
  double high = 0;                                  ///< largest value, `low` to 1000
  double velocity = 1;                              ///< largest |dq/dt|, above 0, at most 1e6
  double acceleration = 1;                          ///< largest |d2q/dt2|, above 0, at most 1e6
  std::vector<Capsule> capsules;                    ///< the body that moves with it
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kJointKindNames{"revolute", "prismatic"};
/// The name of a value, as robots' files have it.
constexpr std::string_view to_string(Joint::Kind value) noexcept {
  return name_of(value, kJointKindNames);
}

/// A chain of 1 to kMaxJoints joints on a base that stands still.
struct Robot {
  static constexpr int kMaxJoints = 16;  ///< most joints that a robot may have

  std::string name;                               ///< for messages and results; may be empty
  std::vector<Capsule> base;                      ///< in the base's frame, which is the world's
  std::vector<Joint> joints;                      ///< from the base to the tip
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();  ///< in the frame of the last joint
  /// Pairs of bodies that may touch: 0 is the base, i what moves with joint i - 1. Neighbours may
  /// in any case.
  std::vector<std::pair<int, int>> may_touch;
  std::vector<std::string> meshes;  ///< files that its URDF names and that were read

  /// How many joints it has.
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

/// Checks a robot that a program made.
/// @throws Error(invalid_parameter) for the first field out of its range.
LASIUS_ARM_EXPORT void validate(const Robot& robot);

/// Where the tip is in the world at joint values `q`, within their limits or not.
/// @throws Error(invalid_parameter) as `validate`, and where `q` has not a number for each joint.
LASIUS_ARM_EXPORT Eigen::Vector3d tip_position(const Robot& robot, const JointRef& q);

/// The tip's position, and the orientation of the last joint's frame. @throws as tip_position.
LASIUS_ARM_EXPORT Pose tip_pose(const Robot& robot, const JointRef& q);

/// The capsules of all bodies in the world, the base's first, then joint by joint.
/// @throws as tip_position.
LASIUS_ARM_EXPORT std::vector<Capsule> place_capsules(const Robot& robot, const JointRef& q);

/// The corners of a surface's triangles, one after another.
using Triangles = std::vector<std::array<Eigen::Vector3d, 3>>;

/// A body that stands still.
struct Obstacle {
  /// What it is, and so which of its measures count.
  enum class Shape {
    box,       ///< `size`
    sphere,    ///< `radius`
    cylinder,  ///< `radius` and `length`
    mesh,      ///< `triangles`
  };
  Shape shape = Shape::box;      ///< which measures count
  std::string name;              ///< for messages; may be empty
  Pose pose = Pose::Identity();  ///< of its centre (of the mesh's origin) in the world
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< of a box, edge to edge
  double radius = 0;                               ///< of a sphere or cylinder
  double length = 0;                               ///< of a cylinder, along its own z
  Triangles triangles;  ///< of a mesh, in its own frame; a surface: what is inside is free
  std::string file;     ///< that they were read from; may be empty
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 4> kShapeNames{"box", "sphere", "cylinder", "mesh"};
/// The name of a value, as scenes' files have it.
constexpr std::string_view to_string(Obstacle::Shape value) noexcept {
  return name_of(value, kShapeNames);
}

/// What stands around a robot, in metres; the robot's base is at the origin.
struct Scene {
  std::string name;                 ///< for results; may be empty
  std::vector<Obstacle> obstacles;  ///< in any order, overlapping or not
};

/// Reads a scene in JSON (format "lasius-scene/1", see maps/README.md); meshes are STL files, their
/// paths relative to the scene's. @throws as read_robot.
LASIUS_ARM_EXPORT Scene read_scene(const std::string& path);
/// The same from text; `file` names it in errors and is where meshes are looked for.
LASIUS_ARM_EXPORT Scene parse_scene(std::string_view text, const std::string& file);

/// Checks a scene that a program made.
/// @throws Error(invalid_parameter) for the first field out of its range.
LASIUS_ARM_EXPORT void validate(const Scene& scene);

/// Reads an STL file, binary or text. @throws Error(file_missing, file_broken, file_unsupported).
LASIUS_ARM_EXPORT Triangles read_stl(const std::string& path);

}  // namespace lasius::arm
