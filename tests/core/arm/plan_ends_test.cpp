#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <stop_token>

#include "lasius/base/error.h"
#include "tests/core/arm/questions.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/base/refusal.h"
#include "tests/core/params/parameter_ends.h"

// How runs end before their time: refused, proven hopeless, stopped.
namespace lasius::arm {
namespace {

/// Eleven points a side: quick, for the two links.
Params small_lattice() {
  Params p("goritov2020");
  p.pitch = 0.05;
  p.side = 11;
  return p;
}

TEST(ArmPlan, SaysOfALatticeWithoutAWayThatItIsTheLattice) {
  const Robot robot = two_links();
  const Request request = across(robot);
  const double from = tip_position(robot, request.start).x();
  const Params parameters = small_lattice();
  const Wall wall(robot, from - 0.09, 0.06);
  const Result r = plan(robot, wall, request, parameters);
  EXPECT_EQ(r.status, Status::no_path);
  expect_says(r.error, "pitch 0.05 m");
  expect_says(r.error, "try a smaller pitch, or the algorithm postures");
  EXPECT_LT(r.curves.iterations, 100);
  EXPECT_EQ(r.joints.cols(), 0);
  EXPECT_TRUE(std::isnan(r.length));
  EXPECT_EQ(shortest_lattice_way(robot, wall, request, parameters).status, Status::no_path);

  // The goal itself is blocked, be it beside an ant or out of reach: that beats unreachable.
  for (const double x : {request.goals[0].target.translation().x() + 0.01, from - 0.12}) {
    const Result blocked = plan(robot, Wall(robot, x), request, parameters);
    EXPECT_EQ(blocked.status, Status::invalid);
    EXPECT_EQ(blocked.error, "the arm touches something at the goal");
  }
}

TEST(ArmPlan, BadQuestionsAreAnswers) {
  const Robot robot = two_links();
  const Nothing sensor;
  const auto expect_invalid = [&](Request request, const std::string& words) {
    const Result r = plan(robot, sensor, request, Params("goritov2020"));
    EXPECT_EQ(r.status, Status::invalid);
    expect_says(r.error, words);
  };
  expect_invalid({.start = joints({0}), .goals = {Eigen::Vector3d(0.9, 0, 0)}}, "1 joint values");
  expect_invalid({.start = joints({0, 4}), .goals = {Eigen::Vector3d(0.9, 0, 0)}}, "joint 2");
  expect_invalid({.start = joints({0, std::nan("")}), .goals = {Eigen::Vector3d(0.9, 0, 0)}},
                 "joint 2");
  expect_invalid({.start = joints({0, 1}), .goals = {Eigen::Vector3d(2, 0, 0)}}, "outside");
  expect_invalid({.start = joints({0, 1}), .goals = {Eigen::Vector3d(std::nan(""), 0, 0)}},
                 "outside");
  expect_invalid({.start = joints({0, 1}), .goals = {Eigen::Vector3d(2, 0, 0)}},
                 "it is 2 m from the arm's first joint");
  expect_invalid({.start = joints({0, 1}), .goals = {Eigen::Vector3d(0.5, 0, 0.3)}},
                 "in one plane, the goal is 0.3 m off it");
  // Folded up, links of 0.5 and 0.4 leave 0.1 between tip and shoulder, at the limit of 3 rad more.
  expect_invalid({.start = joints({0, 1}), .goals = {Eigen::Vector3d(0.05, 0, 0)}},
                 "the arm folds to 0.1 m");
  Request near = across(robot);
  Eigen::Vector3d beside = tip_position(robot, near.start);
  beside.y() += 0.001;
  near.goals = {beside};
  EXPECT_EQ(plan(robot, sensor, near, Params("goritov2020")).status, Status::solved);
  const Wall everywhere(robot, 10);
  EXPECT_EQ(plan(robot, everywhere, across(robot), Params("goritov2020")).error,
            "the arm touches something at the start");
}

// A goal that is off the plane is proven out of reach; one that was not found is not.
TEST(ArmPlan, OnlyWhatIsProvenIsOutOfReach) {
  const auto answer = [](const Robot& robot, std::initializer_list<double> start, Vec3 goal) {
    return plan(robot, Nothing(), {.start = joints(start), .goals = {Eigen::Vector3d(goal)}},
                Params("goritov2020"));
  };
  // A turn about z and one about y reach a sphere with two links in line, and a torus otherwise.
  Robot robot = two_links();
  robot.joints[1].axis = {0, 1, 0};
  const Result torus = answer(robot, {0, 0.5}, {0.5, 0, 0});
  EXPECT_EQ(torus.status, Status::no_path);
  EXPECT_EQ(torus.fault, Fault::none);
  expect_says(torus.error, "not found in this lattice");
  // Tilted as a whole, and with a slide in it, the arm is still a planar one.
  robot = two_links();
  for (Joint& joint : robot.joints) joint.axis = {0, 0.6, 0.8};
  robot.joints[1].kind = Joint::Kind::prismatic;
  robot.joints[1].axis = {1, 0, 0};
  EXPECT_EQ(answer(robot, {0, 0}, {0.5, 0.1, 0}).error,
            "goal 0.5,0.1,0 is out of reach: the joints move the tip in one plane, the goal is "
            "0.06 m off it");
}

TEST(ArmPlan, BadParametersAreRefused) {
  const Robot robot = two_links();
  const Nothing sensor;
  const auto refused = [&](auto change) {
    Params p("goritov2020");
    change(p);
    EXPECT_THROW(plan(robot, sensor, across(robot), p), Error);
  };
  refused([](Params& p) { p.ants = 0; });
  refused([](Params& p) { p.iterations = -1; });
  refused([](Params& p) { p.alpha = 9; });
  refused([](Params& p) { p.persistence = 1.1; });
  refused([](Params& p) { p.persistence = std::nan(""); });
  refused([](Params& p) { p.seed = std::uint64_t{1} << 53; });
  refused([](Params& p) { p.initial_pheromone = 1e-310; });
  refused([](Params& p) { p.pitch = 1e-5; });  // too many points
  refused([](Params& p) { p.pitch = 1e-300; });
  Params p("goritov2020");
  EXPECT_THROW(set_parameter(p, "elite_wait", "1"), Error);
  EXPECT_THROW(find_algorithm("goritov2021"), Error);
  EXPECT_THROW(set_parameter(p, "ants", "many"), Error);
  set_parameter(p, "pheromone", "edges");
  EXPECT_EQ(get_parameter(p, "pheromone"), "edges");
  EXPECT_EQ(p.pheromone, Pheromone::edges);
}

TEST(ArmPlan, EveryRangeIsTheOneThatIsTold) { expect_ranges<Params>(algorithms()); }

TEST(ArmPlan, ParametersAtTheEndsOfTheirRanges) {
  const Robot robot = two_links();
  Request request = across(robot);
  const auto plan_with = [&](std::string_view name, const std::string& value,
                             const StopCondition& stop) {
    Params p = small_lattice();
    p.iterations = 2;
    set_parameter(p, name, value);
    request.stop = stop;
    const Result r = plan(robot, Nothing(), request, p);
    EXPECT_EQ(r.joints.cols() == 0, std::isnan(r.length)) << name << " " << value;
  };
  for (const Algorithm& algorithm : algorithms()) plan_at_both_ends(algorithm, plan_with);
}

TEST(ArmPlan, TheLeastPheromoneUnderTheStrongestEvaporation) {
  const Robot robot = two_links();
  Params p = small_lattice();
  p.initial_pheromone = 1e-12;
  p.persistence = 0;
  p.alpha = 8;
  EXPECT_EQ(plan(robot, Nothing(), across(robot), p).curves.iterations, p.iterations);
}

TEST(ArmPlan, StopsEarlyWhenAsked) {
  Case c = make_case("industrial6", 3, 10, 0, 10);
  const SceneSensor sensor(c.robot, c.scene);
  c.parameters.patience = 5;
  const Result patient = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_LT(patient.curves.iterations, 100);
  EXPECT_EQ(patient.status, Status::solved);

  c.parameters.patience = 0;
  c.request.target_gap = 0.5;
  const Result close = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_LT(close.curves.iterations, 100);
  EXPECT_LE(close.gap().value(), 0.5);
}

TEST(ArmPlan, TokenAndDeadlineKeepTheBest) {
  Case c = make_case("industrial6", 3, 10, 0, 12);
  const SceneSensor sensor(c.robot, c.scene);
  c.parameters.iterations = 1000000;
  std::stop_source source;
  c.request.stop.token = source.get_token();
  const Result r = plan(c.robot, sensor, c.request, c.parameters, [&](const ArmProgress& view) {
    if (view.iteration == 3) source.request_stop();
  });
  EXPECT_EQ(r.status, Status::interrupted);
  EXPECT_EQ(r.curves.iterations, 4);
  EXPECT_GT(r.joints.cols(), 0);

  c.request.stop = {.deadline = Clock::now()};
  const Result late = plan(c.robot, sensor, c.request, c.parameters);
  EXPECT_EQ(late.status, Status::limit);
  EXPECT_EQ(late.limit, Limit::time);
  EXPECT_EQ(late.curves.iterations, 0);
}

// What the observer ended is not gone on with: the motion rests at each waypoint.
TEST(ArmPlan, AnObserverEndsSearchAndMotion) {
  Case c = make_case("industrial6", 3, 10, 0, 12);
  const SceneSensor sensor(c.robot, c.scene);
  c.parameters.iterations = 1000000;
  Eigen::MatrixXd best;
  const Result r = plan(c.robot, sensor, c.request, c.parameters, [&](const ArmProgress& view) {
    best = view.joints();
    EXPECT_EQ(best.cols() == 0, std::isnan(view.best_length));
    return view.iteration == 3 ? Go::stop : Go::on;
  });
  EXPECT_EQ(r.status, Status::interrupted);
  EXPECT_EQ(r.curves.iterations, 4);
  ASSERT_GT(r.joints.cols(), 0);
  EXPECT_EQ(best, r.joints);
  EXPECT_FALSE(r.trajectory.empty());
  EXPECT_TRUE(r.stops);
  EXPECT_LE(r.questions.trajectory, 16);
}

TEST(ArmPlan, AnObserverComesTooLateOnceTheSearchHasEnded) {
  Case c = make_case("industrial6", 3, 10, 0, 12);
  const SceneSensor sensor(c.robot, c.scene);
  for (const int patience : {0, 2}) {  // to the last iteration, or until it settles
    c.parameters.iterations = patience > 0 ? 1000000 : 3;
    c.parameters.patience = patience;
    const Result whole = plan(c.robot, sensor, c.request, c.parameters);
    ASSERT_EQ(whole.status, Status::solved);
    for (const int before : {1, 0}) {
      const Result r = plan(c.robot, sensor, c.request, c.parameters, [&](const ArmProgress& view) {
        return view.iteration + 1 == whole.curves.iterations - before ? Go::stop : Go::on;
      });
      EXPECT_EQ(r.curves.iterations, whole.curves.iterations - before);
      EXPECT_EQ(r.status, before > 0 ? Status::interrupted : Status::solved) << patience;
      if (before == 0) {
        EXPECT_EQ(r.joints, whole.joints);
      }
    }
  }
}

TEST(ArmPlan, PolledAmongAntsOfFewSteps) {
  const Robot robot = two_links();
  Request request = across(robot);
  Params p = small_lattice();
  p.ants = 1000;
  const CountingTime time(50);
  request.stop = time.is_up();
  const Result r = plan(robot, Nothing(), request, p);
  EXPECT_EQ(r.status, Status::limit);
  EXPECT_EQ(r.curves.iterations, 0);
}

Result plan_quietly(const Robot& robot, const Sensor& sensor, const Request& request,
                    const Params& parameters) {
  return plan(robot, sensor, request, parameters);
}

/// Takes a second for every question, by the clock that it is.
class Slow final : public Nothing, public TimeSource {
 public:
  bool position_free(const JointRef&) const override { return asked(); }
  bool motion_free(const JointRef&, const JointRef&) const override { return asked(); }
  Clock::time_point now() const noexcept override {
    return Clock::time_point{} + std::chrono::seconds(seconds_);
  }

