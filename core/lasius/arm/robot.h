// Robots and scenes: what they are made of, and how they are read from files.
//
// Lengths are metres, angles radians, times seconds; z is up. A robot is a chain of joints and the
// links that move with them; links and obstacles are made of boxes, spheres, cylinders, capsules
// and meshes.
//
// Vectors, poses and joint values are Eigen's. A member of these types begins as zero (a pose as
// the identity); `{}` in its place leaves it without a value, as everywhere in Eigen.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lasius/arm_export.h"
#include "lasius/base/enum_names.h"

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
/// -march=native there, or compile KDL and lasius with them, too.
template <int AlignBytes, bool ByMalloc>
LASIUS_ARM_EXPORT bool compile_with_the_Eigen_alignment_of_lasius() noexcept;
namespace internal {
inline const bool kSameAlignment =
    compile_with_the_Eigen_alignment_of_lasius<EIGEN_DEFAULT_ALIGN_BYTES,
                                               EIGEN_MALLOC_ALREADY_ALIGNED>();
}

/// The corners of a surface's triangles, one after another.
using Triangles = std::vector<std::array<Eigen::Vector3d, 3>>;

/// What links and obstacles are made of. A mesh without triangles is nothing.
struct Solid {
  /// What it is, and so which of its measures count.
  enum class Shape {
    box,       ///< `size`, edge to edge
    sphere,    ///< `radius`
    cylinder,  ///< `radius` and `length`, along its own z
    mesh,      ///< `triangles`: a surface, what is inside is free
    capsule,   ///< `radius` around the segment from its origin to `size`
  };
  Shape shape = Shape::box;  ///< which measures count
  /// Of its centre (of the origin of a mesh, of one end of a capsule's axis): of a link in the
  /// frame of its body, of an obstacle in the world.
  Pose pose = Pose::Identity();
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< see Shape
  double radius = 0;                               ///< see Shape
  double length = 0;                               ///< see Shape
  std::shared_ptr<const Triangles> triangles;      ///< in its own frame; null: none
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 5> kShapeNames{"box", "sphere", "cylinder", "mesh",
                                                             "capsule"};
/// The name of a value, as files have it.
constexpr std::string_view to_string(Solid::Shape v) noexcept { return name_of(v, kShapeNames); }

/// A part of a robot that has a body.
struct Link {
  std::string name;  ///< for messages; may be empty
  int body = 0;      ///< what it moves with: 0 is the base, i joint i - 1
  int parent = -1;  ///< number of the link that it hangs on, which it may touch; -1: none. No loops
  std::vector<Solid> solids;  ///< in the frame of the joint that it moves with, or of the base
};

/// A joint.
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
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< in its own frame, of length 1
  double low = 0;                                   ///< least value, -1000 or more
  double high = 0;                                  ///< largest value, `low` to 1000
  bool continuous = false;  ///< revolute, turns on and on: values a turn apart are one posture
  double velocity = 1;      ///< largest |dq/dt|, 1e-9 .. 1e6
  double acceleration = 1;  ///< largest |d2q/dt2|, 1e-9 .. 1e6
  double jerk = 0;          ///< largest |d3q/dt3|, 1e-9 .. 1e9; 0: without limit
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kJointKindNames{"revolute", "prismatic"};
/// The name of a value, as robots' files have it.
constexpr std::string_view to_string(Joint::Kind v) noexcept { return name_of(v, kJointKindNames); }

/// A chain of 1 to kMaxJoints joints on a base that stands still.
struct Robot {
  static constexpr int kMaxJoints = 16;    ///< most joints that a robot may have
  static constexpr int kMaxSolids = 1000;  ///< most solids that its links may have

  std::string name;             ///< for messages and results; may be empty
  std::vector<Joint> joints;    ///< from the base to the tip
  std::vector<Link> links;      ///< all that has a body, what branches off the chain, too
  Pose tip = Pose::Identity();  ///< in the frame of the last joint
  /// Pairs of links, by number, that are not checked against each other. Neither are those that
  /// move with the same joint, and a link and its parent.
  std::vector<std::pair<int, int>> may_touch;
  std::map<std::string, JointVector> states;  ///< postures that its files name
  std::vector<std::string> files;             ///< that were read because another one names them
  std::vector<std::string> notes;             ///< what was assumed in reading it, for people
  std::vector<std::string> warnings;          ///< what is likely a mistake in its files, for people

