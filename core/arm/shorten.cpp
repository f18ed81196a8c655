#include "core/arm/shorten.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/arm/ends.h"
#include "core/arm/robot/kinematics.h"
#include "core/base/invalid_parameter.h"
#include "kernels/base/random_stream.h"

namespace lasius::arm {
namespace {

/// From each waypoint on to one as far ahead as a straight motion goes, found by doubling and
/// halving; again until nothing is left out. A way that returns to a waypoint stays there.
Waypoints shortened(Waypoints way, CountedSensor& counted) {
  for (bool shorter = true; shorter && !counted.stopped();) {
    Waypoints kept{way.front()};
    for (std::size_t i = 0; i + 1 < way.size();) {
      std::size_t good = 1, bad = way.size() - i;  // ahead of i
      for (std::size_t step = 2; step < bad; step *= 2)
        (counted.motion_free(way[i], way[i + step]) ? good : bad) = step;
      while (bad - good > 1) {
        const std::size_t middle = good + (bad - good) / 2;
        (counted.motion_free(way[i], way[i + middle]) ? good : bad) = middle;
      }
      i += good;
      if (way[i] != kept.back()) kept.push_back(way[i]);
    }
    shorter = kept.size() < way.size();
    way = std::move(kept);
  }
  return way;
}

/// Tries straight motions between two points drawn at random along the way (Geraerts & Overmars
/// 2007), and keeps those that are free and shorter than the way between, or make it quicker.
Waypoints cut_at_random(const Robot& robot, const TrajectoryOptions& options, Waypoints way,
                        CountedSensor& counted,
                        const std::function<double(const Waypoints&)>& seconds = {}) {
  constexpr std::uint32_t kUse = 2, kSeconds = 4;  // of random streams
  constexpr double kLeastGain = 1e-3;
  kernels::RandomStream words(options.seed, 0, 0, seconds ? kSeconds : kUse);
  double least = seconds ? seconds(way) : 0;
  for (int i = 0; i < options.shortcuts && way.size() > 2; ++i) {
    if (counted.poll() || counted.stopped()) break;  // most draws ask nothing
    std::vector<double> until{0};
    for (std::size_t k = 1; k < way.size(); ++k)
      until.push_back(until.back() + far(robot, options.quick, way[k - 1], way[k]));
    std::array<double, 2> at{};
    for (double& place : at) place = (words.next() + 0.5) * 0x1p-32 * until.back();
    if (at[0] > at[1]) std::swap(at[0], at[1]);
    std::array<std::size_t, 2> after{};
    std::array<JointVector, 2> ends;
    for (int e = 0; e < 2; ++e) {
      const auto k = std::upper_bound(until.begin() + 1, until.end() - 1, at[e]) - until.begin();
      const double share = (at[e] - until[k - 1]) / (until[k] - until[k - 1]);
      after[e] = static_cast<std::size_t>(k);
      ends[e] = way[k - 1] + share * (way[k] - way[k - 1]);
    }
    const double gain = at[1] - at[0] - far(robot, options.quick, ends[0], ends[1]);
    if (after[0] == after[1] || !(seconds || gain > kLeastGain * until.back())) continue;
    Waypoints shorter(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(after[0]));
    shorter.insert(shorter.end(), ends.begin(), ends.end());
    shorter.insert(shorter.end(), way.begin() + static_cast<std::ptrdiff_t>(after[1]), way.end());
    const double quicker = seconds ? seconds(shorter) : 0;
    if (seconds && !(quicker < (1 - kLeastGain) * least)) continue;
    if (!counted.motion_free(ends[0], ends[1])) continue;
    least = quicker;
    way = std::move(shorter);
  }
  return way;
}

}  // namespace

double far(const Robot& robot, bool quick, const JointVector& a, const JointVector& b) {
  double most = 0, sum = 0;
  for (int j = 0; j < robot.size(); ++j) {
    const double change = std::abs(b[j] - a[j]);
    most = std::max(most, change / robot.joints[j].velocity);
    sum += change * change;
  }
  return quick ? most : std::sqrt(sum);
}

Waypoints waypoints_of(const Robot& robot, const Eigen::Ref<const Eigen::MatrixXd>& waypoints) {
  validate_but_corners(robot);
  for (Eigen::Index i = 0; i < waypoints.cols(); ++i) {
    const std::string fault =
        values_fault(robot, waypoints.col(i), "waypoint " + std::to_string(i + 1), 1e-9);
    if (!fault.empty()) refuse(fault, "bring it within them");
  }
  Waypoints way;
  for (const auto q : waypoints.colwise())
    if (way.empty() || q != way.back()) way.emplace_back(q);
  return way;
}

Waypoints shorter_way(const Robot& robot, const TrajectoryOptions& options, Waypoints way,
                      CountedSensor& counted) {
  if (options.shortcut) way = shortened(std::move(way), counted);
  way = cut_at_random(robot, options, std::move(way), counted);
  // Shortcuts leave corners that others made idle; splines are laid through all, as ever.
  if (options.shortcut && options.shortcuts > 0 && options.timing == Timing::optimal)
    way = shortened(std::move(way), counted);
  return way;
}

Waypoints quicker_way(const Robot& robot, const TrajectoryOptions& options, Waypoints way,
                      CountedSensor& counted,
                      const std::function<double(const Waypoints&)>& seconds) {
  return cut_at_random(robot, options, std::move(way), counted, seconds);
}

Eigen::MatrixXd shorten_way(const Robot& robot, const Sensor& sensor,
                            const Eigen::Ref<const Eigen::MatrixXd>& waypoints,
                            const TrajectoryOptions& options) {
  const Waypoints given = waypoints_of(robot, waypoints);
  CountedSensor counted(robot, sensor, options);
  if (given.empty()) return waypoints;
  const Waypoints way = shorter_way(robot, options, given, counted);
  Eigen::MatrixXd columns(robot.size(), std::ssize(way));
  for (Eigen::Index i = 0; i < columns.cols(); ++i) columns.col(i) = way[i];
  return columns;
}

}  // namespace lasius::arm
