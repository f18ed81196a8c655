// Poses along paths and curves: how far apart, where, and which way they look.
#include "lasius/path/poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lasius/base/error.h"
#include "lasius/plan/planner.h"

namespace lasius {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Poses, OfPolylinesByHand) {
  struct Case {
    std::vector<Point> path;
    double spacing;
    std::vector<Pose> poses;
  };
  const std::vector<Case> cases{
      {{}, 1, {}},
      {{{3.5, 2}}, 1, {{3.5, 2, 0}}},
      {{{3.5, 2}, {3.5, 2}}, 1, {{3.5, 2, 0}}},
      {{{1, 1}, {2, 1}}, 5, {{1, 1, 0}, {2, 1, 0}}},
      {{{1, 1}, {2, 1}}, 0.5, {{1, 1, 0}, {1.5, 1, 0}, {2, 1, 0}}},
      {{{2, 1}, {1, 1}}, 1, {{2, 1, kPi}, {1, 1, kPi}}},
      // A vertex looks on, a doubled one adds nothing, pieces are divided each for itself.
      {{{0, 0}, {0, 3}, {0, 3}, {-1, 3}},
       2,
       {{0, 0, kPi / 2}, {0, 1.5, kPi / 2}, {0, 3, kPi}, {-1, 3, kPi}}},
      {{{0, 0}, {2, -2}}, 2, {{0, 0, -kPi / 4}, {1, -1, -kPi / 4}, {2, -2, -kPi / 4}}},
      {{{0, 0}, {-2, -2}}, 4, {{0, 0, -3 * kPi / 4}, {-2, -2, -3 * kPi / 4}}}};
  for (std::size_t i = 0; i < cases.size(); ++i)
    EXPECT_EQ(poses(cases[i].path, cases[i].spacing), cases[i].poses) << i;
}

TEST(Poses, OfACurveAreOnItAndLookAlongIt) {
  Grid grid(30, 20);
  grid.fill({15, 0, 1, 12}, true);
  const Result result = Planner(grid, Disc{1.5}).plan({{3, 3}, {26, 3}});
  ASSERT_FALSE(result.curve.empty());
  constexpr double kSpacing = 0.3;
  const auto found = poses(result, kSpacing);
  EXPECT_EQ((Point{found.front().x, found.front().y}), result.path.front());
  EXPECT_EQ((Point{found.back().x, found.back().y}), result.path.back());
  double turned = 0, length = 0;
  for (std::size_t i = 1; i < found.size(); ++i) {
    const double x = found[i].x - found[i - 1].x, y = found[i].y - found[i - 1].y;
    EXPECT_LE(std::hypot(x, y), kSpacing + 1e-12);
    length += std::hypot(x, y);
    // A chord of an arc looks halfway between its ends' tangents.
    const double turn = std::remainder(found[i].yaw - found[i - 1].yaw, 2 * kPi);
    EXPECT_LE(std::abs(std::remainder(std::atan2(y, x) - found[i - 1].yaw, 2 * kPi)),
              std::abs(turn) + 1e-9);
    turned += std::abs(turn);
  }
  EXPECT_NEAR(length, result.length, 0.01);
  EXPECT_LT(length, result.length + 1e-9);
  double arcs = 0;
  for (const CurvePiece& piece : result.curve) {
    arcs += piece.angle;
    if (piece.turn == 0) continue;
    const auto on_it = [&](const Pose& p) {
      const double x = p.x - piece.centre.x, y = p.y - piece.centre.y;
      return std::abs(std::hypot(x, y) - piece.radius) < 1e-9 &&
             std::abs(x * std::cos(p.yaw) + y * std::sin(p.yaw)) < 1e-6;
    };
    EXPECT_GE(std::ranges::count_if(found, on_it), piece.angle * piece.radius / kSpacing);
  }
  EXPECT_NEAR(turned, arcs, 1e-6);
}

TEST(Poses, InAMapsFrame) {
  const WorldFrame frame{0.05, -1, 2, 0.25};
  const Pose pose = to_world(frame, {10, 4, 0.5}, 20);
  const Point at = frame.to_world({10, 4}, 20);
  EXPECT_EQ((Point{pose.x, pose.y}), at);
  const Point ahead = frame.to_world({10 + std::cos(0.5), 4 + std::sin(0.5)}, 20);
  EXPECT_NEAR(pose.yaw, std::atan2(ahead.y - at.y, ahead.x - at.x), 1e-12);
  EXPECT_EQ(to_world({}, {0, 0, kPi}, 1).yaw, kPi);
}

TEST(Poses, RefusesASpacing) {
  const std::vector<Point> path{{0, 0}, {30, 40}};
  for (const double spacing : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e-9})
    EXPECT_THROW((void)poses(path, spacing), Error) << spacing;
}

}  // namespace
}  // namespace lasius
