// MotionBenchMaker's problems for an arm, as MoveIt writes them.
#pragma once

#include <string>
#include <vector>

#include "lasius/arm/robot.h"

namespace lasius::bench {

/// A folder of a robot: NAME.urdf, NAME.srdf and meshes, of package "meshes".
arm::Robot read_mbm_robot(const std::string& folder, const std::string& name,
                          const std::string& base, const std::string& tip);

struct MbmProblem {
  std::string set;  ///< name of its folder
  int number = 0;
  arm::Scene scene;
  arm::JointVector start, goal;
};
/// All in the folders of `problems`, in order: sceneNNNN.yaml and requestNNNN.yaml.
/// @throws Error for a folder without any, and for files that say something else.
std::vector<MbmProblem> read_mbm_problems(const std::string& problems, const arm::Robot& robot);

}  // namespace lasius::bench
