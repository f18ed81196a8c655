#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <set>
#include <stdexcept>

#include "core/arm/lattice.h"
#include "core/arm/lattice_ants.h"
#include "core/arm/lattice_trail.h"
#include "core/arm/vec3.h"
#include "core/trail_rules.h"
#include "lasius/arm_plan.h"
#include "lasius/error.h"
#include "tests/core/arm/arms.h"

namespace lasius::arm {
namespace {

using Point3 = std::array<int, 3>;

/// A sensor that knows no obstacle.
class Nothing final : public Sensor {
 public:
  bool position_free(std::span<const double>) const override { return true; }
  bool motion_free(std::span<const double>, std::span<const double>) const override { return true; }
  double clearance() const override { return 0.001; }
};

/// Counts questions of another sensor, and notes every one that a search in an unknown world may
/// not ask: one asked before, a position not next to where an ant can be, a motion from where no
/// ant can be or to a position not found free.
class Witness final : public Sensor {
 public:
  Witness(const Robot& robot, const Sensor& world, const Request& request, double pitch)
      : robot_(robot), world_(world), pitch_(pitch), from_(tip_position(robot, request.start)) {
    entered_.insert({0, 0, 0});
  }

  bool position_free(std::span<const double> q) const override {
    const std::scoped_lock lock(mutex_);
    const Point3 at = point(q);
    ++positions;
    if (!asked_.insert(at).second) fault("position asked twice");
    if (at != Point3{0, 0, 0} && !next_to_entered(at)) fault("position that no ant tried");
    const bool free = world_.position_free(q);
    if (free) free_.insert(at);
    return free;
  }

