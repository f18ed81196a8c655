#include "core/arm/convex.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lasius::arm {
namespace {

Vec3 support(const Block& block, Vec3 direction) noexcept { return block.support(direction); }
Vec3 support(const Triangle& triangle, Vec3 direction) noexcept {
  const double a = dot(triangle[0], direction), b = dot(triangle[1], direction),
               c = dot(triangle[2], direction);
  return a >= b && a >= c ? triangle[0] : b >= c ? triangle[1] : triangle[2];
}
Vec3 middle(const Block& block) noexcept { return block.pose.position; }
Vec3 middle(const Triangle& t) noexcept { return (1.0 / 3) * (t[0] + t[1] + t[2]); }

/// Up to four points, of which the last search needed all.
struct Simplex {
  std::array<Vec3, 4> points;
  int count = 0;

  bool holds(Vec3 p) const noexcept {
    return std::find(points.begin(), points.begin() + count, p) != points.begin() + count;
  }
};

/// A point of a simplex, and those of its corners that make it.
struct Nearest {
  Vec3 point;
  Simplex of;
};

double square(Vec3 v) noexcept { return dot(v, v); }
const Nearest& nearer(const Nearest& a, const Nearest& b) noexcept {
  return square(b.point) < square(a.point) ? b : a;
}

Nearest nearest_of(Vec3 a) noexcept { return {a, {{a}, 1}}; }

Nearest nearest_of(Vec3 a, Vec3 b) noexcept {
  const Vec3 d = b - a;
  const double whole = square(d), share = -dot(a, d);
  if (!(share > 0)) return nearest_of(a);
  if (share >= whole) return nearest_of(b);
  return {a + (share / whole) * d, {{a, b}, 2}};
}

Nearest nearest_of(Vec3 a, Vec3 b, Vec3 c) noexcept {
  const Vec3 normal = cross(b - a, c - a);
  const double area = square(normal);
  // The origin's foot on the plane, by the areas that it makes with the sides.
  const double u = dot(cross(b, c), normal), v = dot(cross(c, a), normal),
               w = dot(cross(a, b), normal);
  if (area > 0 && u > 0 && v > 0 && w > 0)
    return {(dot(a, normal) / area) * normal, {{a, b, c}, 3}};
  return nearer(nearer(nearest_of(a, b), nearest_of(b, c)), nearest_of(c, a));
}

Nearest nearest_of(const std::array<Vec3, 4>& p) noexcept {
  constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}};
  Nearest best{{}, {p, 4}};  // inside
  bool inside = true;
  for (const auto& [i, j, k, opposite] : kFaces) {
    const Vec3 a = p[i], normal = cross(p[j] - a, p[k] - a);
    if (dot(normal, a) * dot(normal, p[opposite] - a) < 0) continue;  // on the inner side
    const Nearest face = nearest_of(a, p[j], p[k]);
    best = inside ? face : nearer(best, face);
    inside = false;
  }
  return best;
}

Nearest nearest_of(const Simplex& s) noexcept {
  const auto& p = s.points;
  switch (s.count) {
    case 1:
      return nearest_of(p[0]);
    case 2:
      return nearest_of(p[0], p[1]);
    case 3:
      return nearest_of(p[0], p[1], p[2]);
    default:
      return nearest_of(p);
  }
}

template <class A, class B>
double between(const A& a, const B& b, double enough) noexcept {
  constexpr int kMostSteps = 100;
  Vec3 to = middle(a) - middle(b);  // of the differences of their points the nearest to 0 so far
  double apart = 0, size = length(to);
  Simplex simplex;
  for (int i = 0; i < kMostSteps && size > 1e-12; ++i) {
    const Vec3 back = -1.0 * to;
    const Vec3 next = support(a, back) - support(b, to);
    apart = std::max(apart, dot(next, to) / size);
    if (apart >= enough || size - apart <= 1e-6 * size + 1e-9 || simplex.holds(next)) break;
    simplex.points[simplex.count++] = next;
    const Nearest nearest = nearest_of(simplex);
    const double smaller = length(nearest.point);
    if (i > 0 && !(smaller < size)) break;  // rounding: no further
    to = nearest.point;
    simplex = nearest.of;
    size = smaller;
    if (simplex.count == 4) break;
  }
  return apart;
}

}  // namespace

Vec3 Block::support(Vec3 direction) const noexcept {
  const Vec3 d = rotate_back(pose.rotation, direction);
  Vec3 p{d.x < 0 ? -half.x : half.x, d.y < 0 ? -half.y : half.y, d.z < 0 ? -half.z : half.z};
  if (round > 0) {
    const double across = std::sqrt(d.x * d.x + d.y * d.y);
    if (across > 0) {
      p.x += round / across * d.x;
      p.y += round / across * d.y;
    }
  }
  return pose * p;
}

double distance_between(const Block& a, const Block& b, double enough) noexcept {
  return between(a, b, enough);
}
double distance_between(const Block& a, const Triangle& b, double enough) noexcept {
  return between(a, b, enough);
}
double distance_between(const Triangle& a, const Triangle& b, double enough) noexcept {
  return between(a, b, enough);
}

}  // namespace lasius::arm
