// Plans on shipped and on random maps for three footprints, judged every 0.05 cells by the oracle:
// forwards, reversing, in place; ends and joints by its own arithmetic.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "lasius/grid/map_io.h"
#include "lasius/vehicle/planner.h"
#include "tests/oracle/vehicle/footprint_judge.h"
#include "tests/oracle/vehicle/motions.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

using oracle::FootprintJudge;
using oracle::Motion;
using oracle::motions_of;

double apart(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]) +
         std::abs(std::remainder(a[2] - b[2], 2 * std::numbers::pi));
}

/// Ends and joints, what the vehicle may drive, contacts.
void judge(FootprintJudge& judge, const Vehicle& vehicle, const Pose& start, const Pose& goal,
           const Result& result) {
  const std::vector<Motion> path = motions_of(result.segments);
  std::array<double, 3> at{start.x, start.y, start.yaw};
  for (const Motion& motion : path) {
    ASSERT_LE(apart(at, {motion.x, motion.y, motion.yaw}), 1e-6);
    ASSERT_LE(std::abs(motion.curvature) * vehicle.turning_radius, 1 + 1e-12);
    ASSERT_TRUE(motion.gear == 1 || (motion.gear == -1 && vehicle.reverse) ||
                (motion.gear == 0 && vehicle.rotate_in_place));
    at = FootprintJudge::pose_at(motion, 1);
  }
  ASSERT_LE(apart(at, {goal.x, goal.y, goal.yaw}), 1e-6);
  const auto touch = judge.first_touch(path);
  ASSERT_FALSE(touch) << "at " << touch->x << ", " << touch->y << ", " << touch->yaw << " cell "
                      << touch->cell.x << ", " << touch->cell.y;
}

TEST(VehiclePaths, TouchNothingThatTheOracleSees) {
  std::mt19937 random(20);
  std::vector<Grid> grids{read_map(LASIUS_MAPS_DIR "/fan400x200.map").grid,
                          read_map(LASIUS_MAPS_DIR "/workspace-simple.pbm").grid,
                          random_blocks(120, 90, 40, 9, random),
                          random_blocks(200, 60, 50, 9, random)};
  Vehicle truck = car(rectangle(1, 5, 1.5), 5);
  truck.reverse = false;
  // An L: what it holds, and what its hull holds beside, differ.
  const Vehicle robot =
      differential({{-2.5, -2}, {2.5, -2}, {2.5, -0.5}, {0, -0.5}, {0, 2}, {-2.5, 2}});
  const std::vector<Vehicle> vehicles{car(rectangle(2, 2, 1.25), 3), truck, robot,
                                      omni(robot.footprint)};
  std::int64_t paths = 0, poses = 0;
  for (const Grid& grid : grids)
    for (const Vehicle& vehicle : vehicles) {
      const Planner planner(grid, vehicle);
      FootprintJudge judged(grid, vehicle.footprint);
      const auto free_pose = [&] {
        for (;;) {
          const auto real = [&](double most) {
            return std::uniform_real_distribution<double>(0, most)(random);
          };
          const Pose pose{real(grid.width()), real(grid.height()), real(2 * std::numbers::pi)};
          const bool touched = judged.touched(pose.x, pose.y, pose.yaw).has_value();
          if (planner.space().free(pose)) {
            EXPECT_FALSE(touched);
            return pose;
          }
        }
      };
      for (int pair = 0; pair < 6; ++pair) {
        const Pose start = free_pose(), goal = free_pose();
        const Result result = planner.plan({.start = start, .goals = {goal}, .bound = false});
        if (result.segments.empty()) continue;
        ++paths;
        judge(judged, vehicle, start, goal, result);
      }
      poses += judged.poses();
    }
  EXPECT_GE(paths, 55) << "of 96";
  EXPECT_GE(poses, 50'000);
}

}  // namespace
}  // namespace lasius::vehicle
