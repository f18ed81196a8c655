#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <set>

#include "core/arm/robot/vec3.h"
#include "lasius/base/error.h"
#include "tests/core/arm/questions.h"

namespace lasius::arm {
namespace {

using Point3 = std::array<int, 3>;

/// Counts questions of another sensor, and notes every one that a search in an unknown world may
/// not ask: one asked before, a position not next to where an ant can be, a motion from where no
/// ant can be or to a position not found free.
class Witness final : public Sensor {
 public:
  Witness(const Robot& robot, const Sensor& world, const Request& request, double pitch)
      : robot_(robot), world_(world), pitch_(pitch), from_(tip_position(robot, request.start)) {
    entered_.insert({0, 0, 0});
  }

  bool position_free(const JointRef& q) const override {
    const std::scoped_lock lock(mutex_);
    const Point3 at = point(q);
    ++positions;
    if (!asked_.insert(at).second) fault("position asked twice");
    if (at != Point3{0, 0, 0} && !next_to_entered(at)) fault("position that no ant tried");
    const bool free = world_.position_free(q);
    if (free) free_.insert(at);
    return free;
  }

  bool motion_free(const JointRef& a, const JointRef& b) const override {
    const std::scoped_lock lock(mutex_);
    const Point3 from = point(a), to = point(b);
    ++motions;
    if (!motions_.insert({std::min(from, to), std::max(from, to)}).second) fault("motion twice");
    if (apart(from, to) != 1) fault("no edge");
    const bool forth = entered_.count(from) != 0 && free_.count(to) != 0;
    const bool back = entered_.count(to) != 0 && free_.count(from) != 0;
    if (!forth && !back) fault("motion that no ant tried");
    const bool free = world_.motion_free(a, b);
    if (free) {
      entered_.insert(from);
      entered_.insert(to);
    }
    return free;
  }
  double clearance() const override { return world_.clearance(); }

  mutable std::int64_t positions = 0, motions = 0;
  mutable std::map<std::string, int> faults;

 private:
  /// The lattice point of a position; the goal's may be off by half a pitch.
  Point3 point(const JointRef& q) const {
    const Vec3 v = (1 / pitch_) * (Vec3(tip_position(robot_, q)) - from_);
    return {static_cast<int>(std::lround(v.x)), static_cast<int>(std::lround(v.y)),
            static_cast<int>(std::lround(v.z))};
  }
  static int apart(const Point3& a, const Point3& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
  }
  bool next_to_entered(const Point3& at) const {
    for (const auto& e : entered_) {
      if (apart(e, at) == 1) return true;
    }
    return false;
  }
  void fault(const std::string& what) const { ++faults[what]; }

