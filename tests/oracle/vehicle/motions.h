// A way as the judge takes it. For tests, which know both.
#pragma once

#include <span>
#include <vector>

#include "lasius/vehicle/motion.h"
#include "tests/oracle/vehicle/footprint_judge.h"

namespace lasius::oracle {

inline std::vector<Motion> motions_of(std::span<const vehicle::Segment> segments) {
  std::vector<Motion> motions;
  for (const vehicle::Segment& s : segments)
    motions.push_back({s.begin.x, s.begin.y, s.begin.yaw, s.curvature, s.length, s.gear, s.angle,
                       s.curvature_rate});
  return motions;
}

}  // namespace lasius::oracle
