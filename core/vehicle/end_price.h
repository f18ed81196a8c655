// What a vehicle pays on top of a disc's way for the heading that it has at an end.
#pragma once

#include <array>

#include "lasius/vehicle/vehicle.h"

namespace lasius::vehicle {

/// The least length to get `on` cells ahead in a direction that is `angle` radians, 0 to pi, off
/// the heading, less those cells: a heading turns by 1 / radius a cell. Farther ahead it is not
/// less. @param reverse  may drive backwards, too; then the angle is at most pi / 2
double late_by(double radius, double angle, double on, bool reverse) noexcept;

/// A bound from below of that by the direction in which the shortest way of a disc, of those that
/// the vehicle's may be drawn together to, leaves an end. docs/vehicles.md proves it.
class EndPrice {
 public:
  /// @param yaw  of the end; of a goal, which is left backwards in time, turned round
  /// @param open  cells around the end in which nothing ends a line of sight
  /// @param within  cells, at most half of what lies between the ends
  /// @param tolerance  radians by which the heading may differ
  EndPrice(const Vehicle& vehicle, double yaw, double open, double within, double tolerance);

  double operator()(Point towards) const noexcept;
  double most() const noexcept { return least_.back(); }

 private:
  bool reverse_;
  double yaw_, tolerance_;
  std::array<double, 256> least_{};  ///< by the angle off the heading, rising
};

}  // namespace lasius::vehicle
