#include "core/arm/contact/gjk.h"

namespace lasius::arm {
namespace {

Vec3 on_segment(Vec3 a, Vec3 b, GjkSimplex& of) noexcept {
  const Vec3 d = b - a;
  const double whole = square(d), share = -dot(a, d);
  if (!(share > 0)) return of.keep(a), a;
  if (share >= whole) return of.keep(b), b;
  of.keep(a, b);
  return a + (share / whole) * d;
}

Vec3 on_triangle(Vec3 a, Vec3 b, Vec3 c, GjkSimplex& of) noexcept {
  const Vec3 normal = cross(b - a, c - a);
  const double area = square(normal);
  // The origin's foot on the plane, by the areas that it makes with the sides.
  const double u = dot(cross(b, c), normal), v = dot(cross(c, a), normal),
               w = dot(cross(a, b), normal);
  if (area > 0 && u > 0 && v > 0 && w > 0) {
    of.keep(a, b, c);
    return (dot(a, normal) / area) * normal;
  }
  Vec3 best = on_segment(a, b, of);
  const auto offer = [&](Vec3 p, Vec3 q) {
    GjkSimplex other;
    const Vec3 near = on_segment(p, q, other);
    if (square(near) < square(best)) best = near, of = other;
  };
  offer(b, c);
  offer(c, a);
  return best;
}

}  // namespace

Vec3 nearest_point(GjkSimplex& simplex) noexcept {
  const std::array<Vec3, 4> p = simplex.point;
  if (simplex.count == 1) return p[0];
  if (simplex.count == 2) return on_segment(p[0], p[1], simplex);
  if (simplex.count == 3) return on_triangle(p[0], p[1], p[2], simplex);
  constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}};
  Vec3 best;
  bool inside = true;
  for (const auto& [i, j, k, opposite] : kFaces) {
    const Vec3 a = p[i], normal = cross(p[j] - a, p[k] - a);
    if (dot(normal, a) * dot(normal, p[opposite] - a) < 0) continue;  // on the inner side
    GjkSimplex face;
    const Vec3 near = on_triangle(a, p[j], p[k], face);
    if (inside || square(near) < square(best)) best = near, simplex = face;
    inside = false;
  }
  return best;
}

}  // namespace lasius::arm