  bool motion_free(std::span<const double> a, std::span<const double> b) const override {
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
  Point3 point(std::span<const double> q) const {
    const Vec3 v = (1 / pitch_) * (tip_position(robot_, q) - from_);
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

struct Case {
  Robot robot;
  Scene scene;
  Request request;
  Parameters parameters;
};

Case make_case(const char* robot, std::uint64_t seed, int obstacles, double wall, int side) {
  Case c{shipped(robot), {}, {}, {}};
  Query query = generate_query(c.robot, {.seed = seed, .obstacles = obstacles, .wall = wall});
  c.scene = std::move(query.scene);
  c.request.start = std::move(query.start);
  c.request.goal = query.goal;
  c.parameters = lattice_of(c.robot, c.request, side);
  c.parameters.threads = 1;
  return c;
}

TEST(ArmPlan, AsksOnlyAboutWhatAntsTryAndNothingTwice) {
  for (const int threads : {1, 3}) {
    for (const std::uint64_t seed : {3u, 7u, 12u}) {
      Case c = make_case("industrial6", seed, 10, 0.8, 10);
      const SceneSensor world(c.robot, c.scene);
      c.parameters.threads = threads;
      c.parameters.iterations = 8;
      c.parameters.pitch *= 1.0000001;  // so that the goal is not half way between two points
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
      EXPECT_EQ(r.best, results[0].best);
      EXPECT_EQ(r.mean, results[0].mean);
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

TEST(ArmPlan, ThePathIsWhatItSays) {
  const Case c = make_case("redundant7", 4, 15, 0, 10);
  const SceneSensor sensor(c.robot, c.scene);
  const Result r = plan(c.robot, sensor, c.request, c.parameters);
  ASSERT_EQ(r.status, Status::solved);
  ASSERT_EQ(r.joints.size(), r.tips.size());
  EXPECT_EQ(r.joints.front(), c.request.start);
  EXPECT_EQ(r.tips.back(), c.request.goal);
  EXPECT_NEAR(r.length, static_cast<double>(r.joints.size() - 1) * r.pitch, 1e-12);
  for (std::size_t i = 0; i < r.joints.size(); ++i) {
    EXPECT_LT(distance(tip_position(c.robot, r.joints[i]), r.tips[i]), 1e-6);
    EXPECT_TRUE(sensor.position_free(r.joints[i]));
    for (int j = 0; j < c.robot.size(); ++j) {
      EXPECT_GE(r.joints[i][j], c.robot.joints[j].low);
      EXPECT_LE(r.joints[i][j], c.robot.joints[j].high);
      if (i > 0) {
        EXPECT_LE(std::abs(r.joints[i][j] - r.joints[i - 1][j]), c.parameters.joint_step);
      }
    }
    if (i > 0) {
      EXPECT_TRUE(sensor.motion_free(r.joints[i - 1], r.joints[i]));
    }
  }
}

/// A lattice of the planar arm of 5 x 5 points about a bent position, nothing in the way.
struct Plane {
  Robot robot = two_links();
  Nothing sensor;
  Kinematics arm{robot};
  std::vector<double> start{0.6, 1.2};
  Parameters parameters;
  Point3 goal{2, 0, 0};

  Lattice lattice(Point3 to) {
    const Vec3 from = tip_position(robot, start);
    const Vec3 at{from.x + 0.02 * to[0], from.y + 0.02 * to[1], from.z + 0.02 * to[2]};
    return {arm, sensor, start, 0.02, {-2, -2, 0}, {2, 2, 0}, to, at, parameters};
  }
};

TEST(Lattice, GuidanceByHand) {
  // u = 1 / (1 + theta): towards the goal 1, across 1 / (1 + pi/2), away 1 / (1 + pi); to the power
  // of gamma (eq. 9).
  Plane plane;
  plane.parameters.gamma = 2;
  const Lattice lattice = plane.lattice({2, 0, 0});
  ASSERT_NE(lattice.configuration(lattice.start()), nullptr);
  const float* u = lattice.guidance(lattice.start());
  const auto squared = [](double theta) { return 1 / ((1 + theta) * (1 + theta)); };
  EXPECT_NEAR(u[0], 1, 1e-6);
  EXPECT_NEAR(u[1], squared(std::numbers::pi), 1e-6);
  for (const int k : {2, 3, 4, 5}) EXPECT_NEAR(u[k], squared(std::numbers::pi / 2), 1e-6);

  // Seen from (0, 1, 0), the goal (1, 2, 0) lies half way between +x and +y.
  const Lattice slanted = plane.lattice({1, 2, 0});
  const Node v = slanted.node({0, 1, 0});
  ASSERT_NE(slanted.configuration(v), nullptr);
  const double eighth = std::numbers::pi / 4;
  EXPECT_NEAR(slanted.guidance(v)[0], squared(eighth), 1e-6);
  EXPECT_NEAR(slanted.guidance(v)[1], squared(3 * eighth), 1e-6);
  EXPECT_NEAR(slanted.guidance(v)[2], squared(eighth), 1e-6);
}

TEST(Lattice, JointValuesAreAFunctionOfThePointAlone) {
  Plane plane;
  const Lattice one = plane.lattice({2, 0, 0}), other = plane.lattice({2, 0, 0});
  // Asked in opposite orders.
  std::vector<Node> nodes;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) nodes.push_back(one.node({x, y, 0}));
  }
  for (const Node v : nodes) one.configuration(v);
  for (auto v = nodes.rbegin(); v != nodes.rend(); ++v) other.configuration(*v);
  for (const Node v : nodes) {
    const double *a = one.configuration(v), *b = other.configuration(v);
    ASSERT_EQ(a == nullptr, b == nullptr);
    if (a == nullptr) continue;
    EXPECT_EQ(a[0], b[0]);
    EXPECT_EQ(a[1], b[1]);
  }
  EXPECT_EQ(one.configuration(one.node({3, 0, 0})), nullptr) << "outside of the box";
}

TEST(LatticeAnts, FirstMovesFollowTheRandomProportionalRule) {
  // Weights tau^alpha u^gamma of the six moves out of the start; +-z has no joint values. Seven
  // tenths of sigma-free counts: 40000 draws, 5 standard deviations.
  Plane plane;
  plane.parameters.ants = 40000;
  plane.parameters.gamma = 1;
  plane.parameters.alpha = 2;
  const Lattice lattice = plane.lattice({2, 0, 0});
  LatticeTrail trail(lattice, Pheromone::arcs, 1, plane.parameters.alpha);
  trail.deposit(trail.place(lattice.start(), 2), 0.5);  // +y
  trail.refresh();
  LatticeAnts walkers(lattice, trail, plane.parameters);
  std::vector<LatticeAnt> ants(plane.parameters.ants);
  walkers.walk(0, ants, {});
  std::array<int, kMoves> count{};
  for (const LatticeAnt& ant : ants) {
    ASSERT_TRUE(ant.arrived);
    ++count[ant.moves.front()];
  }
  const double across = 1 / (1 + std::numbers::pi / 2), away = 1 / (1 + std::numbers::pi);
  const std::array<double, kMoves> weight{1, away, 2.25 * across, across, 0, 0};
  // Steps taken back change a first move now and then: an ant that went -x may find itself walled
  // in by its own visits. On 5 x 5 points that is rare: 2% of room.
  double total = 0;
  for (const double w : weight) total += w;
  for (int k = 0; k < kMoves; ++k) {
    const double share = weight[k] / total;
    EXPECT_NEAR(count[k] / 40000.0, share, 0.02 + 5 * std::sqrt(share / 40000)) << k;
  }
  EXPECT_EQ(count[4] + count[5], 0);
}

struct HandTour {
  std::vector<int> places;
  double length;
};
struct HandTours {
  std::vector<HandTour> ants;
  template <class Visit>
  void along(const HandTour& tour, const Visit& visit) const {
    for (const int place : tour.places) visit(place);
  }
};

TEST(LatticeTrail, UpdatesByHand) {
  // Two ants over places 1, 2 and 2, 3 of lengths 4 and 2; rho = 0.25, tau0 = 8 (eq. 10), then
  // e = 3 on the second (eq. 11, 12).
  Plane plane;
  const Lattice lattice = plane.lattice({2, 0, 0});
  const HandTours tours{{{{1, 2}, 4}, {{2, 3}, 2}}};
  lasius::Params params;
  params.persistence = 0.75;
  params.deposit = 1;
  params.elite_weight = 3;
  LatticeTrail plain(lattice, Pheromone::arcs, 8, 1), elite(lattice, Pheromone::arcs, 8, 1);
  trail_rules::ant_system(plain, params, tours);
  EXPECT_DOUBLE_EQ(plain.tau(0), 6);
  EXPECT_DOUBLE_EQ(plain.tau(1), 6.25);
  EXPECT_DOUBLE_EQ(plain.tau(2), 6.75);
  EXPECT_DOUBLE_EQ(plain.tau(3), 6.5);
  trail_rules::elitist(elite, params, tours, tours.ants[1]);
  EXPECT_DOUBLE_EQ(elite.tau(1), 6.25);
  EXPECT_DOUBLE_EQ(elite.tau(2), 8.25);
  EXPECT_DOUBLE_EQ(elite.tau(3), 8);

  // What ants read: ratios of tau^alpha.
  LatticeTrail cubed(lattice, Pheromone::arcs, 8, 3);
  trail_rules::ant_system(cubed, params, tours);
  cubed.refresh();
  EXPECT_NEAR(cubed.attraction(2) / cubed.attraction(0), std::pow(6.75 / 6, 3), 1e-9);
}

TEST(LatticeTrail, LongEvaporationKeepsRatiosAndForgetsEverythingAtRhoOne) {
  Plane plane;
  const Lattice lattice = plane.lattice({2, 0, 0});
  LatticeTrail trail(lattice, Pheromone::arcs, 1, 1);
  trail.deposit(5, 3);
  for (int i = 0; i < 120; ++i) trail.evaporate(0.75);  // 2^-50: stored values are rescaled
  trail.refresh();
  EXPECT_DOUBLE_EQ(trail.attraction(5) / trail.attraction(6), 4);
  trail.evaporate(0);
  trail.deposit(7, 1);
  trail.refresh();
  EXPECT_GT(trail.attraction(7), 1e9 * trail.attraction(5));
  EXPECT_GT(trail.attraction(5), 0);
}

TEST(LatticeTrail, EdgesShareTheirPheromoneArcsDoNot) {
  Plane plane;
  const Lattice lattice = plane.lattice({2, 0, 0});
  const LatticeTrail arcs(lattice, Pheromone::arcs, 1, 1), edges(lattice, Pheromone::edges, 1, 1);
  const Node a = lattice.start();
  for (int k = 0; k < kMoves; ++k) {
    const Node b = lattice.to(a, k);
    EXPECT_EQ(edges.place(a, k), edges.place(b, k ^ 1));
    EXPECT_NE(arcs.place(a, k), arcs.place(b, k ^ 1));
  }
}

/// A wall of ice: everything beyond a line is blocked.
class Wall final : public Sensor {
 public:
  Wall(const Robot& robot, double x) : robot_(robot), x_(x) {}
  bool position_free(std::span<const double> q) const override {
    return tip_position(robot_, q).x > x_;
  }
  bool motion_free(std::span<const double>, std::span<const double>) const override { return true; }
  double clearance() const override { return 0.001; }

 private:
  const Robot& robot_;
  double x_;
};

Request across(const Robot& robot) {
  Request request{.start = {0.6, 1.2}, .goal = tip_position(robot, std::vector{0.6, 1.2})};
  request.goal.x -= 0.2;
  return request;
}

TEST(ArmPlan, ProvesThatThereIsNoWay) {
  const Robot robot = two_links();
  const Request request = across(robot);
  const double from = tip_position(robot, request.start).x;
  Parameters parameters;
  parameters.pitch = 0.05;
  parameters.side = 11;
  const Wall wall(robot, from - 0.12);
  const Result r = plan(robot, wall, request, parameters);
  EXPECT_EQ(r.status, Status::unreachable);
  EXPECT_FALSE(r.error.empty());
  EXPECT_LT(r.iterations, 100);
  EXPECT_TRUE(r.joints.empty());
  EXPECT_TRUE(std::isnan(r.length));
  EXPECT_EQ(shortest_lattice_way(robot, wall, request, parameters).status, Status::unreachable);

  // The goal itself is blocked, which an ant beside it learns: that beats unreachable.
  const Wall at_goal(robot, request.goal.x + 0.01);
  const Result blocked = plan(robot, at_goal, request, parameters);
  EXPECT_EQ(blocked.status, Status::invalid);
  EXPECT_EQ(blocked.error, "the arm touches something at the goal");
}

TEST(ArmPlan, BadQuestionsAreAnswers) {
  const Robot robot = two_links();
  const Nothing sensor;
  const auto expect_invalid = [&](Request request, const std::string& words) {
    const Result r = plan(robot, sensor, request);
    EXPECT_EQ(r.status, Status::invalid);
    EXPECT_NE(r.error.find(words), std::string::npos) << r.error;
  };
  expect_invalid({.start = {0}, .goal = {0.9, 0, 0}}, "1 joint values");
  expect_invalid({.start = {0, 4}, .goal = {0.9, 0, 0}}, "joint 2");
  expect_invalid({.start = {0, std::nan("")}, .goal = {0.9, 0, 0}}, "joint 2");
  expect_invalid({.start = {0, 1}, .goal = {2, 0, 0}}, "outside");
  expect_invalid({.start = {0, 1}, .goal = {std::nan(""), 0, 0}}, "outside");
  expect_invalid({.start = {0, 1}, .goal = {0.5, 0, 0.3}}, "does not get there");
  Request near = across(robot);
  near.goal = tip_position(robot, near.start);
  near.goal.y += 0.001;
  expect_invalid(near, "half a pitch");
  const Wall everywhere(robot, 10);
  EXPECT_EQ(plan(robot, everywhere, across(robot)).error, "the arm touches something at the start");
}

TEST(ArmPlan, BadParametersAreRefused) {
  const Robot robot = two_links();
  const Nothing sensor;
  const auto refused = [&](auto change) {
    Parameters p;
    change(p);
    EXPECT_THROW(plan(robot, sensor, across(robot), p), Error);
  };
  refused([](Parameters& p) { p.ants = 0; });
  refused([](Parameters& p) { p.iterations = -1; });
  refused([](Parameters& p) { p.alpha = 9; });
  refused([](Parameters& p) { p.evaporation = 1.1; });
  refused([](Parameters& p) { p.evaporation = std::nan(""); });
  refused([](Parameters& p) { p.seed = std::uint64_t{1} << 53; });
  refused([](Parameters& p) { p.threads = -1; });
  refused([](Parameters& p) { p.threads = 1025; });
  refused([](Parameters& p) { p.pitch = 1e-5; });  // too many points
  refused([](Parameters& p) { p.pitch = 1e-300; });
  Parameters p;
  EXPECT_THROW(set_parameter(p, "elite_wait", "1"), Error);
  EXPECT_THROW(set_parameter(p, "ants", "many"), Error);
  set_parameter(p, "pheromone", "edges");
  EXPECT_EQ(get_parameter(p, "pheromone"), "edges");
  EXPECT_EQ(p.pheromone, Pheromone::edges);
}

TEST(ArmPlan, AnArmThatIsStretchedOutIsDrawnIn) {
  const Robot robot = shipped("planar3");
  const Nothing sensor;
  Request request;
  request.start = {0, 0, 0};
  request.goal = {0.3, 0.4, 0};
  EXPECT_EQ(plan(robot, sensor, request, {}).status, Status::solved);
}

TEST(ArmPlan, StopsEarlyWhenAsked) {
  Case c = make_case("industrial6", 3, 10, 0, 10);
  const SceneSensor sensor(c.robot, c.scene);
  c.parameters.patience = 5;
  const Result patient = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_LT(patient.iterations, 100);
  EXPECT_EQ(patient.status, Status::solved);

  c.parameters.patience = 0;
  c.request.target_gap = 0.5;
  const Result close = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_LT(close.iterations, 100);
  EXPECT_LE(close.gap().value(), 0.5);
}

TEST(ArmPlan, TheStraightLineAsSeedLeadsTheFirstAnts) {
  Case c = make_case("industrial6", 2, 0, 0, 12);
  const Nothing sensor;
  c.parameters.iterations = 1;
  const Result plain = plan(c.robot, sensor, c.request, c.parameters);
  c.parameters.line_ants = 1e5;
  const Result seeded = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_LT(seeded.mean[0], 0.5 * plain.mean[0]);
}

TEST(ArmPlan, TokenAndDeadlineKeepTheBest) {
  Case c = make_case("industrial6", 3, 10, 0, 12);
  const SceneSensor sensor(c.robot, c.scene);
  c.parameters.iterations = 1000000;
  std::stop_source source;
  c.request.stop.token = source.get_token();
  const Result r = plan(c.robot, sensor, c.request, c.parameters, [&](const IterationView& view) {
    if (view.iteration == 3) source.request_stop();
  });
  EXPECT_EQ(r.status, Status::interrupted);
  EXPECT_EQ(r.iterations, 4);
  EXPECT_FALSE(r.joints.empty());

  c.request.stop = {.deadline = Clock::now()};
  const Result late = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_EQ(late.status, Status::limit);
  EXPECT_EQ(late.iterations, 0);
}

/// Breaks down after some questions.
class Broken final : public Sensor {
 public:
  bool position_free(std::span<const double>) const override {
    if (++asked_ > 50) throw std::runtime_error("cable");
    return true;
  }
  bool motion_free(std::span<const double>, std::span<const double>) const override { return true; }
  double clearance() const override { return 0.001; }

 private:
  mutable std::atomic<int> asked_{0};
};

TEST(ArmPlan, WhatASensorThrowsArrives) {
  const Case c = make_case("industrial6", 2, 0, 0, 12);
  for (const int threads : {1, 4}) {
    Parameters p = c.parameters;
    p.threads = threads;
    EXPECT_THROW(plan(c.robot, Broken(), c.request, p), std::runtime_error);
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
  EXPECT_EQ(back.arrived[0], c.parameters.ants);
  EXPECT_LT(killed.arrived[0], c.parameters.ants);
}

}  // namespace
}  // namespace lasius::arm
