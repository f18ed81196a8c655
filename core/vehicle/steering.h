// Ways of a vehicle between two poses without regard to obstacles, by rising cost.
#pragma once

#include <vector>

#include "core/vehicle/word.h"

namespace lasius::vehicle {

/// Dubins' or Reeds & Shepp's words; rotation, line, rotation where it turns in place;
/// rotation and line where it drives to any side.
class Steering {
 public:
  explicit Steering(const Vehicle& vehicle) noexcept : vehicle_(vehicle) {}

  /// Looks for ways; of which at most `most` are kept.
  void aim(const Pose& from, const Pose& to, int most);
  int size() const noexcept { return size_; }
  /// By the vehicle's prices, cusps inside included; rising.
  double cost(int i) const noexcept { return found_[i].cost; }
  /// Appends the motions of a way; false if its end is off by more than 1e-9 radii.
  bool append(int i, std::vector<Segment>& to) const;

  /// A bound from below of the cost between two poses.
  double least(const Pose& from, const Pose& to);

 private:
  struct Found {
    double cost = 0;
    int word = -1;  ///< else rotation, line, rotation
    int gear = 1;   ///< of what drives to any side: -1, it turns last
  };
  void add(const Found& found, int most);

  const Vehicle& vehicle_;
  Words words_;
  Place place_{};
  Pose from_, to_;
  int size_ = 0;
  std::vector<Found> found_;
};

/// Rotation, line in a gear, rotation; what is shorter than 1e-9 is left out.
void append_turns(const Pose& from, const Pose& to, int gear, std::vector<Segment>& way);
/// A line to the side where it lies, and before or after it the rotation, likewise.
void append_slide(const Pose& from, const Pose& to, bool turn_first, std::vector<Segment>& way);

}  // namespace lasius::vehicle
