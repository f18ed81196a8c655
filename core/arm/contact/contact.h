// Whether a robot touches something in a posture, or anywhere along a straight motion.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/arm/contact/joint_curve.h"
#include "core/arm/contact/robot_shapes.h"
#include "core/base/poller.h"
#include "lasius/base/stop.h"

namespace lasius::arm {

/// Two things: a link of the robot, and what it is near to.
struct NearPair {
  double distance = 0;  // metres
  int link = -1;        // -1: there is no pair
  int other = -1;       // link; -1: an obstacle
  int obstacle = -1;
};

/// A robot and its scene, ready to be asked by several threads at a time. The clearance is that of
/// the robot's shapes: nearer than twice that counts as touched, and what is called free is nowhere
/// nearer than the clearance: all along a motion, which is shown by bounds, not by samples. Meshes
/// are surfaces.
class Contact {
 public:
  /// Precondition: a scene that `validate` accepts.
  Contact(std::shared_ptr<const RobotShapes> robot, const Scene& scene);

  /// True where nothing is nearer than twice the clearance.
  /// Precondition: a value for each joint, in all that follows.
  bool posture_free(std::span<const double> q) const;

  enum class Answer { free, blocked, stopped };
  /// `free`: nothing comes nearer than the clearance while the joints go straight. `blocked`: in a
  /// posture on the way something is nearer than twice that. Polls `stop` all the time.
  Answer motion(std::span<const double> from, std::span<const double> to,
                const StopCondition& stop) const;
  /// The same along a curve.
  Answer motion(const JointCurve& curve, const StopCondition& stop) const;

  /// The nearest pair of those that must not touch; infinitely far where there is none.
  NearPair nearest(std::span<const double> q) const;

  const std::shared_ptr<const RobotShapes>& robot() const noexcept { return robot_; }

 private:
  struct Pair {
    const Shape* a;
    const Shape* b;
    int relation;
  };
  /// Bodies, the first above the second.
  struct Relation {
    int body, from;
  };
  /// A motion in which each joint goes straight.
  struct Straight {
    std::span<const double> from, to;
    JointCurve curve;
    bool lanes_hold;  ///< the kernels' rounding is bounded
  };
  class Search;

  /// The pairs of the larger one's parts with the other.
  static std::array<Pair, 2> opened(const Pair& pair);
  void add(const ShapePair& pair);
  /// Whether the kernels' rounding is bounded for such a motion.
  bool lanes_hold(std::span<const double> from, std::span<const double> to) const noexcept;
  /// Calls look(obstacles, first), a few hundred at a time from number `first` on, until it or
  /// `poller` says to stop: then it is false.
  template <class Look>
  bool glance(Poller& poller, const Look& look) const;
  /// A quick look whether an obstacle reaches into the robot, which need not find what there is.
  bool touches(const Straight& motion, Poller& poller) const;
  NearPair told(const Pair& pair, double distance) const;

  std::shared_ptr<const RobotShapes> robot_;
  ShapeStore store_;  // of the obstacles
  std::vector<const Shape*> obstacles_;
  std::vector<kernels::LaneObstacle> lane_obstacles_;
  kernels::LaneContact glance_;
  std::vector<Relation> relations_;
  std::vector<Pair> pairs_;
  std::vector<int> to_world_;  // of each body: its relation to the obstacles
  std::size_t own_ = 0;        // from this pair on they are of the robot alone
};

}  // namespace lasius::arm