  const Robot& robot_;
  const Sensor& world_;
  double pitch_;
  Vec3 from_;
  mutable std::mutex mutex_;
  mutable std::set<Point3> asked_, entered_, free_;
  mutable std::set<std::pair<Point3, Point3>> motions_;
};

TEST(Goal, KindsAreNamed) {
  EXPECT_EQ(to_string(Goal::position({1, 0, 0}).kind), "position");
  EXPECT_EQ(to_string(Goal::pose(Pose::Identity()).kind), "pose");
  EXPECT_EQ(to_string(Goal::joints(JointVector::Zero(2)).kind), "joints");
}

TEST(ArmPlan, AsksOnlyAboutWhatAntsTryAndNothingTwice) {
  for (const int threads : {1, 3}) {
    for (const std::uint64_t seed : {3u, 7u, 12u}) {
      Case c = make_case("industrial6", seed, 10, 0.8, 10);
      const SceneSensor world(c.robot, c.scene);
      c.parameters.threads = threads;
      c.parameters.iterations = 8;
      c.parameters.pitch *= 1.0000001;  // so that the goal is not half way between two points
      c.request.motion = false;
      const Witness witness(c.robot, world, c.request, c.parameters.pitch);
      const Result result = plan(c.robot, witness, c.request, c.parameters);
      EXPECT_TRUE(witness.faults.empty()) << witness.faults.begin()->first << ", seed " << seed;
      EXPECT_EQ(result.questions.positions, witness.positions);
      EXPECT_EQ(result.questions.motions, witness.motions);
      EXPECT_GT(witness.motions, 100);
      // Not all there is was asked about.
      EXPECT_LT(witness.positions, result.points[0] * result.points[1] * result.points[2]);
    }
  }
}

TEST(ArmPlan, ThreadsChangeNothing) {
  for (const std::uint64_t seed : {3u, 16u}) {
    Case c = make_case("industrial6", seed, 20, 0.5, 12);
    c.parameters.iterations = 12;
    const SceneSensor sensor(c.robot, c.scene);
    std::vector<Result> results;
    for (const int threads : {1, 2, 5}) {
      c.parameters.threads = threads;
      results.push_back(plan(c.robot, sensor, c.request, c.parameters));
    }
    for (const Result& r : results) {
      EXPECT_EQ(r.status, results[0].status);
      EXPECT_EQ(r.joints, results[0].joints);
      EXPECT_EQ(r.curves.best, results[0].curves.best);
      EXPECT_EQ(r.curves.mean, results[0].curves.mean);
      EXPECT_EQ(r.questions, results[0].questions);
      EXPECT_EQ(r.steps, results[0].steps);
      EXPECT_EQ(r.lower_bound, results[0].lower_bound);
    }
  }
}

TEST(ArmPlan, NeverBeatsTheOptimumAndTheBoundNeverExceedsIt) {
  int solved = 0, optimal = 0;
  for (std::uint64_t seed = 1; seed <= 14; ++seed) {
    Case c = make_case("industrial6", seed, 12, seed % 2 == 0 ? 0.8 : 0, 9);
    c.parameters.elite_weight = 16;
    c.parameters.iterations = 50;
    const SceneSensor sensor(c.robot, c.scene);
    const Result best = shortest_lattice_way(c.robot, sensor, c.request, c.parameters);
    const Result found = plan(c.robot, sensor, c.request, c.parameters);
    if (best.status != Status::solved) {
      EXPECT_NE(found.status, Status::solved) << seed;
      continue;
    }
    ASSERT_EQ(found.status, Status::solved) << seed;
    ++solved;
    EXPECT_GE(found.length, best.length - 1e-9) << seed;
    ASSERT_TRUE(found.lower_bound.has_value());
    EXPECT_LE(*found.lower_bound, best.length + 1e-9) << seed;
    if (found.optimal) {
      EXPECT_NEAR(found.length, best.length, 1e-9) << seed;
    }
    optimal += found.length < best.length + 1e-9;
  }
  EXPECT_GE(solved, 7);
  EXPECT_GE(optimal, solved * 9 / 10);
}

// A target gap has it computed with each shorter tour, and not only then.
TEST(ArmPlan, TheBoundIsOfAllThatWasLearned) {
  Case c = make_case("industrial6", 14, 12, 0.8, 9);
  c.parameters.ants = 1;
  c.parameters.iterations = 30;
  const SceneSensor sensor(c.robot, c.scene);
  const Result plain = plan(c.robot, sensor, c.request, c.parameters);
  c.request.target_gap = 1e-9;
  const Result asked = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_EQ(asked.questions, plain.questions);
  EXPECT_EQ(asked.lower_bound, plain.lower_bound);
}

TEST(ArmPlan, ThePathIsWhatItSays) {
  const Case c = make_case("redundant7", 4, 15, 0, 10);
  const SceneSensor sensor(c.robot, c.scene);
  const Result r = plan(c.robot, sensor, c.request, c.parameters);
  ASSERT_EQ(r.status, Status::solved);
  const Eigen::Index last = r.joints.cols() - 1;
  ASSERT_EQ(r.tips.cols(), last + 1);
  EXPECT_EQ(r.joints.col(0), c.request.start);
  EXPECT_EQ(r.tips.col(last), c.request.goals[0].target.translation());
  EXPECT_NEAR(r.length, static_cast<double>(last) * r.pitch, 1e-12);
  for (Eigen::Index i = 0; i <= last; ++i) {
    EXPECT_LT((tip_position(c.robot, r.joints.col(i)) - r.tips.col(i)).norm(), 1e-6);
    EXPECT_TRUE(sensor.position_free(r.joints.col(i)));
    for (int j = 0; j < c.robot.size(); ++j) {
      EXPECT_GE(r.joints(j, i), c.robot.joints[j].low);
      EXPECT_LE(r.joints(j, i), c.robot.joints[j].high);
      if (i > 0) {
        EXPECT_LE(std::abs(r.joints(j, i) - r.joints(j, i - 1)), c.parameters.joint_step);
      }
    }
    if (i > 0) {
      EXPECT_TRUE(sensor.motion_free(r.joints.col(i - 1), r.joints.col(i)));
    }
  }
}

TEST(ArmPlan, TheMotionIsThatOfTheWaypoints) {
  Case c = make_case("industrial6", 3, 10, 0, 10);
  const SceneSensor sensor(c.robot, c.scene);
  for (const bool shortcut : {false, true}) {
    c.parameters.shortcut = shortcut;
    const Result r = plan(c.robot, sensor, c.request, c.parameters);
    ASSERT_EQ(r.status, Status::solved);
    const auto made = make_trajectory(c.robot, sensor, r.joints,
                                      {.shortcut = shortcut, .timing = c.parameters.timing});
    EXPECT_EQ(r.waypoints, made.waypoints);
    EXPECT_EQ(r.stops, made.stops);
    EXPECT_EQ(r.questions.trajectory, made.questions);
    EXPECT_EQ(r.trajectory.duration(), made.trajectory.duration());
    ASSERT_EQ(r.trajectory.knots().size(), made.trajectory.knots().size());
    for (std::size_t i = 0; i < made.trajectory.knots().size(); ++i) {
      EXPECT_EQ(r.trajectory.knots()[i].q, made.trajectory.knots()[i].q);
    }
  }
  const Result whole = plan(c.robot, sensor, c.request, c.parameters);
  c.request.motion = false;
  const Result waypoints = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_TRUE(waypoints.trajectory.empty());
  EXPECT_EQ(waypoints.questions.trajectory, 0);
  EXPECT_EQ(waypoints.joints, whole.joints);
  EXPECT_EQ(waypoints.questions.motions, whole.questions.motions);
}

TEST(ArmPlan, NamesWhatIsTouchedAtTheStart) {
  const Robot robot = two_links();
  const Scene scene{"", {ball(tip_position(robot, across(robot).start), 0.1)}};
  const Result r = plan(robot, SceneSensor(robot, scene), across(robot));
  EXPECT_EQ(r.fault, Fault::start_blocked);
  EXPECT_EQ(r.error, "the arm touches something at the start: link 2 and obstacle 1");
}

TEST(ArmPlan, EveryChoiceHasAName) {
  EXPECT_EQ(to_string(Pheromone::edges), "edges");
  EXPECT_EQ(to_string(Joint::Kind::prismatic), "prismatic");
  EXPECT_EQ(to_string(Obstacle::Shape::mesh), "mesh");
}

TEST(ArmPlan, AnArmThatIsStretchedOutIsDrawnIn) {
  const Robot robot = shipped("planar3");
  const Nothing sensor;
  Request request;
  request.start = joints({0, 0, 0});
  request.goals = {Eigen::Vector3d(0.3, 0.4, 0)};
  EXPECT_EQ(plan(robot, sensor, request, {}).status, Status::solved);
}

TEST(ArmPlan, TheStraightLineAsSeedLeadsTheFirstAnts) {
  Case c = make_case("industrial6", 2, 0, 0, 12);
  const Nothing sensor;
  c.parameters.iterations = 1;
  const Result plain = plan(c.robot, sensor, c.request, c.parameters);
  c.parameters.line_ants = 1e5;
  const Result seeded = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_LT(seeded.curves.mean[0], 0.5 * plain.curves.mean[0]);
}

TEST(ArmPlan, ATargetGapIsNotNegative) {
  Case c = make_case("planar3", 4, 0, 0, 12);
  const Nothing sensor;
  for (const double gap : {-0.1, std::nan("")}) {
    c.request.target_gap = gap;
    EXPECT_THROW(plan(c.robot, sensor, c.request, c.parameters), Error);
  }
}

TEST(ArmPlan, KilledAntsLeaveNoTour) {
  Case c = make_case("planar3", 4, 0, 0, 12);
  const Nothing sensor;
  c.parameters.iterations = 3;
  c.parameters.dead_end = DeadEnd::kill;
  const Result killed = plan(c.robot, sensor, c.request, c.parameters);
  c.parameters.dead_end = DeadEnd::backtrack;
  const Result back = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_EQ(back.curves.arrived[0], c.parameters.ants);
  EXPECT_LT(killed.curves.arrived[0], c.parameters.ants);
}

}  // namespace
}  // namespace lasius::arm
