#include "core/arm/timing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/arm/blends.h"
#include "lasius/arm/trajectory.h"
#include "tests/core/arm/questions.h"
#include "tests/core/arm/ways.h"

namespace lasius::arm {
namespace {

/// The least time along a run by brute force: squares x of the speed on a grid, each pair of
/// neighbours in turn, the joints' limits at both ends of each step by differences of the path.
double least_time_on_a_grid(const Robot& robot, const PathRun& run) {
  constexpr int kSpeeds = 400, kSteps = 16;  // of each piece
  const auto n = static_cast<std::size_t>(robot.size());
  double most = 0;
  for (const Joint& joint : robot.joints) most += joint.velocity * joint.velocity;
  std::vector<double> best(kSpeeds + 1, 1e300);
  best[0] = 0;
  struct Rates {
    std::vector<double> first, second;
  };
  for (const PathPiece& piece : run) {
    const double length = piece.length / kSteps;
    const auto rates = [&](double s) {
      constexpr double kHair = 1e-4;
      const double at = std::clamp(s, kHair, piece.length - kHair);  // q'' is constant, q' goes on
      const JointVector a = piece.at(at - kHair), b = piece.at(at), c = piece.at(at + kHair);
      Rates found;
      for (std::size_t j = 0; j < n; ++j) {
        found.second.push_back((c[j] - 2 * b[j] + a[j]) / (kHair * kHair));
        found.first.push_back((c[j] - a[j]) / (2 * kHair) + (s - at) * found.second[j]);
      }
      return found;
    };
    const auto allowed = [&](double x, double u, const Rates& r) {
      for (std::size_t j = 0; j < n; ++j) {
        const Joint& joint = robot.joints[j];
        if (std::abs(r.first[j] * u + r.second[j] * x) > joint.acceleration * (1 + 1e-4) ||
            r.first[j] * r.first[j] * x > joint.velocity * joint.velocity * (1 + 1e-6))
          return false;
      }
      return true;
    };
    for (int k = 0; k < kSteps; ++k) {
      const Rates here = rates(k * length), there = rates((k + 1) * length);
      std::vector<double> next(kSpeeds + 1, 1e300);
      for (int a = 0; a <= kSpeeds; ++a) {
        if (best[a] >= 1e300) continue;
        const double x = most * a / kSpeeds;
        for (int b = a == 0 ? 1 : 0; b <= kSpeeds; ++b) {
          const double y = most * b / kSpeeds, u = (y - x) / (2 * length);
          if (!allowed(x, u, here) || !allowed(y, u, there)) continue;
          next[b] = std::min(next[b], best[a] + 2 * length / (std::sqrt(x) + std::sqrt(y)));
        }
      }
      best = std::move(next);
    }
  }
  return best[0];
}

bool never() { return false; }

TEST(InLeastTime, AnEdgeIsATrapezoidOrATriangle) {
  const Robot robot = two_links();  // 2 rad/s, 5 rad/s^2
  for (const double way : {2.0, 0.2}) {
    // At full speed for what is left beside v^2 / a; or, of a short way, half of it up, half down.
    const double expected = way > 0.8 ? way / 2 + 2.0 / 5 : 2 * std::sqrt(way / 5);
    const auto made =
        make_trajectory(robot, Nothing(), columns(positions({{0, 0}, {way, 0.1 * way}})));
    EXPECT_NEAR(made.trajectory.duration(), expected, 1e-9);
    EXPECT_FALSE(made.stops);
    expect_sound(robot, made.trajectory);
    EXPECT_NEAR(made.trajectory.at(0.1).q[0], 0.5 * 5 * 0.01, 1e-9);
  }
}

TEST(Smoothed, AnEdgeIsADoubleS) {
  // Speeding up takes v / a, longer than a / j: so the least time is way / v + v / a + a / j.
  Robot robot = two_links();
  for (Joint& joint : robot.joints) joint.jerk = 50;
  const auto made = make_trajectory(robot, Nothing(), columns(positions({{0, 0}, {2, 1}})));
  EXPECT_NEAR(made.trajectory.duration(), 2.0 / 2 + 2.0 / 5 + 5.0 / 50, 1e-9);
  expect_sound(robot, made.trajectory);
  EXPECT_EQ(made.trajectory.at(1e9).q, joints({2, 1}));
  // j t^3 / 6 at first.
  EXPECT_NEAR(made.trajectory.at(0.05).q[0], 50 * 0.05 * 0.05 * 0.05 / 6, 1e-9);
  // Nothing jumps: no two knots stand at one time.
  const auto& knots = made.trajectory.knots();
  for (std::size_t i = 1; i < knots.size(); ++i) EXPECT_GT(knots[i].time, knots[i - 1].time);
  // Where jerk is small a shorter mean of a slower motion is quicker: no more than a fifth above
  // the least time 4 (way / 2 j)^(1/3) of a joint without other limits.
  for (Joint& joint : robot.joints) joint.velocity = joint.acceleration = 1e3, joint.jerk = 2;
  const auto slow = make_trajectory(robot, Nothing(), columns(positions({{0, 0}, {2, 1}})));
  EXPECT_GE(slow.trajectory.duration(), 4 * std::cbrt(0.5) - 1e-9);
  EXPECT_LE(slow.trajectory.duration(), 1.21 * 4 * std::cbrt(0.5));
  expect_sound(robot, slow.trajectory);
}

TEST(InLeastTime, IsAsQuickAsBruteForce) {
  std::mt19937 engine(5);
  double worst = 0, sum = 0;
  constexpr int kWays = 8;
  for (int i = 0; i < kWays; ++i) {
    const int size = 2 + i % 5;
    const Robot robot = any_limits(engine, size);
    const auto way = any_way(engine, size, 3 + i % 2);
    const auto runs = rounded(way, blend_sizes(way, i % 3 == 0 ? 0.4 : 1));
    ASSERT_EQ(runs.size(), 1u);
    const TimedRun made = in_least_time(robot, runs[0], 32);
    expect_sound(robot, made.motion);
    const double brute = least_time_on_a_grid(robot, runs[0]);
    const double finest = in_least_time(robot, runs[0], 400).motion.duration();
    EXPECT_GE(made.motion.duration(), 0.9 * brute) << "quicker than can be " << i;
    EXPECT_LE(made.motion.duration(), 1.02 * brute) << i;
    EXPECT_LE(made.motion.duration(), 1.02 * finest) << i;
    worst = std::max(worst, made.motion.duration() / finest);
    sum += made.motion.duration() / brute;
  }
  RecordProperty("of_the_finest", std::to_string(worst));
  RecordProperty("of_brute_force", std::to_string(sum / kWays));
}

TEST(InLeastTime, KeepsToThePathAndTheLimits) {
  std::mt19937 engine(7);
  for (int i = 0; i < 40; ++i) {
    const int size = 1 + i % 7;
    const Robot robot = any_limits(engine, size);
    auto way = any_way(engine, size, 2 + i % 5);
    if (i % 4 == 0) way.push_back(way[way.size() - 2]);  // there and back
    for (const PathRun& run : rounded(way, blend_sizes(way))) {
      const TimedRun made = in_least_time(robot, run, 32);
      expect_sound(robot, made.motion);
      EXPECT_EQ(made.blends.size(), way.size() - 2);
      const PathPiece& last = run.back();
      EXPECT_LT((made.motion.at(1e9).q - last.at(last.length)).norm(), 1e-12);
      std::vector<JointVector> path;
      for (const PathPiece& piece : run)
        for (int k = 0; k <= 400; ++k) path.push_back(piece.at(piece.length * k / 400));
      for (int k = 0; k <= 100; ++k) {
        const JointVector q = made.motion.at(made.motion.duration() * k / 100).q;
        double off = 1e300;
        for (const JointVector& p : path) off = std::min(off, (p - q).norm());
        EXPECT_LT(off, 1e-2) << i;
      }
    }
  }
}

TEST(Smoothed, JerkIsLimitedRoundCornersAndAtStops) {
  std::mt19937 engine(11);
  for (int i = 0; i < 12; ++i) {
    const int size = 2 + i % 5;
    Robot robot = any_limits(engine, size);
    for (Joint& joint : robot.joints) joint.jerk = 4 * joint.acceleration;
    const auto way = any_way(engine, size, 4);
    auto sizes = blend_sizes(way);
    if (i % 3 == 0) sizes[1] = 0;
    for (const PathRun& run : rounded(way, sizes)) {
      const TimedRun quick = in_least_time(robot, run, 32), made = smoothed(robot, quick, never);
      expect_sound(robot, made.motion);
      EXPECT_GT(made.motion.duration(), quick.motion.duration());
      for (const double end : {0.0, made.motion.duration()})
        EXPECT_LT(made.motion.at(end + (end == 0 ? 1e-7 : -1e-7)).ddq.norm(), 1e-4);
    }
  }
}

TEST(Smoothed, IsSoonMadeOnceItIsToldToStop) {
  std::mt19937 engine(19);
  for (int i = 0; i < 6; ++i) {
    Robot robot = any_limits(engine, 3);
    for (Joint& joint : robot.joints) joint.jerk = 2 * joint.acceleration;
    const auto way = any_way(engine, 3, 5);
    const TimedRun quick = in_least_time(robot, rounded(way, blend_sizes(way))[0], 32);
    int asked = 0;
    const TimedRun made = smoothed(robot, quick, [&] { return ++asked > 0; });
    EXPECT_LE(asked, 2);
    expect_sound(robot, made.motion);
    EXPECT_LE(smoothed(robot, quick, never).motion.duration(), made.motion.duration());
  }
}

TEST(SceneSensor, CurvesAreFreeWhereNoPostureOfThemTouches) {
  std::mt19937 engine(13);
  std::uniform_real_distribution<double> share(0, 1);
  int free = 0, blocked = 0, doubtful = 0;
  for (const char* const name : {"industrial6", "redundant7", "scara"}) {
    const Robot robot =
        std::string(name) == "scara"
            ? read_robot(LASIUS_MAPS_DIR "/../tests/core/arm/robots/scara.urdf", {.tip = "tool"})
            : shipped(name);
    const auto drawn = [&] {
      JointVector q(robot.size());
      for (int j = 0; j < robot.size(); ++j)
        q[j] = robot.joints[j].low + share(engine) * (robot.joints[j].high - robot.joints[j].low);
      return q;
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const SceneSensor sensor(robot, generate_query(robot, {.seed = seed, .obstacles = 8}).scene,
                               1e-5);
      std::vector<JointVector> way{drawn()};
      for (int i = 0; i < 2; ++i) way.push_back(way.back() + 0.3 * (drawn() - way[0]));
      const PathRun run = rounded(way, blend_sizes(way))[0];
      const Trajectory curve = in_least_time(robot, run, 8).motion;
      const double from = 0.2 * share(engine) * curve.duration();
      const double to = curve.duration() - 0.2 * share(engine);
      const bool is_free = sensor.try_curve(curve, from, to, {}).value();
      double nearest = 1;
      for (int k = 0; k <= 500 && nearest > 0; ++k)
        nearest = std::min(nearest, sensor.distance(curve.at(from + k / 500.0 * (to - from)).q));
      if (is_free) {
        EXPECT_GE(nearest, 1e-5) << name << " " << seed;
      }
      (is_free ? free : blocked)++;
      doubtful += !is_free && nearest > 5e-3;
    }
  }
  EXPECT_GT(free, 30);
  EXPECT_GT(blocked, 10);
  EXPECT_EQ(doubtful, 0);
}

}  // namespace
}  // namespace lasius::arm
