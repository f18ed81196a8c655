#include "core/arm/rounded_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/blends.h"
#include "core/arm/timing.h"

namespace lasius::arm {
namespace {

constexpr int kSteps = 32;    // of a parabola
constexpr int kHalvings = 6;  // of one, before the arm rests at the corner

std::vector<double> largest_blends(const Waypoints& way) {
  std::vector<double> sizes(way.size(), 0);
  for (std::size_t i = 1; i + 1 < way.size(); ++i) sizes[i] = largest_blend(way, i);
  return sizes;
}

Trajectory joined(std::vector<TimedRun>& runs) {
  if (runs.size() == 1) return std::move(runs[0].motion);
  std::vector<Trajectory::Knot> knots;
  double begin = 0;
  for (const TimedRun& run : runs) {
    for (Trajectory::Knot knot : run.motion.knots()) {
      if (!knots.empty() && knot.time == 0 && knot.ddq == knots.back().ddq) continue;
      knot.time += begin;
      knots.push_back(std::move(knot));
    }
    begin = knots.back().time;
  }
  return Trajectory(std::move(knots));
}

}  // namespace

double seconds_at_best(const Robot& robot, const Waypoints& way) {
  constexpr int kFew = 4;
  double seconds = 0;
  for (const PathRun& run : rounded(way, largest_blends(way)))
    seconds += in_least_time(robot, run, kFew).motion.duration();
  return seconds;
}

Trajectory rounded_motion(const Robot& robot, Waypoints way, CountedSensor& counted, bool& stops) {
  way.erase(std::unique(way.begin(), way.end()), way.end());
  std::vector<double> sizes = largest_blends(way);
  const auto least = [&](std::size_t i) { return std::ldexp(largest_blend(way, i), -kHalvings); };
  const auto smaller = [&](std::size_t i) {
    sizes[i] = counted.stopped() || sizes[i] <= least(i) ? 0 : 0.5 * sizes[i];
  };
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    while (sizes[i] > 0) {
      const PathPiece piece = blend_at(way, i, sizes[i]);
      const Trajectory evenly(
          {{0, piece.start, piece.bend}, {piece.length, piece.at(piece.length), piece.bend}});
      if (counted.curve_free(evenly, 0, piece.length)) break;
      smaller(i);
    }
  }
  const bool jerk =
      std::ranges::any_of(robot.joints, [](const Joint& joint) { return joint.jerk > 0; });
  std::vector<TimedRun> runs;
  for (bool changed = true; changed;) {
    changed = false;
    runs.clear();
    std::size_t corner = 0;
    for (const PathRun& run : rounded(way, sizes)) {
      runs.push_back(in_least_time(robot, run, kSteps));
      if (jerk) runs.back() = smoothed(robot, runs.back());
      for (const auto& [from, to] : runs.back().blends) {
        do ++corner;
        while (sizes[corner] == 0);
        if (counted.curve_free(runs.back().motion, from, to)) continue;
        smaller(corner);
        changed = true;
      }
    }
  }
  stops = way.size() > 2 && std::ranges::all_of(sizes, [](double size) { return size == 0; });
  return joined(runs);
}

}  // namespace lasius::arm
