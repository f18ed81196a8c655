// From a sequence of joint vectors to a smooth motion in time.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "lasius/arm/sensor.h"
#include "lasius/base/enum_names.h"
#include "lasius/base/status.h"
#include "lasius/base/stop.h"

namespace lasius::arm {

/// A cubic spline for each joint, at rest at both ends: q and dq/dt are continuous. So is d2q/dt2,
/// and 0 at both ends, of splines and where jerk is limited; else it jumps where two knots stand at
/// one time, and at both ends.
class LASIUS_ARM_EXPORT Trajectory {
 public:
  /// Where all joints are at a time, and how they move.
  struct State {
    JointVector q;    ///< values
    JointVector dq;   ///< velocities
    JointVector ddq;  ///< accelerations
  };

  /// A knot: joint values and their second derivatives; between two knots these are linear in t.
  struct Knot {
    double time = 0;  ///< seconds from the start
    JointVector q;    ///< values
    JointVector ddq;  ///< accelerations
  };

  Trajectory() = default;
  /// Knots in rising time from 0, of equal time two at most, values of equal number; at least one.
  /// Not checked.
  explicit Trajectory(std::vector<Knot> knots);

  /// Seconds from the first knot to the last; 0 where it is empty.
  double duration() const noexcept { return knots_.empty() ? 0 : knots_.back().time; }
  /// In rising time; valid as long as the trajectory.
  const std::vector<Knot>& knots() const noexcept { return knots_; }

  /// The state at a time, clamped to 0 .. duration(). Precondition: not empty.
  State at(double time) const;
  /// True where there is no knot, and so no motion.
  bool empty() const noexcept { return knots_.empty(); }

 private:
  std::vector<Knot> knots_;
};

/// How a way is followed in time.
enum class Timing {
  /// Corners rounded by parabolas, and the least time along that path, under the limits of velocity
  /// and acceleration; where joints have one, of jerk too.
  optimal,
  splines,  ///< the source's: cubic splines through the waypoints
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kTimingNames{"optimal", "splines"};
/// The name of a value.
constexpr std::string_view to_string(Timing v) noexcept { return name_of(v, kTimingNames); }

/// How a motion is made.
struct TrajectoryOptions {
  bool shortcut = true;  ///< leave out waypoints that a straight joint motion can pass by
  /// Then try so many straight motions between two points of the way, drawn at random.
  int shortcuts = 0;
  std::uint64_t seed = 1;           ///< of the draws
  bool quick = false;               ///< shortcuts save time, not joint travel
  Timing timing = Timing::optimal;  ///< how the way is followed
  std::int64_t max_questions = std::numeric_limits<std::int64_t>::max();  ///< then it rests
  StopCondition stop = {};  ///< polled after every motion asked about
  /// Seconds that the motion is to take; as few as the limits allow where that is more, or for 0.
  double duration = 0;
};

/// A motion, and how it was found.
struct TrajectoryResult {
  Trajectory trajectory;           ///< empty where the waypoints are
  int waypoints = 0;               ///< left after shortcutting
  bool stops = false;              ///< it rests at every waypoint: nothing faster was found free
  std::int64_t questions = 0;      ///< motions that the sensor was asked about
  Status status = Status::solved;  ///< limit where time or questions ran out; interrupted
  Limit limit = Limit::none;       ///< which one ended it
};

/// A motion along `waypoints`, a column each, between which straight joint motions are free.
///
/// Timing::optimal: corners are rounded by parabolas, of which each begins and ends in the middle
/// of the shorter edge, or where it is not free nearer to the corner; at last the arm rests there.
/// The least time along that path is found by reachability, docs/theory.md; no limit is broken at
/// any time. With limits of jerk the mean of that motion over a short time is taken. What is asked
/// about, piece by piece, is the motion that is returned: Sensor::try_curve.
///
/// Timing::splines: natural cubic splines through the joint vectors with two free knots, one in the
/// first and one in the last interval, which make velocity and acceleration 0 at both ends (Lin,
/// Chang & Luh 1983). Intervals are stretched where a limit of velocity or acceleration is
/// exceeded, and all of them at last, so that both hold everywhere and one is just met. The spline
/// is checked between its knots: pieces short enough to stay within the sensor's clearance of their
/// chords are asked about as straight motions. Where it is not free, or leaves the joint limits,
/// knots are added on the straight motion there, and in the end, or when it is told to stop, it
/// rests at each waypoint, which is always free.
/// @throws Error(invalid_parameter) for a robot that `validate` refuses, a waypoint that has not a
///         number for each joint or is outside the joint limits (by more than 1e-9, also of joints
///         that turn on and on), a duration that is none, and a sensor's clearance below its least;
///         what the sensor throws.
LASIUS_ARM_EXPORT TrajectoryResult make_trajectory(
    const Robot& robot, const Sensor& sensor, const Eigen::Ref<const Eigen::MatrixXd>& waypoints,
    const TrajectoryOptions& options = {});

/// The waypoints, a column each, that make_trajectory would lay the motion through: what `shortcut`
/// and `shortcuts` leave of these. Straight motions between them are free. @throws likewise.
LASIUS_ARM_EXPORT Eigen::MatrixXd shorten_way(const Robot& robot, const Sensor& sensor,
                                              const Eigen::Ref<const Eigen::MatrixXd>& waypoints,
                                              const TrajectoryOptions& options = {});

/// What a second look at a finished trajectory found: distances and limits at `samples` times
/// evenly spread, the tip there by KDL too, and a proof of all between them. No search and no
/// record of what it asked takes part.
struct Recheck {
  int samples = 0;   ///< times that were looked at; fewer than asked for where it was stopped
  int contacts = 0;  ///< samples at which a link touches an obstacle or another link
  int unproven = 0;  ///< pieces between samples of which it was not shown that nothing touches
  /// Samples at which a limit of value, velocity or acceleration is broken, and pieces between two
  /// knots (at the ends: the steps from and to rest) in which one of jerk is.
  int limits = 0;
  double nearest = 0;    ///< least distance to an obstacle or another link, metres
  double tip_error = 0;  ///< largest distance between KDL's tip and ours
};
/// Checks a trajectory at `samples` times from its start to its end, at least one.
/// @throws Error(invalid_parameter) for a robot or scene that `validate` refuses, a trajectory that
///         is empty, not of this robot's joints or not within what `tip_position` takes, and less
///         than one sample.
LASIUS_ARM_EXPORT Recheck recheck(const Robot& robot, const Scene& scene,
                                  const Trajectory& trajectory, int samples = 1000,
                                  const StopCondition& stop = {});

}  // namespace lasius::arm
