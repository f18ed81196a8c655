// Whether a robot touches anything, from its URDF alone: read, placed and measured by other code
// than the library's.
#pragma once

#include <fcl/narrowphase/collision_object.h>
#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lasius/arm/robot.h"

namespace lasius::oracle {

class UrdfOracle {
 public:
  /// Joints that are not given by name at a question stand at `standing`, or at 0; a joint that
  /// mimics follows. `package` is the folder of all packages. Nothing is exempt but links of which
  /// one is the other's parent, and those without a moving joint between them.
  UrdfOracle(const std::string& file, std::vector<std::string> moving,
             std::map<std::string, double> standing, const std::string& package);

  void set_obstacles(const std::vector<arm::Obstacle>& obstacles);

  /// What touches what; empty where nothing does.
  std::string contact(const arm::JointRef& q) const;

 private:
  using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
  struct Part {
    Geometry geometry;
    fcl::Transform3d at;  // in its link, of an obstacle in the world
    int link;
  };
  struct Link {
    std::string name;
    int parent;  // -1: the root
    urdf::JointConstSharedPtr joint;
    bool moves;  // its joint is one of those asked for
  };

  void add_link(const urdf::LinkConstSharedPtr& link, int parent, const std::string& folder,
                const std::string& package);
  double value(const urdf::Joint& joint, const arm::JointRef& q) const;
  bool rigid(int a, int b) const;

  urdf::ModelInterfaceSharedPtr model_;
  std::vector<std::string> moving_;
  std::map<std::string, double> standing_;
  std::vector<Link> links_;  // parents first
  std::vector<Part> parts_, obstacles_;
  std::vector<std::pair<int, int>> pairs_;  // of parts
};

}  // namespace lasius::oracle
