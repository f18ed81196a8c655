// How far two convex sets are apart, by their support points (Gilbert, Johnson & Keerthi 1988).
//
// Only a plane that keeps the two apart is believed: each support point gives one, so what is
// returned is never above the true distance, however well the search for it went.
#pragma once

#include <algorithm>

#include "core/arm/robot/vec3.h"

namespace lasius::arm {

/// Up to four differences of points of two sets.
struct GjkSimplex {
  std::array<Vec3, 4> point;
  int count = 0;

  void keep(Vec3 a) noexcept { point[0] = a, count = 1; }
  void keep(Vec3 a, Vec3 b) noexcept { point[0] = a, point[1] = b, count = 2; }
  void keep(Vec3 a, Vec3 b, Vec3 c) noexcept {
    point[0] = a, point[1] = b, point[2] = c, count = 3;
  }
};

/// The point of a simplex nearest to the origin; leaves those of its corners that make it. Four are
/// left where the origin is inside.
Vec3 nearest_point(GjkSimplex& simplex) noexcept;

/// What is asked of two sets: their distance, or only whether they are so far apart.
enum class GjkAsked { distance, decision };

/// Metres between two sets where that is below `enough`, too small by at most a millionth of it and
/// 1e-9 where the distance is asked for; else a value from `enough` on that is not above it.
/// `support_a(d)` is a point of one that is furthest along d, `support_b` of the other; `guess` is
/// a difference of their points.
template <GjkAsked asked, class A, class B>
double gjk_apart(const A& support_a, const B& support_b, Vec3 guess, double enough) noexcept {
  constexpr int kMostSteps = 64;
  Vec3 to = guess;  // of the differences of their points the nearest to 0 so far
  double apart = 0, size = length(to);
  GjkSimplex simplex;
  for (int i = 0; i < kMostSteps && size > 1e-12; ++i) {
    const Vec3 next = support_a(-1.0 * to) - support_b(to);
    apart = std::max(apart, dot(next, to) / size);
    if (apart >= enough || size - apart <= 1e-6 * size + 1e-9) break;
    // A plane cannot keep them further apart than they are.
    if (asked == GjkAsked::decision && i > 0 && size < enough) break;
    for (int k = 0; k < simplex.count; ++k)
      if (simplex.point[k] == next) return apart;
    simplex.point[simplex.count++] = next;
    to = nearest_point(simplex);
    const double smaller = length(to);
    if (simplex.count == 4 || (i > 0 && !(smaller < size))) break;  // inside, or rounding
    size = smaller;
  }
  return apart;
}

}  // namespace lasius::arm
