#include "core/arm/contact/motion_bound.h"

#include <algorithm>
#include <cmath>

namespace lasius::arm {

void MotionBound::set(std::span<const double> change, std::span<const double> bend, double half,
                      const Kinematics::Poses& poses) {
  joints_ = arm_.size();
  half_ = half;
  for (int k = 0; k < joints_; ++k) {
    const Vec3 axis = arm_.axis(k, poses);
    origin_[k] = poses[k].position;
    bend_[k] = bend[k];
    rate_[k] = std::abs(change[k]) + half * bend[k];
    turn_[k] = arm_.slides(k) ? Vec3{} : change[k] * axis;
    shift_[k] = arm_.slides(k) ? change[k] * axis : cross(origin_[k], turn_[k]);
    // A joint that slides takes the frame away from that before by up to h more than it is now.
    link_[k] = k == 0 ? 0 : distance(origin_[k], origin_[k - 1]);
    if (arm_.slides(k)) link_[k] += half * rate_[k];
  }
}

RelativeMotion MotionBound::of(int body, int from) const {
  RelativeMotion found;
  // From the body inwards: `reach` bounds how far its origin is from that of joint k.
  const int last = body - 1;
  double reach = 0, moved = 0, rates = 0, bends = 0;
  std::array<double, Robot::kMaxJoints> spans;
  for (int k = last; k >= from; --k) {
    spans[k] = std::min(reach, distance(origin_[last], origin_[k]) + half_ * moved);
    // What moves the body's origin, seen from the joint before.
    moved += rate_[k] * (arm_.slides(k) ? 1 : reach);
    reach += link_[k];
  }
  for (int k = from; k <= last; ++k) {
    found.turn = found.turn + turn_[k];
    found.shift = found.shift + shift_[k];
    if (arm_.slides(k)) {
      found.far += bend_[k] + 2 * rate_[k] * rates;
      continue;
    }
    found.far += (bend_[k] + rate_[k] * (rate_[k] + 2 * rates)) * spans[k];
    bends += bend_[k];
    rates += rate_[k];
  }
  found.spread = bends + rates * rates;
  found.turning = rates;
  return found;
}

}  // namespace lasius::arm
