// What tells a robot whether it can be somewhere: the only way in which a search learns of
// obstacles.
#pragma once

#include <memory>
#include <span>

#include "lasius/arm.h"

namespace lasius::arm {

/// Answers whether positions and motions are free. A search asks only about a position that an ant
/// tries and about the motion to it, each once. Both questions may come from several threads at a
/// time; the answers must not change while a plan is made. Spans hold a value for each joint.
class LASIUS_ARM_EXPORT Sensor {
 public:
  virtual ~Sensor();

  /// True when no link touches an obstacle or another link at joint values `q`.
  virtual bool position_free(std::span<const double> q) const = 0;

  /// True when nothing is touched while every joint goes straight from `from` to `to`.
  virtual bool motion_free(std::span<const double> from, std::span<const double> to) const = 0;

  /// What is called free keeps at least this distance from everything, in metres; at least
  /// kLeastClearance.
  virtual double clearance() const = 0;

  static constexpr double kLeastClearance = 1e-6;
};

/// A sensor that knows a scene.
///
/// Distances are computed from the links' capsules: in closed form, to cylinders by bisection. A
/// motion is followed by conservative advancement (Mirtich 1996): as far as no point of a link can
/// have used up its distance, then measured again, so that what is called free is free all along.
class LASIUS_ARM_EXPORT SceneSensor final : public Sensor {
 public:
  /// What comes nearer than twice `clearance` counts as touched, and nothing that counts as free is
  /// nearer than `clearance`. Copies both.
  /// @throws Error(invalid_parameter) for a robot or scene that `validate` refuses and a clearance
  ///         that is not kLeastClearance .. 1; its questions, where a span does not fit the robot.
  SceneSensor(const Robot& robot, const Scene& scene, double clearance = kClearance);
  ~SceneSensor() override;

  bool position_free(std::span<const double> q) const override;
  bool motion_free(std::span<const double> from, std::span<const double> to) const override;
  double clearance() const override;

  /// What is in the way at `q`, for people: "link 3 and obstacle 2 (post)"; empty where it is free.
  std::string contact(std::span<const double> q) const;

  static constexpr double kClearance = 0.002;

 private:
  class Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace lasius::arm
