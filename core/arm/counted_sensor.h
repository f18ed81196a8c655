// What making a motion asks of a sensor: counted, limited, and told to stop.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "lasius/arm/trajectory.h"

namespace lasius::arm {

class CountedSensor {
 public:
  /// @throws Error(invalid_parameter) for a sensor's clearance below its least. All must outlive
  /// it.
  CountedSensor(const Robot& robot, const Sensor& sensor, const TrajectoryOptions& options);

  /// Both are false once it is told to stop.
  bool motion_free(const JointRef& from, const JointRef& to);
  /// Of a trajectory from one time to another: that very motion, where the sensor knows curves; or
  /// else chords so short that it stays within the sensor's clearance of them.
  bool curve_free(const Trajectory& trajectory, double from, double to);
  /// The latter, whatever it knows.
  bool chords_free(const Trajectory& trajectory, double from, double to);

  /// True when told to stop, or when no question is left.
  bool stopped() const noexcept { return poller_.stopped() || spent_; }
  /// For work without questions: polls at once; true when told to stop.
  bool poll() { return poller_.stop_after(kQuestions); }
  /// Says in `result` how it ended, and what was asked.
  void finish(TrajectoryResult& result) const;

 private:
  static constexpr int kQuestions = 16;  // between two polls
  /// Before each question.
  bool may_ask();
  bool told(std::optional<bool> free);

  const Robot& robot_;
  const Sensor& sensor_;
  double clearance_;
  const StopCondition& stop_;
  Poller poller_;
  std::int64_t most_;
  std::int64_t asked_ = 0;
  bool spent_ = false;
  bool knows_curves_ = true;    // as far as is known
  std::vector<double> levers_;  // by joint, a bound for how far any point moves with a radian of it
};

}  // namespace lasius::arm
