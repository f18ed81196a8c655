#include "core/drive/rejoin.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "core/disc/arc.h"

namespace lasius {
namespace {

constexpr std::size_t kVertices = 16;  // that are looked at

Point between(Point a, Point b, double share) noexcept {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// The share of a side at which it is nearest to a point.
double nearest_share(Point a, Point b, Point p) noexcept {
  const Point side{b.x - a.x, b.y - a.y};
  const double square = side.x * side.x + side.y * side.y;
  if (square == 0) return 0;
  return std::clamp(((p.x - a.x) * side.x + (p.y - a.y) * side.y) / square, 0.0, 1.0);
}

/// A place on a side that the disc sees, from the side's end back to its foot.
std::optional<Point> seen_on_side(const disc::DiscSpace& space, Point robot, Point foot,
                                  Point end) {
  // Sides around an arc hide their ends from what is beside them, but not what is across.
  for (double share = 0.5; share > 1e-3; share /= 2)
    if (const Point at = between(foot, end, share); space.sees(robot, at)) return at;
  return foot == robot || space.sees(robot, foot) ? std::optional(foot) : std::nullopt;
}

}  // namespace

bool rejoin(const disc::DiscSpace& space, Point robot, std::vector<Point>& path) {
  const std::size_t last = std::min(path.size() - 1, kVertices);
  std::size_t before = 0;  // the robot is beside the side that begins there
  Point foot = path[0];
  for (std::size_t i = 0; i < last; ++i) {
    const Point at = between(path[i], path[i + 1], nearest_share(path[i], path[i + 1], robot));
    if (distance(at, robot) > distance(foot, robot)) continue;
    foot = at;
    before = i;
  }
  std::size_t next = last;
  while (next > before && !space.sees(robot, path[next])) --next;
  std::optional<Point> joint;
  if (next == before) {
    joint = seen_on_side(space, robot, foot, path[++next]);
    if (!joint) return false;
  }
  path.erase(path.begin() + 1, path.begin() + static_cast<std::ptrdiff_t>(next));
  path.front() = robot;
  if (joint && *joint != robot) path.insert(path.begin() + 1, *joint);
  return true;
}

}  // namespace lasius
