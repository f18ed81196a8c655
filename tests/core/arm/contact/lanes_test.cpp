// What is looked at first, in lanes and in tables, against postures by the hundred.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/arm/contact/contact.h"
#include "core/arm/contact/inner_balls.h"
#include "core/arm/contact/pair_tests.h"
#include "lasius/arm/generate.h"
#include "lasius/arm/sensor.h"
#include "tests/core/arm/contact/draw.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/core/base/counting_time.h"

namespace lasius::arm {
namespace {

constexpr double kClearance = 1e-4;

Robot scara() {
  return read_robot(LASIUS_MAPS_DIR "/../tests/core/arm/robots/scara.urdf", {.tip = "tool"});
}

/// The robot with the solids of these bodies alone.
Robot only(Robot robot, const std::vector<int>& bodies) {
  for (Link& link : robot.links)
    if (std::ranges::find(bodies, link.body) == bodies.end()) link.solids.clear();
  return robot;
}

/// Each solid a globe of this radius instead.
Robot globes(Robot robot, double radius) {
  Triangles triangles = globe(8);
  for (auto& triangle : triangles)
    for (Eigen::Vector3d& corner : triangle) corner *= radius;
  const auto shared = std::make_shared<const Triangles>(std::move(triangles));
  for (Link& link : robot.links) {
    for (Solid& solid : link.solids) {
      solid.shape = Solid::Shape::mesh;
      solid.triangles = shared;
    }
  }
  return robot;
}

/// Whether two shapes, or parts of them, are nearer than the clearance.
bool near(const Shape& a, const Placement& at, const Shape& b) {
  const Placement world{};
  const PlacedShape other(b, world);
  const BallGap ball = ball_gap(a, at, b, other);
  if (ball.gap >= kClearance) return false;
  if (a.exact && b.exact) {
    return shapes_apart<GjkAsked::decision>(a, PlacedShape(a, at), ball.guess, b, other,
                                            kClearance) < kClearance;
  }
  const bool first = first_is_opened(a, b);
  return std::ranges::any_of(parts_of(first ? a : b), [&](const Shape* part) {
    return first ? near(*part, at, b) : near(a, at, *part);
  });
}

/// What kernels say of a motion, the same for every instruction set.
struct Look {
  std::vector<const Shape*> shapes;
  std::vector<kernels::LaneMiss> misses;
  bool touches;

  Look(const LaneModel& model, const Scene& scene, const kernels::LaneMotion& motion) {
    std::vector<kernels::LaneObstacle> obstacles;
    for (const Obstacle& obstacle : scene.obstacles) {
      shapes.push_back(store_.add(obstacle, -1));
      obstacles.push_back(model.obstacle(*shapes.back()));
    }
    const kernels::LaneContact& plain = kernels::lane_contact(kernels::Isa::scalar);
    plain.sweep(model.robot, obstacles, motion, misses);
    touches = plain.touches(model.robot, obstacles, motion);
    for (const kernels::Isa isa : {kernels::Isa::avx2, kernels::Isa::avx512}) {
      if (isa > kernels::supported_isa()) continue;
      std::vector<kernels::LaneMiss> others;
      kernels::lane_contact(isa).sweep(model.robot, obstacles, motion, others);
      EXPECT_EQ(misses, others);
      EXPECT_EQ(kernels::lane_contact(isa).touches(model.robot, obstacles, motion), touches);
    }
  }

