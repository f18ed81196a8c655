#include "core/arm/enclose.h"

#include <algorithm>
#include <cmath>

namespace lasius::arm {

std::vector<Capsule> enclose_box(const Placement& pose, Vec3 size) {
  // Axes by falling size: the capsules run along the first, side by side along the second.
  struct Side {
    Vec3 along;
    double size;
  };
  std::array<Side, 3> sides{Side{{1, 0, 0}, size.x}, Side{{0, 1, 0}, size.y},
                            Side{{0, 0, 1}, size.z}};
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& a, const Side& b) { return a.size > b.size; });
  const auto [longest, middle, shortest] = sides;
  const int count =
      std::clamp(static_cast<int>(std::ceil(middle.size / std::max(shortest.size, 1e-9))), 1, 4);
  const double width = middle.size / count;
  const double radius = 0.5 * std::sqrt(width * width + shortest.size * shortest.size);
  std::vector<Capsule> capsules;
  for (int i = 0; i < count; ++i) {
    // The ends of the box stick out of flat-ended capsules of this length by nothing.
    const Vec3 across = (width * (i + 0.5) - 0.5 * middle.size) * middle.along;
    const Vec3 half = (0.5 * longest.size) * longest.along;
    capsules.push_back({pose * (across - half), pose * (across + half), radius});
  }
  return capsules;
}

}  // namespace lasius::arm
