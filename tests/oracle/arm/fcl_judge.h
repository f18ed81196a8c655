// Whether an arm touches anything, and how far it is from it: KDL places its links, FCL measures.
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <kdl/chain.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "lasius/arm/robot.h"

namespace lasius::oracle {

/// Nothing of the library's is in it but the robot and the scene as they were read.
class FclJudge {
 public:
  FclJudge(const arm::Robot& robot, const arm::Scene& scene);

  /// Metres to the nearest obstacle or link that must not be touched; 0 where something touches,
  /// and where FCL finds no answer. Links that stand still are not held against obstacles.
  double distance(const arm::JointRef& q) const;
  /// Whether that is 0, which is quicker to say.
  bool touches(const arm::JointRef& q) const;
  Eigen::Vector3d tip(const arm::JointRef& q) const;

 private:
  using Pose = fcl::Transform3d;
  struct Part {
    std::shared_ptr<fcl::CollisionGeometryd> shape;
    Pose at;  // in its body, of an obstacle in the world
    int link = -1, body = 0;
  };

  std::vector<Pose> bodies(const arm::JointRef& q) const;
  /// Calls visit(a, where, b, where) for each pair, until one is true.
  template <class Visit>
  bool any_pair(const arm::JointRef& q, const Visit& visit) const;

  KDL::Chain chain_;
  Pose tip_;
  std::vector<Part> parts_, obstacles_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

}  // namespace lasius::oracle