 private:
  bool asked() const {
    ++seconds_;
    return true;
  }

  mutable std::atomic<int> seconds_{0};
};

TEST(ArmPlan, PolledAfterEveryMoveThatASensorIsAskedAbout) {
  const Robot robot = two_links();
  Request request = across(robot);
  Params p("goritov2020");
  p.pitch = 0.02;
  constexpr int kSeconds = 10;
  for (const auto& ask : {plan_quietly, shortest_lattice_way, straight_lattice_way}) {
    for (const int threads : {1, 3}) {
      p.threads = threads;
      const Slow sensor;
      request.stop = {.deadline = sensor.now() + std::chrono::seconds(kSeconds), .time = &sensor};
      const Result r = ask(robot, sensor, request, p);
      EXPECT_EQ(r.status, Status::limit);
      EXPECT_GE(r.questions.positions + r.questions.motions, kSeconds);
      EXPECT_LE(r.questions.positions + r.questions.motions, kSeconds + 2 * threads);
    }
  }
}

// However few questions are left, it is time that ended the search where it did.
TEST(ArmPlan, TellsOfTwoLimitsTheOneThatEndedIt) {
  const Robot robot = two_links();
  Request request = across(robot);
  request.stop.deadline = Clock::time_point::min();
  Params p;
  const auto limit = [&](int most) {
    p.max_questions = most;
    return plan(robot, Nothing(), request, p).limit;
  };
  EXPECT_EQ(limit(1), Limit::questions);  // none is left after that about the start
  EXPECT_EQ(limit(2), Limit::time);
  EXPECT_EQ(limit(3), Limit::time);
  request.stop = {};
  EXPECT_EQ(limit(2), Limit::questions);
}

TEST(ArmPlan, WhatIsStoppedAtOnceDoesNotSayThatThereIsNoWay) {
  const Robot robot = shipped("planar3");
  for (const std::uint64_t seed : {4, 10, 25, 32, 33, 56}) {
    const Query query = generate_query(robot, {.seed = seed, .obstacles = 3});
    const SceneSensor sensor(robot, query.scene);
    Request request{.start = query.start, .goals = {query.goal}, .stop = fired()};
    EXPECT_EQ(plan(robot, sensor, request).status, Status::interrupted) << seed;
    request.stop = {.deadline = Clock::time_point::min()};
    EXPECT_EQ(plan(robot, sensor, request).limit, Limit::time) << seed;
    EXPECT_EQ(plan(robot, sensor, request).error, "");
  }
}

TEST(ArmPlan, AMotionCutShortIsNotSolved) {
  const Robot robot = two_links();
  Request request = across(robot);
  request.motion = false;
  Params p("goritov2020");
  p.pitch = 0.05;
  p.iterations = 3;
  p.threads = 1;
  const Slow search_alone;
  const Result found = plan(robot, search_alone, request, p);
  ASSERT_EQ(found.status, Status::solved);
  request.motion = true;
  const Slow sensor;
  const auto asked = std::chrono::seconds(found.questions.positions + found.questions.motions);
  request.stop = {.deadline = sensor.now() + asked + std::chrono::seconds(2), .time = &sensor};
  const Result cut = plan(robot, sensor, request, p);
  EXPECT_EQ(cut.status, Status::limit);
  EXPECT_EQ(cut.limit, Limit::time);
  EXPECT_EQ(cut.length, found.length);
  EXPECT_GT(cut.questions.trajectory, 0);
  EXPECT_FALSE(cut.trajectory.empty());
}

/// Breaks down after some questions.
class Broken final : public Nothing {
 public:
  bool position_free(const JointRef&) const override {
    if (++asked_ > 50) throw std::runtime_error("cable");
    return true;
  }

 private:
  mutable std::atomic<int> asked_{0};
};

TEST(ArmPlan, WhatASensorThrowsArrives) {
  const Case c = make_case("industrial6", 2, 0, 0, 12);
  for (const int threads : {1, 4}) {
    Params p = c.parameters;
    p.threads = threads;
    EXPECT_THROW(plan(c.robot, Broken(), c.request, p), std::runtime_error);
  }
}

}  // namespace
}  // namespace lasius::arm
