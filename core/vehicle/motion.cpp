#include "lasius/vehicle/motion.h"

#include <algorithm>
#include <cmath>

#include "core/base/invalid_parameter.h"
#include "core/vehicle/angle.h"

namespace lasius::vehicle {

namespace {

/// Angles beyond what sines are exact for have none: 0 in place of them, and of what is no number.
double exact(double angle) noexcept { return std::fabs(angle) <= 1e6 ? angle : 0; }

/// By Gauss & Legendre's formula of eight places for each piece that turns by less than half a
/// radian: to the last digits.
Pose clothoid(const Segment& s, double driven) noexcept {
  constexpr double kPlace[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                0.9602898564975363};
  constexpr double kShare[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                0.1012285362903763};
  const double most =
      std::max(std::fabs(s.curvature), std::fabs(s.curvature + s.curvature_rate * driven));
  const int pieces = static_cast<int>(std::min(1e6, 1 + 2 * most * std::fabs(driven)));
  const auto yaw = [&](double at) {
    return s.begin.yaw + at * (s.curvature + s.curvature_rate * at / 2);
  };
  const double half = driven / pieces / 2;
  Pose to{s.begin.x, s.begin.y, yaw(driven)};
  for (int i = 0; i < pieces; ++i) {
    for (int k = 0; k < 4; ++k) {
      for (const double side : {-1.0, 1.0}) {
        const double at = half * (2 * i + 1 + side * kPlace[k]);
        const auto [sine, cosine] = kernels::sine_cosine(exact(yaw(at)));
        to.x += half * kShare[k] * cosine;
        to.y += half * kShare[k] * sine;
      }
    }
  }
  return to;
}

}  // namespace

double Segment::extent() const noexcept { return gear == 0 ? std::fabs(angle) : length; }

Pose Segment::pose(double at) const noexcept {
  if (gear == 0) return {begin.x, begin.y, begin.yaw + (angle < 0 ? -at : at)};
  const double driven = gear * at;
  if (curvature_rate != 0) return clothoid(*this, driven);
  // The chord of an arc points along the mean of both yaws.
  const double half = curvature * driven / 2;
  const double shorter = std::fabs(half) < 1e-8 ? 1 : kernels::sine_cosine(exact(half)).sine / half;
  const auto [sine, cosine] = kernels::sine_cosine(exact(begin.yaw + half + angle));
  return {begin.x + driven * shorter * cosine, begin.y + driven * shorter * sine,
          begin.yaw + 2 * half};
}

double Segment::curvature_at(double at) const noexcept {
  return curvature + gear * curvature_rate * at;
}

double Segment::sharpest() const noexcept {
  return std::max(std::fabs(curvature), std::fabs(curvature_at(length)));
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

int corners(std::span<const Segment> segments) noexcept {
  constexpr double kSame = 1e-9;
  int count = 0;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    const Segment &a = segments[i - 1], &b = segments[i];
    const bool jumps = std::fabs(a.curvature_at(a.length) - b.curvature) > kSame;
    count += jumps && a.gear != 0 && a.gear == b.gear ? 1 : 0;
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
    const int pieces = static_cast<int>(std::ceil(extent / spacing));
    const bool new_gear = told.empty() || told.back().gear != s.gear;
    for (int k = new_gear ? 0 : 1; k <= pieces; ++k) {
      const double at = k == pieces ? extent : extent * k / pieces;
      // At a cusp the same pose once more, to the last digit.
      const Pose pose = k == 0 && !told.empty() ? told.back().pose : s.pose(at);
      told.push_back({pose, s.curvature_at(at), s.gear, static_cast<int>(i), at});
    }
  }
  return told;
}

}  // namespace lasius::vehicle
