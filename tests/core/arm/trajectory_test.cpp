#include "lasius/arm/trajectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/spline.h"
#include "lasius/base/error.h"
#include "tests/core/arm/questions.h"
#include "tests/core/arm/ways.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/base/refusal.h"
#include "tests/oracle/arm/fcl_judge.h"

namespace lasius::arm {
namespace {

/// Refuses every motion that was not allowed beforehand.
class OnlyThese final : public Nothing {
 public:
  explicit OnlyThese(std::vector<JointVector> way) : way_(std::move(way)) {}
  bool motion_free(const JointRef& a, const JointRef& b) const override {
    for (std::size_t i = 0; i + 1 < way_.size(); ++i) {
      if (a == way_[i] && b == way_[i + 1]) return true;
    }
    return false;
  }

 private:
  std::vector<JointVector> way_;
};

/// Notes every motion that it is asked about, and refuses none.
class Notes final : public Nothing {
 public:
  explicit Notes(double clearance) : clearance_(clearance) {}
  bool motion_free(const JointRef& a, const JointRef& b) const override {
    asked.push_back({a, b});
    return true;
  }
  double clearance() const override { return clearance_; }

  mutable std::vector<std::pair<JointVector, JointVector>> asked;

 private:
  double clearance_;
};

TrajectoryOptions splines(TrajectoryOptions options = {}) {
  options.timing = Timing::splines;
  return options;
}

/// Continuity and rest, to rounding, at all knots and both ends.
void expect_smooth(const Robot& robot, const Trajectory& t) {
  const double hair = 1e-9;
  ASSERT_FALSE(t.empty());
  const std::size_t joints = robot.joints.size();
  const double step = 1e-7 * t.duration();
  for (std::size_t i = 1; i + 1 < t.knots().size(); ++i) {
    const double at = t.knots()[i].time;
    const auto before = t.at(at - step), after = t.at(at + step), here = t.at(at);
    for (std::size_t j = 0; j < joints; ++j) {
      const double v = robot.joints[j].velocity, a = robot.joints[j].acceleration;
      EXPECT_NEAR(here.q[j], t.knots()[i].q[j], hair);
      EXPECT_NEAR(before.q[j], after.q[j], 3 * v * step + hair);
      EXPECT_NEAR(before.dq[j], after.dq[j], 3 * a * step + hair);
      EXPECT_NEAR(here.ddq[j], t.knots()[i].ddq[j], hair);
    }
  }
  for (const double end : {0.0, t.duration()}) {
    for (const double v : t.at(end).dq) EXPECT_EQ(v, 0);
    for (const double a : t.at(end).ddq) EXPECT_EQ(a, 0);
  }
  // Not only said to be at rest: so it is next to the ends.
  for (std::size_t j = 0; j < joints; ++j) {
    const double a = robot.joints[j].acceleration;
    EXPECT_NEAR(t.at(step).dq[j], 0, a * step + hair);
    EXPECT_NEAR(t.at(t.duration() - step).dq[j], 0, a * step + hair);
    EXPECT_EQ(t.knots().front().ddq[j], 0);
    EXPECT_EQ(t.knots().back().ddq[j], 0);
  }
}

/// Largest share of a limit that is used, over 2000 times.
double limit_used(const Robot& robot, const Trajectory& t) {
  double most = 0;
  for (int i = 0; i <= 2000; ++i) {
    const auto state = t.at(t.duration() * i / 2000);
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      most = std::max({most, std::abs(state.dq[j]) / robot.joints[j].velocity,
                       std::abs(state.ddq[j]) / robot.joints[j].acceleration});
    }
  }
  return most;
}

TEST(Spline, OneSpanByHand) {
  // From 0 to 1 in time 3, knots at 1 and 2. By symmetry M1 = -M2 = M and q1 = M / 6,
  // q2 = 1 - M / 6; continuity of the velocity at 1: M / 2 = (q2 - q1) - (2 M - M) / 6, so
  // M / 2 = 1 - M / 3 - M / 6, M = 1.
  const Trajectory t = spline_through({{joints({0}), joints({1})}, {3}});
  ASSERT_EQ(t.knots().size(), 4u);
  EXPECT_NEAR(t.knots()[1].ddq[0], 1, 1e-12);
  EXPECT_NEAR(t.knots()[2].ddq[0], -1, 1e-12);
  EXPECT_NEAR(t.knots()[1].q[0], 1.0 / 6, 1e-12);
  EXPECT_NEAR(t.at(1.5).q[0], 0.5, 1e-12);
  EXPECT_NEAR(t.at(1.5).dq[0], 0.75, 1e-12);
}

TEST(Spline, PassesItsPointsSmoothly) {
  const Robot robot = two_links();
  const TimedWaypoints course{
      {joints({0, 0}), joints({0.5, -1}), joints({0.4, 0.3}), joints({1, 1}), joints({1.5, 0})},
      {0.3, 0.8, 0.2, 0.5}};
  const Trajectory t = spline_through(course);
  EXPECT_EQ(t.knots().size(), 7u) << "a free knot in the first and one in the last span";
  double time = 0;
  for (std::size_t i = 0; i < course.points.size(); ++i) {
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(t.at(time).q[j], course.points[i][j], 1e-9);
    if (i < course.spans.size()) time += course.spans[i];
  }
  // The first derivative of each piece at its end is that of the next at its start.
  for (std::size_t i = 1; i + 1 < t.knots().size(); ++i) {
    const auto &a = t.knots()[i - 1], &b = t.knots()[i], &c = t.knots()[i + 1];
    const double h = b.time - a.time, g = c.time - b.time;
    for (int j = 0; j < 2; ++j) {
      const double left = (b.q[j] - a.q[j]) / h + h * (a.ddq[j] + 2 * b.ddq[j]) / 6;
      const double right = (c.q[j] - b.q[j]) / g - g * (2 * b.ddq[j] + c.ddq[j]) / 6;
      EXPECT_NEAR(left, right, 1e-9);
    }
  }
  expect_smooth(robot, stretched(t, 10));
}

// With spans that differ one is within an interval, too.
TEST(Spline, ExtremesBetweenKnots) {
  for (const double second : {1.0, 3.0}) {
    const TimedWaypoints course{{joints({0}), joints({1}), joints({0})}, {1, second}};
    const Trajectory t = spline_through(course);
    for (std::size_t i = 0; i + 1 < t.knots().size(); ++i) {
      const auto [low, high] = values_between(t, i, 0);
      double least = 1e300, most = -1e300;
      for (int s = 0; s <= 1000; ++s) {
        const double span = t.knots()[i + 1].time - t.knots()[i].time;
        const double q = t.at(t.knots()[i].time + span * s / 1000).q[0];
        least = std::min(least, q);
        most = std::max(most, q);
      }
      EXPECT_NEAR(low, least, 1e-5);
      EXPECT_NEAR(high, most, 1e-5);
      EXPECT_LE(low, least + 1e-12);
      EXPECT_GE(high, most - 1e-12);
    }
  }
}

TEST(Trajectory, MeetsALimitAndBreaksNone) {
  const Robot robot = two_links();
  const auto way = positions({{0, 0}, {0.5, 0.5}, {0.5, 1}, {-1, 2}, {-1, 1.5}});
  for (const bool shortcut : {false, true}) {
    const auto made =
        make_trajectory(robot, Nothing(), columns(way), splines({.shortcut = shortcut}));
    EXPECT_EQ(made.waypoints, shortcut ? 2 : 5);
    EXPECT_FALSE(made.stops);
    expect_smooth(robot, made.trajectory);
    EXPECT_LE(limit_used(robot, made.trajectory), 1 + 1e-9);
    EXPECT_GE(limit_used(robot, made.trajectory), 0.99);
    EXPECT_EQ(made.trajectory.at(0).q, way.front());
    EXPECT_EQ(made.trajectory.at(1e9).q, way.back());
  }
}

TEST(Trajectory, TakesTheDurationThatIsAskedForUnlessTheLimitsForbid) {
  const Robot robot = two_links();
  const auto way = positions({{0, 0}, {0.5, 0.5}, {-1, 2}});
  const Nothing open;
  const OnlyThese only(way);  // so that it rests at each waypoint
  for (const Sensor* sensor :
       {static_cast<const Sensor*>(&open), static_cast<const Sensor*>(&only)}) {
    const auto fast = make_trajectory(robot, *sensor, columns(way), splines());
    const double least = fast.trajectory.duration();
    const auto slow =
        make_trajectory(robot, *sensor, columns(way), splines({.duration = 10 * least}));
    EXPECT_EQ(slow.trajectory.duration(), 10 * least);
    EXPECT_EQ(slow.stops, fast.stops);
    expect_smooth(robot, slow.trajectory);
    EXPECT_LE(limit_used(robot, slow.trajectory), 0.1 + 1e-9);
    for (int i = 0; i <= 100; ++i) {
      const auto q = slow.trajectory.at(least * i / 10).q;
      EXPECT_LT((q - fast.trajectory.at(least * i / 100).q).norm(), 1e-9) << "the same curve";
    }
    EXPECT_EQ(make_trajectory(robot, *sensor, columns(way), splines({.duration = 0.5 * least}))
                  .trajectory.duration(),
              least);
  }
  for (const double none : {-1.0, double{NAN}, double{INFINITY}})
    EXPECT_THROW(make_trajectory(robot, open, columns(way), splines({.duration = none})), Error);
}

TEST(Trajectory, RestsAtEachWaypointWhereNothingElseIsFree) {
  const Robot robot = two_links();
  const auto way = positions({{0, 0}, {0.5, 0.5}, {0.5, 1}, {-1, 2}});
  const auto made = make_trajectory(robot, OnlyThese(way), columns(way), splines());
  EXPECT_TRUE(made.stops);
  EXPECT_EQ(made.waypoints, 4);
  expect_smooth(robot, made.trajectory);
  EXPECT_LE(limit_used(robot, made.trajectory), 1 + 1e-9);
  // On the straight lines all along: the second joint follows the first on the first one.
  for (int i = 0; i <= 1000; ++i) {
    EXPECT_LT(off(way, made.trajectory.at(made.trajectory.duration() * i / 1000).q), 1e-9);
  }
}

TEST(Trajectory, KeepsWithinJointLimitsThatASplineWouldOvershoot) {
  Robot robot = two_links();
  robot.joints[0].high = 1;
  const auto way = positions({{0, 0}, {1, 0.1}, {1, 0.2}, {1, 0.3}, {0, 0.4}});
  const auto made = make_trajectory(robot, Nothing(), columns(way), splines({.shortcut = false}));
  for (int i = 0; i <= 2000; ++i) {
    EXPECT_LE(made.trajectory.at(made.trajectory.duration() * i / 2000).q[0], 1 + 1e-9);
  }
}

TEST(Trajectory, StaysWithinTheClearanceOfTheMotionsThatItAskedAbout) {
  const Robot robot = two_links();
  const auto way = positions({{0, 0}, {0.2, 0.3}, {0.2, 0.5}});
  for (const double clearance : {1e-3, 1e-5, 1e-6}) {
    const Notes notes(clearance);
    const auto made = make_trajectory(robot, notes, columns(way), splines({.shortcut = false}));
    ASSERT_FALSE(made.stops);
    constexpr int kTimes = 4000;
    for (int i = 0; i <= kTimes; ++i) {
      const auto q = made.trajectory.at(made.trajectory.duration() * i / kTimes).q;
      double off = 1e300;
      for (const auto& [a, b] : notes.asked) {
        const double dx = b[0] - a[0], dy = b[1] - a[1];
        const double share =
            std::clamp(((q[0] - a[0]) * dx + (q[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        // No point of the arm is further than this from where it is on the straight motion.
        off = std::min(off, 0.91 * std::abs(q[0] - a[0] - share * dx) +
                                0.41 * std::abs(q[1] - a[1] - share * dy));
      }
      ASSERT_LE(off, clearance) << "at " << i;
    }
  }
}

// Where the spline through the waypoints leaves what is free, points between them are added.
TEST(Trajectory, ARefinedCoursePassesAllWaypoints) {
  const Robot robot = two_links();
  const auto way = positions({{0, 0}, {0.5, 0}, {0.5, 0.6}, {1.2, 0.6}, {1.2, 0.1}});
  for (const double width : {0.03, 0.01}) {
    const auto made =
        make_trajectory(robot, Corridor(way, width), columns(way), splines({.shortcut = false}));
    ASSERT_FALSE(made.stops) << width;
    EXPECT_GT(made.trajectory.knots().size(), way.size() + 2) << "nothing was refined";
    for (const JointVector& waypoint : way) {
      const auto& knots = made.trajectory.knots();
      EXPECT_TRUE(std::ranges::any_of(
          knots, [&](const auto& knot) { return (knot.q - waypoint).norm() < 1e-9; }));
    }
    for (int i = 0; i <= 1000; ++i) {
      EXPECT_LE(off(way, made.trajectory.at(made.trajectory.duration() * i / 1000).q), width);
    }
  }
}

TEST(Trajectory, RefusesASensorWithoutClearance) {
  const Robot robot = two_links();
  for (const double clearance : {0.0, -1.0, 1e-7, std::nan("")}) {
    EXPECT_THROW(make_trajectory(robot, Notes(clearance), columns(positions({{0, 0}, {1, 1}}))),
                 Error);
  }
}

TEST(Trajectory, SaysThatTimeRanOut) {
  const Robot robot = two_links();
  const Notes sensor(0.001);
  const auto way = positions({{0.1, 0.2}, {0.7, -0.4}, {1.1, 0.3}});
  const auto whole = make_trajectory(robot, sensor, columns(way), splines({.shortcut = false}));
  EXPECT_EQ(whole.status, Status::solved);
  EXPECT_FALSE(whole.stops);
  const CountingTime none(0);
  const auto cut = make_trajectory(robot, sensor, columns(way),
                                   splines({.shortcut = false, .stop = none.is_up()}));
  EXPECT_EQ(cut.status, Status::limit);
  EXPECT_TRUE(cut.stops);
  expect_smooth(robot, cut.trajectory);
}

TEST(Trajectory, AWayBackToAWaypointStaysThere) {
  const Robot robot = two_links();
  const Notes sensor(0.001);
  const JointVector a = joints({0.1, 0.2}), b = joints({0.7, -0.4}), c = joints({1.1, 0.3});
  const auto shortcut = [&](const std::vector<JointVector>& way) {
    return make_trajectory(robot, sensor, columns(way), splines({.shortcut = true}));
  };
  const auto stay = shortcut({a, b, a});
  EXPECT_EQ(stay.waypoints, 1);
  ASSERT_EQ(stay.trajectory.knots().size(), 1u);
  EXPECT_EQ(stay.trajectory.knots()[0].q, a);
  EXPECT_EQ(stay.trajectory.duration(), 0);
  const auto on = shortcut({a, b, a, c});
  EXPECT_EQ(on.waypoints, 2);
  expect_smooth(robot, on.trajectory);
}

TEST(Trajectory, SmallCases) {
  const Robot robot = two_links();
  EXPECT_TRUE(make_trajectory(robot, Nothing(), columns({})).trajectory.empty());
  const std::vector<JointVector> one{joints({1, 2})};
  const auto still = make_trajectory(robot, Nothing(), columns(one));
  EXPECT_EQ(still.trajectory.duration(), 0);
  EXPECT_EQ(still.trajectory.at(5).q, one[0]);
  EXPECT_THROW(make_trajectory(robot, Nothing(), joints({1, 2, 3})), Error);
  EXPECT_THROW(make_trajectory(robot, Nothing(), joints({1, HUGE_VAL})), Error);
}

TEST(Trajectory, RefusesWaypointsOutsideTheJointLimits) {
  Robot robot = two_links();
  robot.joints[1].continuous = true;  // it has limits all the same
  const auto make = [&](double q) {
    return make_trajectory(robot, Nothing(), columns(positions({{0, 3}, {0.5, q}}))).status;
  };
  expect_says(error_of([&] { return make(5); }),
              "waypoint 2: joint 2 is 5, its limits are -3 .. 3");
  for (const double q : {-3.0, 3 + 1e-12}) EXPECT_EQ(make(q), Status::solved) << q;
}

/// By FCL at 500 instants, and by the library's own look at it.
void expect_free(const Robot& robot, const Scene& scene, double clearance, const Trajectory& t) {
  const oracle::FclJudge judge(robot, scene);
  for (int i = 0; i <= 500; ++i)
    ASSERT_GE(judge.distance(t.at(t.duration() * i / 500).q), clearance - 1e-6) << robot.name << i;
  const Recheck check = recheck(robot, scene, t, 50);
  EXPECT_EQ(check.contacts + check.limits + check.unproven, 0) << robot.name;
  EXPECT_GE(check.nearest, clearance - 1e-6);
}

TEST(Trajectory, FclFindsNoContactOnRandomScenes) {
  for (const char* name : {"planar3", "industrial6", "redundant7"}) {
    const Robot robot = shipped(name);
    int moved = 0;
    for (const std::uint64_t seed : {1u, 4u, 6u, 7u, 8u}) {
      const Query query =
          generate_query(robot, {.seed = seed, .obstacles = 10, .wall = seed % 2 == 0 ? 0.8 : 0});
      const SceneSensor sensor(robot, query.scene);
      const Request request{.start = query.start, .goals = {query.goal}, .motion = false};
      Params parameters = lattice_of(robot, request, 10);
      parameters.iterations = 20;
      const Result found = plan(robot, sensor, request, parameters);
      const auto made =
          make_trajectory(robot, sensor, found.joints, splines({.shortcut = seed % 3 != 0}));
      if (made.trajectory.empty()) continue;
      ++moved;
      expect_smooth(robot, made.trajectory);
      expect_free(robot, query.scene, sensor.clearance(), made.trajectory);
      expect_free(robot, query.scene, sensor.clearance(),
                  make_trajectory(robot, sensor, found.joints).trajectory);
    }
    EXPECT_GE(moved, 2) << name;
  }
}

}  // namespace
}  // namespace lasius::arm
