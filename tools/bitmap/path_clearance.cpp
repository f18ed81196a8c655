#include "tools/bitmap/path_clearance.h"

#include <algorithm>
#include <cmath>

namespace lasius::tool {
namespace {

/// Points of a polyline at even distances, its ends among them.
std::vector<Point> spread(const std::vector<Point>& path, int count, double step) {
  std::vector<Point> samples{path.front()};
  double walked = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point a = path[i - 1], b = path[i];
    const double far = std::hypot(b.x - a.x, b.y - a.y);
    while (static_cast<int>(samples.size()) < count &&
           step * static_cast<double>(samples.size()) <= walked + far && far > 0) {
      const double t = (step * static_cast<double>(samples.size()) - walked) / far;
      samples.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    walked += far;
  }
  samples.push_back(path.back());
  return samples;
}

}  // namespace

double distance_to_blocked(const Grid& grid, Point at, double most) {
  return nearest_blocked(grid, at, most).distance;
}

ClearanceAlong clearance_along(const Grid& grid, const std::vector<Point>& path, double length) {
  const int count = std::clamp(static_cast<int>(std::ceil(std::min(2 * length, 1e6))), 1,
                               ClearanceAlong::kMostSamples);
  ClearanceAlong along{.step = length / count, .values = {}};
  for (const Point at : spread(path, count, along.step))
    along.values.push_back(distance_to_blocked(grid, at));
  return along;
}

}  // namespace lasius::tool
