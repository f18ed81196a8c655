// Random numbers, places and blocks.
#pragma once

#include <random>

#include "core/arm/convex.h"

namespace lasius::arm {

class Draw {
 public:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  bool coin() { return between(0, 1) < 0.5; }
  Vec3 point(double half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
  /// Every third one is parallel to the axes, where faces and edges meet as a whole.
  Placement pose(double half) {
    const Vec3 at = point(half);
    return {between(0, 3) < 1 ? kNoRotation : roll_pitch_yaw(point(3)), at};
  }
  Block block() {
    Block b{.pose = pose(1), .half = {between(0.01, 0.6), between(0.01, 0.6), between(0.01, 0.6)}};
    if (coin()) return b;
    b.round = b.half.x;
    b.half.x = b.half.y = 0;
    return b;
  }

 private:
  std::mt19937 engine_{11};
};

}  // namespace lasius::arm
