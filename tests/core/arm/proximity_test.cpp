#include "core/arm/proximity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/arm/mesh_tree.h"
#include "core/arm/robot/vec3.h"
#include "kernels/base/sine.h"
#include "tests/core/arm/draw.h"

namespace lasius::arm {
namespace {

/// Least distance from points along the segment, by a function of one point: never below the true
/// one, and above it by at most half a step.
template <class Distance>
double sampled(const Segment& s, const Distance& distance_of) {
  constexpr int kSteps = 4000;
  double least = 1e300;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    least = std::min(least, distance_of(s.from + t * (s.to - s.from)));
  }
  return least;
}

double outside(double x, double half) { return std::max(0.0, std::abs(x) - half); }

double point_to_box(Vec3 p, Vec3 half) {
  return std::hypot(outside(p.x, half.x), outside(p.y, half.y), outside(p.z, half.z));
}

double point_to_cylinder(Vec3 p, double radius, double half_length) {
  return std::hypot(std::max(0.0, std::hypot(p.x, p.y) - radius), outside(p.z, half_length));
}

constexpr double kStep = 4.0 / 4000;  // twice half a step of a segment of length up to 4

TEST(Sine, AgreesWithTheLibraryWithinItsPromise) {
  for (double x = -70; x < 70; x += 0.0137) {
    const auto [s, c] = kernels::sine_cosine(x);
    ASSERT_NEAR(s, std::sin(x), 1e-15) << x;
    ASSERT_NEAR(c, std::cos(x), 1e-15) << x;
  }
}

TEST(Proximity, SegmentToBox) {
  Draw draw;
  for (int i = 0; i < 300; ++i) {
    const Vec3 half{draw.between(0.01, 1), draw.between(0.01, 1), draw.between(0.01, 1)};
    const Segment s{draw.point(1.1), draw.point(1.1)};
    const double expected = sampled(s, [&](Vec3 p) { return point_to_box(p, half); });
    const double found = distance_to_box(s, half);
    EXPECT_LE(found, expected + 1e-12);
    EXPECT_GE(found, expected - kStep);
  }
  // By hand: past an edge, 3 and 4 away; through the middle; along a side.
  EXPECT_DOUBLE_EQ(distance_to_box({{4, 5, -9}, {4, 5, 9}}, {1, 1, 1}), 5);
  EXPECT_DOUBLE_EQ(distance_to_box({{-9, 0, 0}, {9, 0.1, 0}}, {1, 1, 1}), 0);
  EXPECT_DOUBLE_EQ(distance_to_box({{-9, 3, 0}, {9, 3, 0}}, {1, 1, 1}), 2);
  EXPECT_DOUBLE_EQ(distance_to_box({{2, 2, 2}, {2, 2, 2}}, {1, 1, 1}), std::sqrt(3));
}

TEST(Proximity, SegmentToCylinder) {
  Draw draw;
  for (int i = 0; i < 300; ++i) {
    const double radius = draw.between(0.01, 1), half = draw.between(0.01, 1);
    const Segment s{draw.point(1.1), draw.point(1.1)};
    const double expected = sampled(s, [&](Vec3 p) { return point_to_cylinder(p, radius, half); });
    const double found = distance_to_cylinder(s, radius, half);
    EXPECT_LE(found, expected + 1e-8);
    EXPECT_GE(found, expected - kStep);
  }
  EXPECT_NEAR(distance_to_cylinder({{3, -9, 0}, {3, 9, 0}}, 1, 1), 2, 1e-9);
  EXPECT_NEAR(distance_to_cylinder({{0, 0, 5}, {0, 0, 4}}, 1, 1), 3, 1e-9);
}

TEST(Proximity, SegmentToSegmentAndPoint) {
  Draw draw;
  for (int i = 0; i < 300; ++i) {
    const Segment s{draw.point(1), draw.point(1)}, t{draw.point(1), draw.point(1)};
    const double expected = sampled(s, [&](Vec3 p) { return distance_to_point(t, p); });
    const double found = distance_to_segment(s, t);
    EXPECT_LE(found, expected + 1e-12);
    EXPECT_GE(found, expected - kStep);
    EXPECT_DOUBLE_EQ(found, distance_to_segment(t, s));
  }
  EXPECT_DOUBLE_EQ(distance_to_segment({{0, 0, 0}, {1, 0, 0}}, {{0, 2, 0}, {1, 2, 0}}), 2);
  EXPECT_DOUBLE_EQ(distance_to_segment({{-1, 0, 1}, {1, 0, 1}}, {{0, -1, 0}, {0, 1, 0}}), 1);
  EXPECT_DOUBLE_EQ(distance_to_point({{0, 0, 0}, {1, 0, 0}}, {4, 4, 0}), 5);
}

TEST(Proximity, SegmentToTriangle) {
  Draw draw;
  for (int i = 0; i < 200; ++i) {
    const Triangle triangle{draw.point(1), draw.point(1), draw.point(1)};
    const Segment s{draw.point(1.2), draw.point(1.2)};
    // Points of the triangle, each with its exact distance to the segment.
    double expected = 1e300;
    constexpr int kParts = 120;
    for (int a = 0; a <= kParts; ++a) {
      for (int b = 0; a + b <= kParts; ++b) {
        const double u = static_cast<double>(a) / kParts, v = static_cast<double>(b) / kParts;
        const Vec3 p = (1 - u - v) * triangle[0] + u * triangle[1] + v * triangle[2];
        expected = std::min(expected, distance_to_point(s, p));
      }
    }
    const double found = distance_to_triangle(s, triangle);
    EXPECT_LE(found, expected + 1e-9);
    EXPECT_GE(found, expected - 4.0 / kParts);
  }
  const Triangle flat{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};
  EXPECT_DOUBLE_EQ(distance_to_triangle({{1, 1, -1}, {1, 1, 1}}, flat), 0);
  EXPECT_DOUBLE_EQ(distance_to_triangle({{1, 1, 2}, {1, 1, 3}}, flat), 2);
  EXPECT_DOUBLE_EQ(distance_to_triangle({{-3, 1, 4}, {-3, 1, 9}}, flat), 5);
}

TEST(MeshTree, FindsTheNearestOfAllTriangles) {
  Draw draw;
  std::vector<Triangle> triangles;
  for (int i = 0; i < 500; ++i) {
    const Vec3 at = draw.point(2);
    triangles.push_back({at, at + draw.point(0.2), at + draw.point(0.2)});
  }
  const MeshTree tree(triangles);
  for (int i = 0; i < 100; ++i) {
    const Segment s{draw.point(2), draw.point(2)};
    double expected = 1e300;
    for (const auto& triangle : triangles) {
      expected = std::min(expected, distance_to_triangle(s, triangle));
    }
    EXPECT_DOUBLE_EQ(tree.distance(s, 1e300), expected);
    EXPECT_DOUBLE_EQ(tree.distance(s, 0.5 * expected), 0.5 * expected);
  }
  EXPECT_DOUBLE_EQ(MeshTree({}).distance(Segment{}, 3), 3);
}

}  // namespace
}  // namespace lasius::arm
