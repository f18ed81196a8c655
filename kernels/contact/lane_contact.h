// A glance at a motion of a robot among obstacles: eight postures or eight parts of it side by
// side, in floats with a margin for their rounding. The same on every machine.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "kernels/base/cpu.h"

namespace lasius::kernels {

inline constexpr int kLanes = 8;
inline constexpr int kMostLaneJoints = 16;
inline constexpr int kMostOuterBalls = 12;  // of a body

/// A joint: its frame in the world is that of the joint before, then `position`, then
/// fixed + cos q with_cosine + sin q with_sine, row by row; one that slides goes q `along` instead.
struct LaneJoint {
  std::array<float, 9> fixed, with_cosine, with_sine;
  std::array<float, 3> position, axis, along;  // the axis in its own frame
  bool slides;
  double length;  // no longer is the way from the joint before
};

struct LaneBall {
  std::array<float, 3> centre;  // in the frame of the body
  float radius;
  float far;    // no point of what it is around is further from the body's origin
  bool hollow;  // inside of a surface that is empty
};

/// What moves with a joint.
struct LaneBody {
  std::vector<LaneBall> outer;  // around it: the first around all, the others together, too
  std::vector<LaneBall> inner;  // in it
};

/// A box or cylinder at rest, in the middle of its own frame, and what is within `round` of it.
struct LaneObstacle {
  std::array<float, 9> rotation;
  std::array<float, 3> position, half;  // of a cylinder: radius, nothing, half its length
  float round, radius;                  // radius: of a ball around all of it
  float margin;                         // metres, for rounding of all that is asked about it
  bool cylinder, solid;                 // solid: all of it is, else it only holds what is
};

struct LaneRobot {
  std::vector<LaneJoint> joints;
  std::vector<LaneBody> bodies;  // one for each joint
};

/// Parts first to first + 7 of `parts` alike of the straight way between joint values.
struct LaneMotion {
  const double* from;
  const double* to;
  int parts, first;
  double clearance;
};

/// A ball that may touch an obstacle in some of the parts, by bits.
struct LaneMiss {
  int body, ball, obstacle;
  unsigned parts;
  friend bool operator==(const LaneMiss&, const LaneMiss&) = default;
};

struct LaneContact {
  /// True only where a ball in the robot touches an obstacle in the middle of a part.
  bool (*touches)(const LaneRobot&, std::span<const LaneObstacle>, const LaneMotion&);
  /// Adds to `misses` what is not shown to be further apart than the clearance, all along a part.
  void (*sweep)(const LaneRobot&, std::span<const LaneObstacle>, const LaneMotion&,
                std::vector<LaneMiss>& misses);
};
/// Those of an instruction set. They say the same.
const LaneContact& lane_contact(Isa isa) noexcept;

}  // namespace lasius::kernels
