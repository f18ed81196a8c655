// How fast a path of a vehicle is driven: the least time under its limits.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "lasius/export.h"
#include "lasius/vehicle/motion.h"

namespace lasius::vehicle {

/// Of a vehicle's speed. All above 0; infinity: no limit, save for both speeds.
struct SpeedLimits {
  double speed = 1;                                               ///< forwards, cells a second
  double reverse_speed = 1;                                       ///< backwards
  double acceleration = std::numeric_limits<double>::infinity();  ///< cells / s^2
  double braking = std::numeric_limits<double>::infinity();       ///< likewise
  double lateral_acceleration = std::numeric_limits<double>::infinity();  ///< speed^2 |curvature|
  double turn_rate = 1;  ///< of a rotation in place, radians a second
  double turn_acceleration =
      std::numeric_limits<double>::infinity();  ///< and braking, radians / s^2
  bool steady_curvature = false;                ///< it rests where the curvature jumps: corners()
};

/// A pose and when it is passed.
struct TimedPose {
  PathPose at;       ///< where
  double speed = 0;  ///< cells a second, at least 0; of a rotation radians a second
  double time = 0;   ///< seconds since the begin
};

/// The fastest drive along a path that begins and ends at rest, and rests at cusps and before and
/// after rotations in place, and where what drives to any side takes another. Exact: forward and
/// backward passes over the squared speed at joints, closed forms inside each segment; where the
/// curvature changes on a segment its greatest there holds for all of it.
class LASIUS_EXPORT Profile {
 public:
  /// @throws Error(invalid_parameter) where a limit is not above 0, or a speed is infinite
  Profile(std::vector<Segment> segments, const SpeedLimits& limits);
  double duration() const noexcept;  ///< seconds
  /// Speed and time after `at` of the extent of a segment.
  TimedPose state(int segment, double at) const;
  /// At the poses that poses() has.
  std::vector<TimedPose> samples(double spacing) const;

 private:
  std::vector<Segment> segments_;
  SpeedLimits limits_;
  std::vector<double> speed_;  ///< at the begin of each segment, squared
  std::vector<double> time_;   ///< likewise, and at the end
};

}  // namespace lasius::vehicle
