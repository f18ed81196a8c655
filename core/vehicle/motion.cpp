#include "lasius/vehicle/motion.h"

#include <algorithm>
#include <cmath>

#include "core/base/invalid_parameter.h"
#include "core/vehicle/angle.h"

namespace lasius::vehicle {

namespace {

/// Angles beyond what sines are exact for have none: 0 in place of them, and of what is no number.
double exact(double angle) noexcept { return std::fabs(angle) <= 1e6 ? angle : 0; }

}  // namespace

double Segment::extent() const noexcept { return gear == 0 ? std::fabs(angle) : length; }

Pose Segment::pose(double at) const noexcept {
  if (gear == 0) return {begin.x, begin.y, begin.yaw + (angle < 0 ? -at : at)};
  // The chord of an arc points along the mean of both yaws.
  const double driven = gear * at;
  const double half = curvature * driven / 2;
  const double shorter = std::fabs(half) < 1e-8 ? 1 : kernels::sine_cosine(exact(half)).sine / half;
  const auto [sine, cosine] = kernels::sine_cosine(exact(begin.yaw + half + angle));
  return {begin.x + driven * shorter * cosine, begin.y + driven * shorter * sine,
          begin.yaw + 2 * half};
}

Pose Segment::end() const noexcept { return pose(extent()); }

double driven_length(std::span<const Segment> segments) noexcept {
  double sum = 0;
  for (const Segment& s : segments) sum += s.length;
  return sum;
}

double cost(const Vehicle& vehicle, std::span<const Segment> segments) noexcept {
  double sum = vehicle.cusp_cost * cusps(segments);
  for (const Segment& s : segments) {
    sum += s.gear < 0   ? s.length * vehicle.reverse_cost
           : s.gear > 0 ? s.length
                        : std::fabs(s.angle) * vehicle.rotation_cost;
  }
  return sum;
}

int cusps(std::span<const Segment> segments) noexcept {
  int count = 0;
  int gear = 0;
  for (const Segment& s : segments) {
    if (s.gear == 0) continue;
    count += gear != 0 && s.gear != gear ? 1 : 0;
    gear = s.gear;
  }
  return count;
}

std::vector<PathPose> poses(std::span<const Segment> segments, double spacing) {
  constexpr double kMost = 1e8;  // poses of a segment
  require_parameter(spacing > 0, "spacing", spacing, "give a number above 0");
  std::vector<PathPose> told;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    const double extent = s.extent();
    require_parameter(extent / spacing <= kMost, "spacing", spacing,
                      "give a wider one: a segment has more than 100000000 poses");
    const int pieces = std::max(1, static_cast<int>(std::ceil(extent / spacing)));
    const bool new_gear = told.empty() || told.back().gear != s.gear;
    for (int k = new_gear ? 0 : 1; k <= pieces; ++k) {
      const double at = k == pieces ? extent : extent * k / pieces;
      // At a cusp the same pose once more, to the last digit.
      const Pose pose = k == 0 && !told.empty() ? told.back().pose : s.pose(at);
      told.push_back({pose, s.curvature, s.gear, static_cast<int>(i), at});
    }
  }
  return told;
}

}  // namespace lasius::vehicle
