#include "core/arm/rounded_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/blends.h"
#include "core/arm/spline.h"
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
  // Over all of its length as one: per radian a short one's bend is beyond all bounds.
  const auto parabola_free = [&](std::size_t i) {
    const PathPiece piece = blend_at(way, i, sizes[i]);
    const JointVector bend = piece.length * piece.length * piece.bend;
    return counted.curve_free(
        Trajectory({{0, piece.start, bend}, {1, piece.at(piece.length), bend}}), 0, 1);
  };
  const bool jerk =
      std::ranges::any_of(robot.joints, [](const Joint& joint) { return joint.jerk > 0; });
  std::vector<Trajectory> motions;
  for (bool changed = true; changed;) {
    // Once it is told to stop the resting motion is made, and nothing else.
    const bool rests = counted.stopped();
    if (rests) std::ranges::fill(sizes, 0.0);
    changed = false;
    motions.clear();
    std::size_t corner = 0;
    for (const PathRun& run : rounded(way, sizes)) {
      TimedRun timed = in_least_time(robot, run, kSteps);
      if (jerk) timed = smoothed(robot, timed, [&] { return counted.poll(); });
      for (const auto& [from, to] : timed.blends) {
        do ++corner;
        while (sizes[corner] == 0);
        if (counted.curve_free(timed.motion, from, to)) continue;
        do smaller(corner);
        while (sizes[corner] > 0 && !parabola_free(corner));
        changed = true;
      }
      motions.push_back(std::move(timed.motion));
      if (!rests && counted.stopped()) {
        changed = true;
        break;
      }
    }
  }
  stops = way.size() > 2 && std::ranges::all_of(sizes, [](double size) { return size == 0; });
  std::vector<Trajectory::Knot> knots = joined(motions).knots();
  knots.front().q = way.front();  // whatever rounding says
  knots.back().q = way.back();
  return Trajectory(std::move(knots));
}

}  // namespace lasius::arm
