// A dense check of poses that shares nothing with the library: separating axes of the footprint's
// convex parts and of every blocked cell near.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "lasius/grid/grid.h"
#include "lasius/vehicle/planner.h"

namespace lasius::vehicle {

inline constexpr int kSide = 160;
inline const StopCondition kGoesOn;

inline Grid blobs(std::uint64_t seed, int count) {
  Grid grid(kSide, kSide - 30);
  std::mt19937_64 random(seed);
  for (int i = 0; i < count; ++i) {
    const int w = 1 + static_cast<int>(random() % 6);
    const int h = 1 + static_cast<int>(random() % 6);
    grid.fill({static_cast<int>(random() % (kSide - w)),
               static_cast<int>(random() % (kSide - 30 - h)), w, h},
              true);
  }
  return grid;
}

/// A free pose, and a request from one to another.
inline Pose random_whole(const Space& space, std::mt19937_64& random) {
  Pose pose;
  do {
    pose = {static_cast<double>(random() % kSide), static_cast<double>(random() % 120),
            static_cast<double>(random() % 6)};
  } while (!space.free(pose));
  return pose;
}
inline Request random_request(const Space& space, std::mt19937_64& random) {
  Request request{.start = random_whole(space, random), .goals = {}};
  request.goals.push_back(random_whole(space, random));
  return request;
}

using Part = std::vector<Point>;

inline bool apart(const Part& a, const Part& b) {
  for (const auto& [of, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (std::size_t i = 0; i < of->size(); ++i) {
      const Point p = (*of)[i];
      const Point q = (*of)[(i + 1) % of->size()];
      const double nx = q.y - p.y;
      const double ny = p.x - q.x;  // outwards where the corners go round by growing yaw
      double most = -1e300;
      double least = 1e300;
      for (const Point& v : *of) most = std::max(most, (v.x - p.x) * nx + (v.y - p.y) * ny);
      for (const Point& v : *other) least = std::min(least, (v.x - p.x) * nx + (v.y - p.y) * ny);
      if (least > most) return true;
    }
  }
  return false;
}

inline bool touches(const Grid& grid, const std::vector<Part>& parts, const Pose& pose) {
  for (const Part& part : parts) {
    Part placed;
    Point low{1e9, 1e9};
    Point high{-1e9, -1e9};
    for (const Point& p : part) {
      const Point q{pose.x + p.x * std::cos(pose.yaw) - p.y * std::sin(pose.yaw),
                    pose.y + p.x * std::sin(pose.yaw) + p.y * std::cos(pose.yaw)};
      placed.push_back(q);
      low = {std::min(low.x, q.x), std::min(low.y, q.y)};
      high = {std::max(high.x, q.x), std::max(high.y, q.y)};
    }
    for (int y = static_cast<int>(std::floor(low.y)) - 1; y <= high.y + 1; ++y) {
      for (int x = static_cast<int>(std::floor(low.x)) - 1; x <= high.x + 1; ++x) {
        if (!grid.blocked({x, y})) continue;
        const double cx = x;
        const double cy = y;
        if (!apart(placed, {{cx, cy}, {cx + 1, cy}, {cx + 1, cy + 1}, {cx, cy + 1}})) return true;
      }
    }
  }
  return false;
}

}  // namespace lasius::vehicle
