#include "lasius/arm/generate.h"

#include <gtest/gtest.h>

#include "lasius/arm/sensor.h"
#include "lasius/base/error.h"
#include "tests/core/arm/robot/arms.h"

namespace lasius::arm {
namespace {

TEST(Generate, QuestionsAreFreeAndTheSameBySeed) {
  const Robot robot = shipped("industrial6");
  const Query a = generate_query(robot, {.seed = 3, .obstacles = 15, .wall = 1});
  const Query b = generate_query(robot, {.seed = 3, .obstacles = 15, .wall = 1});
  const Query c = generate_query(robot, {.seed = 4, .obstacles = 15, .wall = 1});
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.goal, b.goal);
  EXPECT_NE(a.start, c.start);
  EXPECT_EQ(a.scene.obstacles.size(), 16u);
  EXPECT_TRUE(SceneSensor(robot, a.scene).position_free(a.start));
  EXPECT_THROW(generate_query(robot, {.obstacles = -1}), Error);
  EXPECT_THROW(generate_query(robot, {.least_distance = 2}), Error);
}

}  // namespace
}  // namespace lasius::arm
