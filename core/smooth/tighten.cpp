#include "core/smooth/tighten.h"

#include <algorithm>
#include <cmath>

#include "core/base/poller.h"

namespace lasius {
namespace {

constexpr int kCuts = 4;       // of a vertex, each into two
constexpr int kHalvings = 14;  // of a side, to find how far it is in sight

Point between(Point a, Point b, double share) noexcept {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// The largest share in [0, 1] of which `fits`, as far as halving tells, and a step less, since
/// what just fits may take all of the slack that sight allows; it fits 0.
template <class Fits>
double largest(const Fits& fits) {
  if (fits(1.0)) return 1;
  double low = 0;
  const double last = std::ldexp(1.0, -kHalvings);
  for (double step = 0.5; step >= last; step /= 2)
    if (fits(low + step)) low += step;
  return std::max(0.0, low - last);
}

/// Moves each vertex along the side that follows, and leaves out those that come to its end.
void slide(const disc::DiscSpace& space, Poller& poller, std::vector<Point>& path) {
  std::size_t kept = 1;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point b = path[i];
    if (i + 1 < path.size() && !poller.stop_after(256)) {
      const Point c = path[i + 1];
      const double share = largest(
          [&](double part) { return space.reaches_well(path[kept - 1], between(b, c, part)); });
      if (share == 1) continue;
      path[kept++] = between(b, c, share);
    } else {
      path[kept++] = b;
    }
  }
  path.resize(kept);
}

/// Puts two vertices in the place of each at which the path turns.
void cut(const disc::DiscSpace& space, Poller& poller, std::vector<Point>& path) {
  constexpr double kStraight = 1 - 1e-4;  // a cosine
  std::vector<Point> cut(1, path.front());
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Point a = path[i - 1], b = path[i], c = path[i + 1];
    const double before = distance(a, b), after = distance(b, c);
    const double along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    const double deepest = std::min(before, after) / 2;
    const auto from = [&](double share) { return between(b, a, share * deepest / before); };
    const auto to = [&](double share) { return between(b, c, share * deepest / after); };
    const double share =
        along > kStraight * before * after || poller.stop_after(256)
            ? 0
            : largest([&](double part) { return space.reaches_well(from(part), to(part)); });
    if (share > 0) {
      cut.push_back(from(share));
      cut.push_back(to(share));
    } else {
      cut.push_back(b);
    }
  }
  cut.push_back(path.back());
  path = std::move(cut);
}

}  // namespace

void tighten(const disc::DiscSpace& space, const StopCondition& stop, std::vector<Point>& path) {
  Poller poller(stop);
  for (int i = 0; i <= kCuts && path.size() > 2 && !poller.stopped(); ++i) {
    if (i > 0) cut(space, poller, path);
    for (int pass = 0; pass < 4; ++pass) {
      slide(space, poller, path);
      std::ranges::reverse(path);
    }
  }
}

}  // namespace lasius
