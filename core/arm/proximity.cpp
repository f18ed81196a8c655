#include "core/arm/proximity.h"

#include <algorithm>
#include <cmath>

#include "core/arm/robot/vec3.h"
#include "core/base/special_values.h"

namespace lasius::arm {
namespace {

Vec3 at(const Segment& s, double t) noexcept { return s.from + t * (s.to - s.from); }

/// How far a coordinate is outside [-half, half], with its sign.
double excess(double x, double half) noexcept { return x - std::clamp(x, -half, half); }

Vec3 excess(Vec3 p, Vec3 half) noexcept {
  return {excess(p.x, half.x), excess(p.y, half.y), excess(p.z, half.z)};
}

/// Where the line p + t n crosses the triangle's inside, t; infinite where it does not.
double crossing(Vec3 p, Vec3 n, const Triangle& triangle) noexcept {
  const Vec3 u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
  const Vec3 normal = cross(u, v);
  const double along = dot(normal, n);
  if (along == 0) return kInfinity;
  const double t = dot(normal, triangle[0] - p) / along;
  const Vec3 hit = p + t * n - triangle[0];
  // Barycentric coordinates by areas.
  const double area = dot(normal, normal);
  const double b = dot(cross(hit, v), normal), c = dot(cross(u, hit), normal);
  return b >= 0 && c >= 0 && b + c <= area ? t : kInfinity;
}

}  // namespace

double distance_to_box(const Segment& s, Vec3 half) noexcept {
  const Vec3 d = s.to - s.from;
  // The squared distance is a quadratic between the places where a coordinate enters or leaves.
  std::array<double, 8> place{0};
  int count = 1;
  const auto insert = [&](double t) {  // in rising order
    int i = count++;
    for (; i > 1 && place[i - 1] > t; --i) place[i] = place[i - 1];
    place[i] = t;
  };
  const auto add = [&](double x, double dx, double h) {
    if (dx == 0) return;
    for (const double side : {-h, h}) {
      const double t = (side - x) / dx;
      if (t > 0 && t < 1) insert(t);
    }
  };
  const auto slope = [&](double t) { return dot(excess(at(s, t), half), d); };
  double t = 0, before = slope(0);
  if (before >= 0) return length(excess(s.from, half));
  add(s.from.x, d.x, half.x);
  add(s.from.y, d.y, half.y);
  add(s.from.z, d.z, half.z);
  insert(1);
  for (int i = 1; i < count && before < 0; ++i) {
    const double after = slope(place[i]);
    t = after <= 0 ? place[i] : t + (place[i] - t) * (before / (before - after));
    before = after;
  }
  return length(excess(at(s, t), half));
}

double distance_to_cylinder(const Segment& s, double radius, double half_length) noexcept {
  const Vec3 d = s.to - s.from;
  const auto outside = [&](Vec3 p) {
    const double across = std::sqrt(p.x * p.x + p.y * p.y);
    const double share = across > radius ? (across - radius) / across : 0;
    return Vec3{p.x * share, p.y * share, excess(p.z, half_length)};
  };
  const auto slope = [&](double t) { return dot(outside(at(s, t)), d); };
  if (slope(0) >= 0) return length(outside(s.from));
  if (slope(1) <= 0) return length(outside(s.to));
  double low = 0, high = 1;
  for (int i = 0; i < 32; ++i) {
    const double middle = 0.5 * (low + high);
    (slope(middle) < 0 ? low : high) = middle;
  }
  return length(outside(at(s, high)));
}

double distance_to_point(const Segment& s, Vec3 point) noexcept {
  const Vec3 d = s.to - s.from;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(dot(point - s.from, d) / square, 0.0, 1.0) : 0;
  return distance(point, at(s, t));
}

double distance_to_segment(const Segment& s, const Segment& t) noexcept {
  // Interior to interior, where the lines are not parallel and the nearest points are on both.
  const Vec3 u = s.to - s.from, v = t.to - t.from, w = s.from - t.from;
  const double a = dot(u, u), b = dot(u, v), c = dot(v, v), d = dot(u, w), e = dot(v, w);
  const double determinant = a * c - b * b;
  double least = kInfinity;
  if (determinant > 0) {
    const double p = (b * e - c * d) / determinant, r = (a * e - b * d) / determinant;
    if (p >= 0 && p <= 1 && r >= 0 && r <= 1) least = distance(at(s, p), at(t, r));
  }
  return std::min({least, distance_to_point(t, s.from), distance_to_point(t, s.to),
                   distance_to_point(s, t.from), distance_to_point(s, t.to)});
}

double distance_to_triangle(const Segment& s, const Triangle& triangle) noexcept {
  const Vec3 d = s.to - s.from;
  const double t = crossing(s.from, d, triangle);
  if (t >= 0 && t <= 1) return 0;
  const Vec3 normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double size = length(normal);
  double least = kInfinity;
  for (const Vec3 end : {s.from, s.to}) {
    const double fall = crossing(end, normal, triangle);
    if (fall < kInfinity) least = std::min(least, std::abs(fall) * size);
  }
  for (int i = 0; i < 3; ++i) {
    least = std::min(least, distance_to_segment(s, {triangle[i], triangle[(i + 1) % 3]}));
  }
  return least;
}

}  // namespace lasius::arm
