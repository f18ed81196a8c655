// Tours of vehicles by the plans of all pairs, and where they go.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "lasius/vehicle/tour.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {

/// The least length over all orders (that begin with the first stop, where it is the start) and
/// given poses of stops, by the plans of all pairs.
inline double least(const Planner& planner, const std::vector<std::vector<Pose>>& stops, bool open,
                    bool from_first = false) {
  std::vector<Pose> poses;
  std::vector<std::vector<std::size_t>> at;
  for (const auto& stop : stops) {
    at.emplace_back();
    for (const Pose& pose : stop) {
      at.back().push_back(poses.size());
      poses.push_back(pose);
    }
  }
  const std::size_t n = poses.size();
  std::vector<double> lengths(n * n, 1e9);
  for (std::size_t s = 0; s < stops.size(); ++s)
    for (std::size_t t = 0; t < stops.size(); ++t)
      for (const std::size_t a : at[s])
        for (const std::size_t b : at[t]) {
          if (s == t) continue;
          const Result plan = planner.plan({.start = poses[a], .goals = {poses[b]}});
          if (plan.goal >= 0) lengths[a * n + b] = plan.length;
        }
  std::vector<std::size_t> order(stops.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  double best = 1e9;
  do {
    if (from_first && order.front() != 0) continue;
    std::vector<std::size_t> turn(stops.size(), 0);
    for (bool more = true; more;) {
      double sum = 0;
      for (std::size_t i = 0; i + (open ? 1 : 0) < order.size(); ++i) {
        const std::size_t s = order[i], t = order[(i + 1) % order.size()];
        sum += lengths[at[s][turn[s]] * n + at[t][turn[t]]];
      }
      best = std::min(best, sum);
      more = false;
      for (std::size_t s = 0; s < stops.size() && !more; ++s) {
        more = ++turn[s] < at[s].size();
        if (!more) turn[s] = 0;
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

inline Vehicle truck() {
  Vehicle vehicle = car(rectangle(1, 3, 1.25), 4);
  vehicle.reverse = false;
  return vehicle;
}

/// Free headings.
inline std::vector<Pose> headings(const Planner& planner, const Point p) {
  std::vector<Pose> poses;
  for (int h = 0; h < kTourHeadings; ++h)
    if (const Pose pose{p.x, p.y, h * 2 * std::numbers::pi / kTourHeadings};
        planner.space().free(pose))
      poses.push_back(pose);
  return poses;
}

/// A pocket that opens to the right; most headings of a truck in it have no way there.
inline Grid pocket() {
  Grid grid = walled(60, 50, {{28, 15, 6, 1}, {28, 16, 1, 19}, {28, 35, 6, 1}});
  return grid;
}

}  // namespace lasius::vehicle