  /// How many joints it has.
  int size() const noexcept { return static_cast<int>(joints.size()); }
};

/// Which part of a URDF file is the chain, and what is said of the rest.
struct Chain {
  std::string base = {};  ///< link; empty: the root. It stands still, and is the world's frame
  std::string tip = {};   ///< link; empty: the only leaf
  /// Values at which joints beside the chain stand; else 0, or the middle of the range where 0 is
  /// outside of it.
  std::map<std::string, double> set_joints = {};
  std::string srdf = {};          ///< file of pairs that may touch and of named postures, or empty
  std::string joint_limits = {};  ///< file of MoveIt's joint_limits.yaml, or empty
  /// Pairs of links that are not checked against each other.
  std::vector<std::pair<std::string, std::string>> allow_contact = {};
  std::map<std::string, std::string> packages = {};  ///< folders by the names in package://NAME/
  bool use_visual = false;  ///< links without collision geometry take what is drawn of them
  bool bodiless = false;    ///< no link has a body, whatever the file says
};

/// Reads a robot: a URDF file, or the short description in JSON (format "lasius-arm/1", see
/// docs/worlds.md), told apart by content. Of a URDF all joints from base to tip move; every other
/// link stands where it is fixed, joints beside the chain at their values. Links are made of their
/// collision geometry as it is; those without geometry are left out, and the links around them are
/// parent and child. What the files do not say is in Robot::notes: `velocity` is 1 where a
/// continuous joint has none, `acceleration` four times the velocity.
/// @throws Error(file_missing, file_broken, file_unsupported) naming the file, the place in it and
///         the remedy; Error(invalid_parameter) for names that the file does not have.
LASIUS_ARM_EXPORT Robot read_robot(const std::string& path, const Chain& chain = {});

/// The same from text; `file` names it in errors and is where meshes are looked for.
LASIUS_ARM_EXPORT Robot parse_robot(std::string_view text, const std::string& file,
                                    const Chain& chain = {});

/// Two links by number, the first below the second, and why they are not checked against each
/// other.
struct LinkPair {
  /// Whether they are checked.
  enum class Check {
    yes,         ///< they must not touch
    rigid,       ///< no: they move together
    neighbours,  ///< no: one hangs on the other
    allowed,     ///< no: they may touch
  };
  int first = 0;             ///< link number
  int second = 0;            ///< a greater link number
  Check check = Check::yes;  ///< checked, or why not
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 4> kLinkPairCheckNames{"checked", "rigid",
                                                                     "neighbours", "allowed"};
/// The name of a value.
constexpr std::string_view to_string(LinkPair::Check v) noexcept {
  return name_of(v, kLinkPairCheckNames);
}
/// All pairs of links that have solids, in order. Precondition: a robot that `validate` accepts.
LASIUS_ARM_EXPORT std::vector<LinkPair> link_pairs(const Robot& robot);

/// A link's name in messages: 'link "tool"', "link 2 (after elbow)", "the base".
LASIUS_ARM_EXPORT std::string link_name(const Robot& robot, int link);

/// Checks a robot that a program made.
/// @throws Error(invalid_parameter) for the first field out of its range.
LASIUS_ARM_EXPORT void validate(const Robot& robot);

/// Where the tip is in the world at joint values `q`, within their limits or not.
/// @throws Error(invalid_parameter) as `validate`, and where `q` has not a number from -1e6 to 1e6
///         for each joint.
LASIUS_ARM_EXPORT Eigen::Vector3d tip_position(const Robot& robot, const JointRef& q);

/// Where the tip's frame is in the world. @throws as tip_position.
LASIUS_ARM_EXPORT Pose tip_pose(const Robot& robot, const JointRef& q);

/// The links with their solids placed in the world. @throws as tip_position.
LASIUS_ARM_EXPORT std::vector<Link> place_links(const Robot& robot, const JointRef& q);

/// A body that stands still.
struct Obstacle : Solid {
  std::string name;  ///< for messages; may be empty
  std::string file;  ///< that its triangles were read from; may be empty
};

/// What stands around a robot, in metres; the robot's base is at the origin.
struct Scene {
  std::string name;                        ///< for results; may be empty
  std::vector<Obstacle> obstacles;         ///< in any order, overlapping or not
  std::vector<std::string> warnings = {};  ///< what is likely a mistake in its files, for people
};

/// Reads a scene in JSON (format "lasius-scene/1", see docs/worlds.md); meshes are STL, OBJ or DAE
/// files, their paths relative to the scene's. @throws as read_robot.
LASIUS_ARM_EXPORT Scene read_scene(const std::string& path);
/// The same from text; `file` names it in errors and is where meshes are looked for.
LASIUS_ARM_EXPORT Scene parse_scene(std::string_view text, const std::string& file);

/// Checks a scene that a program made.
/// @throws Error(invalid_parameter) for the first field out of its range.
LASIUS_ARM_EXPORT void validate(const Scene& scene);

/// Reads an STL file, binary or text. @throws Error(file_missing, file_broken, file_unsupported).
LASIUS_ARM_EXPORT Triangles read_stl(const std::string& path);

/// Reads a mesh by its ending: .stl, .obj, or .dae in the unit that it names, its nodes placed; its
/// up axis is ignored, as RViz and MoveIt do. @throws as read_stl.
LASIUS_ARM_EXPORT Triangles read_mesh(const std::string& path);

}  // namespace lasius::arm
