// Corners as round as is free, in as much time as there is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/arm/spline.h"
#include "lasius/arm/trajectory.h"
#include "tests/core/arm/questions.h"
#include "tests/core/arm/ways.h"
#include "tests/core/base/counting_time.h"

namespace lasius::arm {
namespace {

TEST(RoundedMotion, EdgesMayBeAsShortAsTheyLike) {
  const Robot robot = shipped("industrial6");
  const SceneSensor sensor(robot, {});
  for (const double size : {1e-3, 1e-6, 1e-7, 1e-9, 1e-12}) {
    std::vector<JointVector> way(4, joints({0, 0.4, 0.7, 0.2, 0.6, 0.1}));
    way[1][0] += size;
    way[2][0] = way[3][0] = way[1][0];
    way[2][4] += size;
    way[3][4] = way[2][4];
    way[3][5] += size;
    const auto made = make_trajectory(robot, sensor, columns(way), {.shortcut = false});
    EXPECT_EQ(made.status, Status::solved) << size;
    EXPECT_FALSE(made.stops) << size;
    EXPECT_EQ(made.trajectory.at(1e9).q, way.back());
    EXPECT_LE(needed_stretch(robot, made.trajectory), 1 + 1e-9);
  }
}

TEST(SceneSensor, AccelerationsMayBeLargerThanValues) {
  // At the largest limit, and a rounding more.
  const Robot robot = shipped("planar3");
  const JointVector q = JointVector::Zero(3), bend = JointVector::Constant(3, 1e6 + 1e-9);
  const Trajectory push({{0, q, bend}, {1e-6, (q + 0.5e-12 * bend).eval(), bend}});
  const SceneSensor sensor(robot, {});
  EXPECT_EQ(sensor.try_curve(push, 0, 1e-6, {}), sensor.position_free(q));
}

TEST(RoundedMotion, TinyEdgesBesideLongOnesLeaveNoJump) {
  std::mt19937 engine(17);
  for (int i = 0; i < 40; ++i) {
    const int size = 1 + i % 5;
    Robot robot = any_limits(engine, size);
    if (i % 2 == 0)
      for (Joint& joint : robot.joints) joint.jerk = 10 * joint.acceleration;
    auto way = any_way(engine, size, 5);
    for (std::size_t k = 2; k < way.size(); ++k)
      way[k] = way[k - 1] + (k % 2 == 0 ? 1 : 1e-12) * (way[k - 1] - way[k - 2]);
    for (JointVector& q : way) q *= 0.5;
    const auto made = make_trajectory(robot, Nothing(), columns(way), {.shortcut = false});
    const Trajectory& t = made.trajectory;
    EXPECT_LE(needed_stretch(robot, t), 1 + 1e-9) << i;
    EXPECT_EQ(t.at(1e9).q, way.back());
    const double step = 1e-9 * t.duration();
    for (const auto& knot : t.knots()) {
      const JointVector before = t.at(knot.time - step).dq, after = t.at(knot.time + step).dq;
      ASSERT_LT((after - before).norm(), 1e-3) << i << " at " << knot.time;
    }
  }
}

/// Knows curves, too.
class CurvedCorridor final : public Corridor {
 public:
  using Corridor::Corridor;
  std::optional<bool> try_curve(const Trajectory& trajectory, double from, double to,
                                const StopCondition&) const override {
    ++curves;
    for (int k = 0; k <= 100; ++k)
      if (!position_free(trajectory.at(from + k / 100.0 * (to - from)).q)) return false;
    return true;
  }
  mutable int curves = 0;
};

TEST(RoundedMotion, CornersAreAsRoundAsIsFree) {
  const Robot robot = two_links();
  const auto way = positions({{0, 0}, {0.5, 0}, {0.5, 0.6}, {1.2, 0.6}, {1.2, 0.1}});
  double before = 0;
  for (const double width : {1.0, 0.03, 0.01, 1e-9}) {
    const Corridor corridor(way, width);
    const CurvedCorridor curved(way, width);
    for (const Corridor* const sensor : {&corridor, static_cast<const Corridor*>(&curved)}) {
      const auto made = make_trajectory(robot, *sensor, columns(way), {.shortcut = false});
      expect_sound(robot, made.trajectory);
      EXPECT_EQ(made.waypoints, 5);
      EXPECT_EQ(made.stops, width < 1e-6);
      EXPECT_EQ(made.status, Status::solved);
      for (int i = 0; i <= 1000; ++i)
        EXPECT_LE(off(way, made.trajectory.at(made.trajectory.duration() * i / 1000).q),
                  width + 1e-12);
      if (sensor == &corridor) {
        EXPECT_GT(made.trajectory.duration(), before);
        before = made.trajectory.duration();
      }
    }
    EXPECT_GT(curved.curves, 0);
  }
}

TEST(RoundedMotion, RestsAtCornersWhereThereWasNoTimeToAsk) {
  const Robot robot = two_links();
  const auto way = positions({{0, 0}, {0.5, 0}, {0.5, 0.6}});
  const auto made =
      make_trajectory(robot, Nothing(), columns(way), {.shortcut = false, .max_questions = 1});
  EXPECT_EQ(made.status, Status::limit);
  EXPECT_TRUE(made.stops);
  EXPECT_NEAR(made.trajectory.duration(), 2 * std::sqrt(0.5 / 5) + 2 * std::sqrt(0.6 / 5), 1e-9);
}

TEST(RoundedMotion, RestsAtAllCornersOnceTimeIsUp) {
  std::mt19937 engine(23);
  Robot robot = any_limits(engine, 3);
  for (Joint& joint : robot.joints) joint.jerk = 4 * joint.acceleration;
  const auto way = any_way(engine, 3, 5);  // few questions: the clock is read between the means
  for (const int polls : {0, 1, 2}) {
    const CountingTime time(polls);
    const auto made = make_trajectory(robot, CurvedCorridor(way, 1), columns(way),
                                      {.shortcut = false, .stop = time.is_up()});
    EXPECT_EQ(made.status, Status::limit) << polls;
    EXPECT_TRUE(made.stops) << polls;
    EXPECT_EQ(time.polls(), polls + 1);
    expect_sound(robot, made.trajectory);
    EXPECT_LT((made.trajectory.at(1e9).q - way.back()).norm(), 1e-12);
  }
}

TEST(ShortenWay, EachDrawLooksAtTheClock) {
  // No draw pays on a straight way, so none asks anything.
  const Robot robot = two_links();
  const auto way = positions({{0, 0}, {0.5, 0.5}, {1, 1}});
  for (const bool quick : {false, true}) {
    const CountingTime time(10);
    const auto made = make_trajectory(
        robot, Nothing(), columns(way),
        {.shortcut = false, .shortcuts = 100000, .quick = quick, .stop = time.is_up()});
    EXPECT_EQ(made.status, Status::limit);
    EXPECT_EQ(time.polls(), 11);
  }
}

TEST(RoundedMotion, TimeIsSavedWhereThatIsAskedFor) {
  // The second joint is slow: the way round by it is shorter, and takes longer.
  Robot robot = two_links();
  robot.joints[1].velocity = 0.2;
  std::mt19937 engine(3);
  double quick = 0, shorter = 0;
  for (int i = 0; i < 10; ++i) {
    const auto way = any_way(engine, 2, 8);
    const Corridor corridor(way, 0.3);
    const auto make = [&](bool saves_time) {
      return make_trajectory(robot, corridor, columns(way), {.shortcuts = 100, .quick = saves_time})
          .trajectory.duration();
    };
    quick += make(true);
    shorter += make(false);
  }
  EXPECT_LT(quick, shorter);
}

}  // namespace
}  // namespace lasius::arm
