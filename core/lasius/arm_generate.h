// Questions for arms from a seed.
#pragma once

#include <cstdint>
#include <vector>

#include "lasius/arm.h"

namespace lasius::arm {

struct GenerateOptions {
  std::uint64_t seed = 1;
  int obstacles = 20;  ///< besides the wall; 0 .. 1000
  /// A plate between start and goal, this many times as wide and high as they are apart; 0: none.
  double wall = 0;
  double least_distance = 0.3;  ///< of start and goal, as a share of the arm's reach; up to 1
};

struct Query {
  Scene scene;
  std::vector<double> start;
  Vec3 goal;
};

/// Boxes, spheres and cylinders within the arm's reach, a start and a goal: both are positions of
/// the arm that touch nothing. The same on every machine.
/// @throws Error(invalid_parameter) for options out of range, or where no such question is found:
///         too many obstacles for this arm.
LASIUS_ARM_EXPORT Query generate_query(const Robot& robot, const GenerateOptions& options);

}  // namespace lasius::arm