 private:
  ShapeStore store_;
};

TEST(Lanes, SayWhatAllPosturesSayAndTheSameOnEveryMachine) {
  Draw draw(23);
  int touching = 0, passed = 0, open = 0;
  for (Robot robot : {shipped("industrial6"), shipped("redundant7"), scara(),
                      globes(shipped("industrial6"), 0.1)}) {
    for (int a = 0; a < static_cast<int>(robot.links.size()); ++a)
      for (int b = 0; b < a; ++b) robot.may_touch.emplace_back(b, a);
    const auto shapes = std::make_shared<const RobotShapes>(robot, kClearance);
    const LaneModel& model = shapes->lanes();
    for (int i = 0; i < 40; ++i) {
      const Scene scene = any_scene(draw, 1 + i % 16);
      const Contact contact(shapes, scene);
      const JointVector from = draw.values(robot);
      const JointVector to = from + draw.between(0.05, 0.5) * (draw.values(robot) - from);
      const Look look(model, scene, {from.data(), to.data(), 16, 8, kClearance});
      bool seen = false;
      for (int l = 0; l < kernels::kLanes; ++l) {
        const double first = (8 + l) / 16.0;
        const JointVector middle = from + (first + 0.5 / 16) * (to - from);
        seen = seen || contact.nearest(as_span(middle)).distance <= 0;
        // By body, piece of it, and obstacle: what was not missed in this part is apart all along.
        std::set<std::array<int, 3>> missed;
        for (const auto& [body, ball, obstacle, parts] : look.misses)
          if ((parts >> l & 1) != 0) missed.insert({body, ball, obstacle});
        open += static_cast<int>(missed.size());
        for (int s = 0; s <= 10; ++s) {
          const JointVector q = from + (first + s / 160.0) * (to - from);
          Kinematics::Poses poses;
          Bodies bodies;
          place_bodies(shapes->kinematics(), as_span(q), poses, bodies);
          for (int k = 0; k < robot.size(); ++k) {
            const auto& nodes = model.nodes[k];
            for (int b = nodes.size() > 1; b < static_cast<int>(nodes.size()); ++b) {
              for (int o = 0; o < static_cast<int>(look.shapes.size()); ++o) {
                if (missed.count({k, b, o}) > 0) continue;
                ++passed;
                EXPECT_FALSE(near(*nodes[b], bodies[k + 1], *look.shapes[o])) << k << b << o;
              }
            }
          }
        }
      }
      touching += look.touches;
      EXPECT_TRUE(seen || !look.touches);
    }
  }
  EXPECT_GT(touching, 10);
  EXPECT_GT(passed, 100000);
  EXPECT_GT(open, 1000);
  EXPECT_LT(open, 3000);  // bounds are tight
}

TEST(Lanes, WhatIsWhollyInsideOfAMeshDoesNotTouchIt) {
  const Robot robot = globes(only(shipped("industrial6"), {5}), 0.15);
  const auto shapes = std::make_shared<const RobotShapes>(robot, kClearance);
  const LaneModel& model = shapes->lanes();
  ASSERT_FALSE(model.robot.bodies[4].inner.empty());
  EXPECT_TRUE(model.robot.bodies[4].inner[0].hollow);
  const Vec3 middle = shapes->body(5)->centre;
  Draw draw(31);
  int inside = 0, across = 0, outside = 0;
  for (int i = 0; i < 400; ++i) {
    const JointVector q = draw.values(robot), to = q + JointVector::Constant(robot.size(), 1e-5);
    Kinematics::Poses poses;
    Bodies bodies;
    place_bodies(shapes->kinematics(), as_span(q), poses, bodies);
    Scene scene;
    scene.obstacles.push_back(any_scene(draw, 5).obstacles[i % 5]);
    Obstacle& o = scene.obstacles[0];
    const double small = draw.one_in(2) ? 0.2 : 1;
    o.radius *= small;
    o.length *= small;
    o.size *= small;
    const Vec3 at = bodies[5] * middle + draw.point(draw.one_in(2) ? 0.05 : 0.3);
    o.pose.translation() = Eigen::Vector3d(at.x, at.y, at.z);
    const double nearest = Contact(shapes, scene).nearest(as_span(q)).distance;
    if (nearest > 0 && nearest < 1e-3) continue;
    const bool touches = Look(model, scene, {q.data(), to.data(), 8, 0, kClearance}).touches;
    if (nearest > 0) {
      EXPECT_FALSE(touches) << i;
      (distance(at, bodies[5] * middle) < 0.1 ? inside : outside)++;
    } else {
      across += touches;
    }
  }
  EXPECT_GT(inside, 40);
  EXPECT_GT(across, 40);
  EXPECT_GT(outside, 40);
}

TEST(Lanes, AreCutAmongManyObstacles) {
  // Far away, so that a glance at each is all that is done.
  const Robot robot = shipped("industrial6");
  Scene scene;
  scene.obstacles.assign(20000, ball({50, 0, 0}, 0.1));
  const SceneSensor sensor(robot, scene);
  Draw draw(37);
  const JointVector from = JointVector::Zero(robot.size()), to = from + 0.1 * draw.values(robot);
  ASSERT_EQ(sensor.try_motion(from, to, {}), true);
  for (const int polls : {1, 5, 20}) {
    const CountingTime time(polls);
    EXPECT_EQ(sensor.try_motion(from, to, time.is_up()), std::nullopt);
    EXPECT_EQ(time.polls(), polls + 1);
  }
}

TEST(PairTable, DoubtsAllThatComesNear) {
  Draw draw(29);
  int sure = 0, doubtful = 0;
  const StopCondition never;
  Poller poller(never);
  for (const Robot& whole : {shipped("industrial6"), shipped("redundant7"), scara()}) {
    const RobotShapes all(whole, kClearance);
    for (const ShapePair& pair : all.pairs()) {
      if (pair.body > pair.from + 2) continue;
      const Robot robot = only(whole, {pair.body, pair.from});
      const RobotShapes shapes(robot, kClearance);
      const SceneSensor sensor(robot, {}, kClearance);
      if (shapes.pairs().size() != 1) continue;
      for (int i = 0; i < 30; ++i) {
        const JointVector from = draw.values(robot), to = draw.values(robot);
        const PairTable::Doubt doubt = shapes.table(0)->doubt(as_span(from), as_span(to), poller);
        (doubt.first > doubt.last ? sure : doubtful)++;
        for (int s = 0; s <= 100; ++s) {
          if (s / 100.0 >= doubt.first && s / 100.0 <= doubt.last) continue;
          EXPECT_GE(sensor.distance(from + s / 100.0 * (to - from)), kClearance) << s;
        }
      }
    }
  }
  EXPECT_GT(sure, 20);
  EXPECT_GT(doubtful, 2);
}

TEST(InnerBalls, FillABarOfTriangles) {
  Triangles bar = cube(0.1);
  for (auto& triangle : bar)
    for (Eigen::Vector3d& corner : triangle) corner.x() *= 5;
  const auto balls = inner_balls(mesh_of(bar));
  EXPECT_GE(balls.size(), 4u);
  for (const InnerBall& ball : balls) {
    EXPECT_LE(std::abs(ball.centre.x) + ball.radius, 0.5);
    EXPECT_LE(std::max(std::abs(ball.centre.y), std::abs(ball.centre.z)) + ball.radius, 0.1);
  }
}

TEST(PairTable, ALookThatIsCutIsNotKept) {
  const Robot robot = globes(shipped("industrial6"), 0.2);
  const RobotShapes shapes(robot, kClearance), others(robot, kClearance);
  const auto polls = [](const PairTable& table, const JointVector& from, const JointVector& to,
                        int most) {
    const CountingTime time(most);
    const StopCondition stop = time.is_up();
    Poller poller(stop, 1);
    table.doubt(as_span(from), as_span(to), poller);
    return time.polls();
  };
  Draw draw(41);
  int cut = 0;
  for (std::size_t p = 0; p < shapes.pairs().size(); ++p) {
    if (shapes.table(p) == nullptr) continue;
    for (int i = 0; i < 100; ++i) {
      const JointVector from = draw.values(robot), to = from + 1e-3 * draw.values(robot);
      cut += polls(*shapes.table(p), from, to, 0) > 0;
      const int left = polls(*shapes.table(p), from, to, 1 << 20);
      EXPECT_EQ(left, polls(*others.table(p), from, to, 1 << 20)) << p << " " << i;
    }
  }
  EXPECT_GT(cut, 5);
}

}  // namespace
}  // namespace lasius::arm
