// Distances between boxes, cylinders, triangles and meshes, against projections to and fro.
#include "core/arm/convex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/arm/part.h"
#include "tests/core/arm/draw.h"
#include "tests/core/arm/robot/arms.h"

namespace lasius::arm {
namespace {

/// The point of a block that is nearest to p.
Vec3 nearest(const Block& b, Vec3 p) {
  Vec3 q = rotate_back(b.pose.rotation, p - b.pose.position);
  q.z = std::clamp(q.z, -b.half.z, b.half.z);
  if (b.round > 0) {
    const double across = std::hypot(q.x, q.y), share = across > b.round ? b.round / across : 1;
    q.x *= share;
    q.y *= share;
  } else {
    q.x = std::clamp(q.x, -b.half.x, b.half.x);
    q.y = std::clamp(q.y, -b.half.y, b.half.y);
  }
  return b.pose * q;
}

/// To and fro between two convex sets comes as near as they are (Cheney & Goldstein 1959).
double projected(const Block& a, const Block& b) {
  Vec3 p = a.pose.position;
  double apart = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 q = nearest(b, p);
    const Vec3 next = nearest(a, q);
    apart = distance(next, q);
    if (distance(next, p) < 1e-14) break;
    p = next;
  }
  return apart;
}

TEST(Convex, BoxesAndCylindersAsProjectionsHaveThem) {
  Draw draw;
  int apart = 0, touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const Block a = draw.block(), b = draw.block();
    const double expected = projected(a, b), found = distance_between(a, b, 1e9);
    EXPECT_LE(found, expected * (1 + 1e-12) + 1e-12) << i;
    if (expected > 1e-4) {
      ++apart;
      EXPECT_GE(found, expected - 1e-4) << i << ": projections end slowly";
    }
    touching += found <= 0;
    // A limit changes no answer that is below it.
    const double enough = draw.between(0, 2), limited = distance_between(a, b, enough);
    EXPECT_EQ(limited >= enough, found >= enough) << i;
    EXPECT_NEAR(distance_between(b, a, 1e9), found, 2e-6 * found + 2e-9);
  }
  EXPECT_GT(apart, 800);
  EXPECT_GT(touching, 200);
}

TEST(Convex, ByHand) {
  const auto box = [](Vec3 at, Vec3 half, Vec3 rpy = {}) {
    return Block{.pose = {roll_pitch_yaw(rpy), at}, .half = half};
  };
  const auto cylinder = [](Vec3 at, double radius, double half, Vec3 rpy = {}) {
    return Block{.pose = {roll_pitch_yaw(rpy), at}, .half = {0, 0, half}, .round = radius};
  };
  const auto near = [](const Block& a, const Block& b, double expected) {
    EXPECT_NEAR(distance_between(a, b, 1e9), expected, 2e-6 * expected + 1e-9);
    EXPECT_LE(distance_between(a, b, 1e9), expected + 1e-14);
  };
  constexpr double kQuarter = 1.5707963267948966;
  near(box({}, {1, 1, 1}), box({3, 0, 0}, {1, 1, 1}), 1);  // face to face
  near(box({}, {1, 1, 1}), box({2.5, 2.5, 0}, {1, 1, 1}), std::hypot(0.5, 0.5));
  near(box({}, {1, 1, 1}), box({2, 0, 0}, {1, 1, 1}), 0);  // face on face
  near(box({}, {5, 5, 0.5}), box({0, 0, 1.5000001}, {0.1, 0.1, 1}), 1e-7);
  near(cylinder({}, 1, 1), cylinder({3, 0, 0}, 1, 1), 1);          // side by side
  near(cylinder({}, 1, 1), cylinder({0, 0, 2.25}, 0.5, 1), 0.25);  // lid to lid
  near(cylinder({}, 1, 1), cylinder({3, 0, 0}, 1, 1, {kQuarter, 0, 0}), 1);
  near(cylinder({}, 0.035, 0.04), cylinder({0.08, 0, 0}, 0.04, 0.05, {0, kQuarter, 0}), 0);
  near(cylinder({}, 1, 1), box({0, 0, 3}, {4, 4, 1}), 1);
  near(box({}, {0.001, 100, 0.001}), box({0, 0, 0.01}, {100, 0.001, 0.001}), 0.008);
}

/// One of the five shapes in turn, its centre at most `away` from the origin along each axis.
Solid random_solid(Draw& draw, int i, double away, double most_radius) {
  Solid solid;
  solid.pose = to_eigen(draw.pose(away));
  solid.shape = static_cast<Solid::Shape>(i % 5);
  solid.size = Vec3(draw.between(0.01, 0.5), draw.between(0.01, 0.5), draw.between(0.01, 0.5));
  solid.radius = draw.between(0.01, most_radius);
  solid.length = draw.between(0.01, 0.5);
  solid.triangles = std::make_shared<const Triangles>(cube(draw.between(0.05, 0.3)));
  return solid;
}

TEST(Part, AMeshIsAsFarAsTheBoxThatItMakes) {
  Draw draw;
  Solid box, mesh = mesh_of(cube(0.2));
  box.size = {0.4, 0.4, 0.4};
  int apart = 0;
  for (int i = 0; i < 500; ++i) {
    const Placement at = draw.pose(0.8);
    box.pose = mesh.pose = to_eigen(at);
    const Part by_box(box), by_mesh(mesh), to(random_solid(draw, i, 0.8, 0.3));
    const double expected = distance_between(by_box.place({}), to.place({}), 10);
    const double found = distance_between(by_mesh.place({}), to.place({}), 10);
    if (expected <= 0) continue;  // one may be inside the other
    ++apart;
    EXPECT_NEAR(found, expected, 4e-6 * expected + 4e-9) << i;
    EXPECT_NEAR(distance_between(to.place({}), by_mesh.place({}), 10), found, 4e-6 * found + 4e-9);
    EXPECT_GE(distance_between(by_mesh.place({}), to.place({}), 0.5 * found), 0.5 * found);
  }
  EXPECT_GT(apart, 250);
}

// Else what touches would be passed over.
TEST(Part, BallsAreNeverFurtherApartThanWhatTheyHold) {
  Draw draw;
  Solid probe = ball({0, 0, 0}, 1e-6);
  for (int i = 0; i < 5000; ++i) {
    const Solid solid = random_solid(draw, i, 0.3, 0.5);
    probe.pose.translation() = Eigen::Vector3d(draw.point(1));
    const Part part(solid), point(probe);
    const auto a = part.place({}), b = point.place({});
    EXPECT_LE(gap_between(a.ball, b.ball), distance_between(a, b, 10) + 2e-6) << i;
  }
}

}  // namespace
}  // namespace lasius::arm
