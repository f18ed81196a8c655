#include "core/vehicle/end_price.h"

#include <algorithm>
#include <cmath>

#include "core/vehicle/angle.h"

namespace lasius::vehicle {

double late_by(double radius, double angle, double on, bool reverse) noexcept {
  const double sine = kernels::sine_cosine(angle).sine;
  const double turned = radius * (angle - sine);  // until it heads there
  const double rest = sine - on / radius;
  if (rest <= 0) return turned;
  const double ahead = radius * (angle - arc_sine(rest)) - on;
  if (!reverse) return ahead;
  // Near by it is what lies aside that takes the way.
  const double aside = radius * arc_cosine(1 - on * sine / radius) - on;
  return std::max(ahead, std::min(turned, aside));
}

EndPrice::EndPrice(const Vehicle& vehicle, double yaw, double open, double within, double tolerance)
    : reverse_(vehicle.reverse), yaw_(yaw), tolerance_(tolerance) {
  constexpr double kLeastOpen = 0.05;  // below, rays have hardly a direction
  open = std::min(open, within);
  if (open < kLeastOpen) return;
  const int steps = static_cast<int>(least_.size());
  const double step = (reverse_ ? kPi / 2 : kPi) / steps;
  std::array<double, 256> late, beside;
  for (int i = 0; i < steps; ++i) {
    late[i] = late_by(vehicle.turning_radius, i * step, open, reverse_);
    beside[i] = within * (1 - kernels::sine_cosine(i * step).cosine);
  }
  // The vehicle leaves by another direction, in the step of j from that of i, if that is cheaper.
  for (int i = 0; i < steps; ++i) {
    double least = late[i];
    for (int j = 0; j < i && beside[j] < least; ++j)
      least = std::min(least, beside[j] + late[i - j - 1]);
    least_[i] = least;
  }
}

double EndPrice::operator()(Point towards) const noexcept {
  constexpr double kRounding = 1e-7;
  double off = std::fabs(half_turned(direction(towards.y, towards.x) - yaw_));
  if (reverse_) off = std::min(off, kPi - off);
  off -= tolerance_ + kRounding;
  if (off <= 0) return 0;
  const double steps = static_cast<double>(least_.size());
  const double i = off * steps / (reverse_ ? kPi / 2 : kPi);
  return least_[static_cast<std::size_t>(std::min(i, steps - 1))];
}

}  // namespace lasius::vehicle
