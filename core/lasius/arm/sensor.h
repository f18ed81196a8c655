// What tells a robot whether it can be somewhere: the only way in which a search learns of
// obstacles.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lasius/arm/robot.h"
#include "lasius/base/stop.h"

namespace lasius::arm {

class Trajectory;

/// Answers whether positions and motions are free. A search asks only about a position that an ant
/// tries and about the motion to it, each once. Both questions may come from several threads at a
/// time; the answers must not change while a plan is made. Arguments hold a value for each joint;
/// they are valid during the call only.
class LASIUS_ARM_EXPORT Sensor {
 public:
  virtual ~Sensor();

  /// True when no link touches an obstacle or another link at joint values `q`.
  virtual bool position_free(const JointRef& q) const = 0;

  /// True when nothing is touched while every joint goes straight from `from` to `to`.
  virtual bool motion_free(const JointRef& from, const JointRef& to) const = 0;

  /// The same, unless told to stop before it is known: nothing then. A sensor whose questions take
  /// long should answer itself; unless overridden motion_free is asked, to its end.
  virtual std::optional<bool> try_motion(const JointRef& from, const JointRef& to,
                                         const StopCondition& stop) const;

  /// The same along a trajectory, from one time to a later one within it. Nothing where told to
  /// stop; and where curves are not known, as unless overridden: straight motions next to it are
  /// asked about then.
  virtual std::optional<bool> try_curve(const Trajectory& trajectory, double from, double to,
                                        const StopCondition& stop) const;

  /// What is called free keeps at least this distance from everything, in metres; at least
  /// kLeastClearance.
  virtual double clearance() const = 0;

  /// What is touched at joint values that are not free, for people; empty where it is not known.
  virtual std::string contact(const JointRef& q) const;

  static constexpr double kLeastClearance = 1e-6;  ///< metres
};

/// A sensor that knows a scene.
///
/// Distances are those of the solids as they are, never above the true ones: a mesh is a surface,
/// what is inside of it is free. Links that stand still are not checked against obstacles. A motion
/// is free where bounds to the second order of how all points of all links move show that it is,
/// all along; see docs/theory.md.
class LASIUS_ARM_EXPORT SceneSensor final : public Sensor {
 public:
  /// A position in which something, an obstacle or another link, is nearer than twice `clearance`
  /// is not free; nor is a motion that has one half way, in which it is looked at. Nothing that
  /// counts as free is nearer than `clearance`. Copies both.
  /// @throws Error(invalid_parameter) for a robot or scene that `validate` refuses and a clearance
  ///         that is not kLeastClearance .. 1; its questions, of values as `tip_position`.
  SceneSensor(const Robot& robot, const Scene& scene, double clearance = kClearance);
  /// The same robot and clearance among other things: what was prepared of the robot is shared,
  /// which of large meshes is most of the work. @throws likewise, for the scene.
  SceneSensor(const SceneSensor& other, const Scene& scene);
  ~SceneSensor() override;

  bool position_free(const JointRef& q) const override;
  bool motion_free(const JointRef& from, const JointRef& to) const override;
  /// Looks at `stop` after each few thousand nanoseconds' work.
  std::optional<bool> try_motion(const JointRef& from, const JointRef& to,
                                 const StopCondition& stop) const override;
  std::optional<bool> try_curve(const Trajectory& trajectory, double from, double to,
                                const StopCondition& stop) const override;
  double clearance() const override;

  /// What is in the way at `q`, for people: "the base and link 3 (after elbow)", or of a URDF's
  /// links by their names, and how far apart where they do not touch; empty where it is free.
  std::string contact(const JointRef& q) const override;

  /// Metres from what moves of the robot at `q` to the nearest obstacle or link that it is checked
  /// against; 0 where something touches, infinite where there is nothing. Never more than it is.
  double distance(const JointRef& q) const;

  /// Two things, as messages name them, and the metres between.
  struct Nearest {
    double distance = 0;  ///< as distance() says it
    std::string link;     ///< "link 3 (after elbow)"; empty where there is no pair
    std::string other;    ///< another link, or "obstacle 2 (shelf)"
  };
  /// What is nearest to each other at `q`, of all that must not touch.
  Nearest nearest(const JointRef& q) const;

  static constexpr double kClearance = 0.002;  ///< what is kept unless said otherwise, metres

 private:
  class Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace lasius::arm
