#include "lasius/vehicle/profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/invalid_parameter.h"

namespace lasius::vehicle {
namespace {

/// What holds inside one segment: constant, so that speeding up, cruising and braking are exact.
struct Piece {
  double extent, most, up, down;  // most: of the squared speed
};

Piece piece_of(const Segment& s, const SpeedLimits& limits) noexcept {
  if (s.gear == 0) {
    return {s.extent(), limits.turn_rate * limits.turn_rate, limits.turn_acceleration,
            limits.turn_acceleration};
  }
  const double speed = s.gear > 0 ? limits.speed : limits.reverse_speed;
  double most = speed * speed;
  if (const double bent = s.sharpest(); bent != 0)
    most = std::min(most, limits.lateral_acceleration / bent);
  return {s.length, most, limits.acceleration, limits.braking};
}

/// What is gained at most in squared speed over an extent; without a limit all, from rest, too.
double gain(double rate, double extent) noexcept {
  return std::isinf(rate) ? rate : 2 * rate * extent;
}

/// A drive through a piece from a squared speed to another: where speeding up ends, where braking
/// begins, and the squared speed between.
struct Drive {
  double up_to, down_from, peak;
};
Drive drive(const Piece& p, double from, double to) noexcept {
  double peak = p.most;
  const bool at_once_up = std::isinf(p.up);
  const bool at_once_down = std::isinf(p.down);
  if (!at_once_up && !at_once_down) {
    // Where both ramps meet.
    peak = std::min(peak,
                    (2 * p.up * p.down * p.extent + p.down * from + p.up * to) / (p.up + p.down));
  } else if (!at_once_up) {
    peak = std::min(peak, from + 2 * p.up * p.extent);
  } else if (!at_once_down) {
    peak = std::min(peak, to + 2 * p.down * p.extent);
  }
  peak = std::max({peak, from, to});
  const double up = at_once_up ? 0 : (peak - from) / (2 * p.up);
  const double down = at_once_down ? 0 : (peak - to) / (2 * p.down);
  return {std::min(up, p.extent), std::max(std::min(up, p.extent), p.extent - down), peak};
}

/// Seconds to drive `way` from a squared speed at a rate that ends at another.
double ramp(double way, double from, double to) noexcept {
  const double sum = std::sqrt(from) + std::sqrt(to);
  return way > 0 ? 2 * way / sum : 0;
}

/// Squared speed and time at `at` in a piece.
std::pair<double, double> inside(const Piece& p, double from, double to, double at) noexcept {
  const Drive d = drive(p, from, to);
  if (at < d.up_to) {
    const double squared = from + 2 * p.up * at;
    return {squared, ramp(at, from, squared)};
  }
  double time = ramp(d.up_to, from, d.peak);
  if (at <= d.down_from) {
    return {d.peak, time + (at > d.up_to ? (at - d.up_to) / std::sqrt(d.peak) : 0)};
  }
  if (d.down_from > d.up_to) time += (d.down_from - d.up_to) / std::sqrt(d.peak);
  const double squared = std::max(0.0, to + 2 * p.down * (p.extent - at));
  return {squared, time + ramp(at - d.down_from, d.peak, squared)};
}

}  // namespace

Profile::Profile(std::vector<Segment> segments, const SpeedLimits& limits)
    : segments_(std::move(segments)), limits_(limits) {
  const auto require = [](double value, const char* name, bool finite) {
    require_parameter(value > 0 && !(finite && std::isinf(value)), name, value,
                      finite ? "give a finite number above 0" : "give a number above 0");
  };
  require(limits.speed, "speed", true);
  require(limits.reverse_speed, "reverse_speed", true);
  require(limits.turn_rate, "turn_rate", true);
  require(limits.acceleration, "acceleration", false);
  require(limits.braking, "braking", false);
  require(limits.lateral_acceleration, "lateral_acceleration", false);
  require(limits.turn_acceleration, "turn_acceleration", false);
  const std::size_t n = segments_.size();
  std::vector<Piece> pieces;
  for (const Segment& s : segments_) pieces.push_back(piece_of(s, limits_));
  speed_.assign(n + 1, 0);
  for (std::size_t i = 1; i < n; ++i) {
    const Segment& before = segments_[i - 1];
    const bool rest = before.gear != segments_[i].gear || segments_[i].gear == 0 ||
                      before.angle != segments_[i].angle ||
                      (limits_.steady_curvature && corners(std::span(&before, 2)) > 0);
    if (rest) continue;
    speed_[i] = std::min({pieces[i - 1].most, pieces[i].most,
                          speed_[i - 1] + gain(pieces[i - 1].up, pieces[i - 1].extent)});
  }
  for (std::size_t i = n; i-- > 0;) {
    speed_[i] = std::min(speed_[i], speed_[i + 1] + gain(pieces[i].down, pieces[i].extent));
  }
  time_.assign(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    time_[i + 1] = time_[i] + inside(pieces[i], speed_[i], speed_[i + 1], pieces[i].extent).second;
  }
}

double Profile::duration() const noexcept { return time_.back(); }

TimedPose Profile::state(int segment, double at) const {
  const auto i = static_cast<std::size_t>(segment);
  const Segment& s = segments_[i];
  const auto [squared, time] = inside(piece_of(s, limits_), speed_[i], speed_[i + 1], at);
  return {
      {s.pose(at), s.curvature_at(at), s.gear, segment, at}, std::sqrt(squared), time_[i] + time};
}

std::vector<TimedPose> Profile::samples(double spacing) const {
  std::vector<TimedPose> told;
  for (const PathPose& p : poses(segments_, spacing)) {
    told.push_back(state(p.segment, p.at));
    told.back().at = p;
  }
  return told;
}

}  // namespace lasius::vehicle
