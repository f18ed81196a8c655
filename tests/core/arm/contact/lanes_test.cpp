// What is looked at first, in lanes and in tables, against postures by the hundred.
#include <gtest/gtest.h>

#include "core/arm/contact/contact.h"
#include "lasius/arm_generate.h"
#include "lasius/arm_sensor.h"
#include "tests/core/arm/contact/draw.h"
#include "tests/core/arm/robot/arms.h"

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

TEST(Lanes, SayWhatAllPosturesSayAndTheSameOnEveryMachine) {
  Draw draw(23);
  int touching = 0, passed = 0, open = 0;
  for (Robot robot : {shipped("industrial6"), shipped("redundant7"), scara()}) {
    for (int a = 0; a < static_cast<int>(robot.links.size()); ++a)
      for (int b = 0; b < a; ++b) robot.may_touch.emplace_back(b, a);
    const auto shapes = std::make_shared<const RobotShapes>(robot, kClearance);
    const LaneModel& model = shapes->lanes();
    for (int i = 0; i < 40; ++i) {
      const Scene scene = any_scene(draw, 1 + i % 16);
      const Contact contact(shapes, scene);
      std::vector<kernels::LaneObstacle> obstacles;
      ShapeStore store;
      for (const Obstacle& obstacle : scene.obstacles)
        obstacles.push_back(model.obstacle(*store.add(obstacle, -1)));
      const JointVector from = draw.values(robot);
      const JointVector to = from + draw.between(0.05, 0.5) * (draw.values(robot) - from);
      const kernels::LaneMotion motion{from.data(), to.data(), 16, 8, kClearance};
      const kernels::LaneContact& plain = kernels::lane_contact(kernels::Isa::scalar);
      std::vector<kernels::LaneMiss> misses;
      plain.sweep(model.robot, obstacles, motion, misses);
      const bool touches = plain.touches(model.robot, obstacles, motion);
      for (const kernels::Isa isa : {kernels::Isa::avx2, kernels::Isa::avx512}) {
        if (isa > kernels::supported_isa()) continue;
        std::vector<kernels::LaneMiss> others;
        kernels::lane_contact(isa).sweep(model.robot, obstacles, motion, others);
        EXPECT_EQ(misses, others);
        EXPECT_EQ(kernels::lane_contact(isa).touches(model.robot, obstacles, motion), touches);
      }
      const auto nearest = [&](double s) {
        const JointVector q = from + s * (to - from);
        return contact.nearest(as_span(q)).distance;
      };
      bool seen = false;
      for (int l = 0; l < kernels::kLanes; ++l) {
        const double first = (8 + l) / 16.0;
        seen = seen || nearest(first + 0.5 / 16) <= 0;
        if (std::ranges::any_of(misses, [&](const auto& m) { return (m.parts >> l & 1) != 0; })) {
          ++open;
          continue;
        }
        ++passed;
        for (int s = 0; s <= 20; ++s) EXPECT_GE(nearest(first + s / 320.0), kClearance);
      }
      touching += touches;
      EXPECT_TRUE(seen || !touches);
    }
  }
  EXPECT_GT(touching, 10);
  EXPECT_GT(passed, 100);
  EXPECT_GT(open, 100);
}

TEST(PairTable, DoubtsAllThatComesNear) {
  Draw draw(29);
  int sure = 0, doubtful = 0;
  const StopCondition never;
  Poller poller(never);
  for (const Robot& whole : {shipped("industrial6"), shipped("redundant7"), scara()}) {
    for (const ShapePair& pair : RobotShapes(whole, kClearance).pairs()) {
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

}  // namespace
}  // namespace lasius::arm
