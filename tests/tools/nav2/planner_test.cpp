// The plug-in as planner_server uses it: through the interface of Nav2, with and without viapoints.
#include <gtest/gtest.h>

#include <cmath>
#include <nav2_core/global_planner.hpp>
#include <nav2_core/planner_exceptions.hpp>

#include "lasius/vehicle/space.h"

extern "C" nav2_core::GlobalPlanner* lasius_nav2_make();

namespace lasius {
namespace {

using geometry_msgs::msg::PoseStamped;

constexpr double kCell = 0.05, kLeft = -2, kBottom = 1;

PoseStamped pose(double x, double y, double yaw) {
  PoseStamped pose;
  pose.header.frame_id = "map";
  pose.pose.position = {x, y, 0};
  pose.pose.orientation = {0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
  return pose;
}

/// 8 m x 4 m, a wall at x = 2 m with a door at its lower end.
class Nav2Planner : public ::testing::Test {
 protected:
  Nav2Planner() {
    for (unsigned int y = 30; y < 80; ++y) {
      for (unsigned int x = 80; x < 83; ++x)
        costmap_.setCost(x, y, nav2_costmap_2d::LETHAL_OBSTACLE);
      costmap_.setCost(83, y, 200);  // inflated: no obstacle
    }
    costmap_.setCost(100, 40, nav2_costmap_2d::NO_INFORMATION);
  }
  void set(const std::string& name, const auto& value) {
    node_->declare_parameter("lasius." + name, rclcpp::ParameterValue(value));
  }
  void configure() {
    planner_->configure(node_, "lasius", std::make_shared<tf2_ros::Buffer>(), ros_);
    planner_->activate();
  }
  nav_msgs::msg::Path plan(
      const PoseStamped& start, const PoseStamped& goal, const std::vector<PoseStamped>& via = {},
      const std::function<bool()>& cancel = [] { return false; }) {
#ifdef LASIUS_NAV2_VIAPOINTS
    return planner_->createPlan(start, goal, via, cancel);
#else
    EXPECT_TRUE(via.empty());
    return planner_->createPlan(start, goal, cancel);
#endif
  }
  /// The poses touch nothing, and are at most a cell apart.
  void check(const nav_msgs::msg::Path& path, const PoseStamped& start, const PoseStamped& goal) {
    ASSERT_FALSE(path.poses.empty());
    EXPECT_EQ(path.header.frame_id, "map");
    Grid grid(160, 80);
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 160; ++x)
        if (costmap_.getCharMap()[y * 160 + x] == nav2_costmap_2d::LETHAL_OBSTACLE)
          grid.set_blocked({x, 79 - y});
    std::vector<Point> footprint;
    for (const auto& p : ros_->getRobotFootprint())
      footprint.push_back({p.x / kCell, -p.y / kCell});
    const vehicle::Space space(grid, vehicle::differential(footprint));
    std::vector<vehicle::Pose> poses;
    for (const PoseStamped& at : path.poses) {
      const auto& p = at.pose.position;
      poses.push_back({(p.x - kLeft) / kCell, 80 - (p.y - kBottom) / kCell,
                       -2 * std::atan2(at.pose.orientation.z, at.pose.orientation.w)});
    }
    EXPECT_FALSE(space.first_contact(std::span<const vehicle::Pose>(poses)));
    for (std::size_t i = 1; i < poses.size(); ++i)
      EXPECT_LE(std::hypot(poses[i].x - poses[i - 1].x, poses[i].y - poses[i - 1].y), 1 + 1e-9);
    const auto expect_at = [&](const PoseStamped& asked, const PoseStamped& told) {
      EXPECT_NEAR(asked.pose.position.x, told.pose.position.x, 1e-6);
      EXPECT_NEAR(asked.pose.position.y, told.pose.position.y, 1e-6);
      const double same = asked.pose.orientation.w * told.pose.orientation.w +
                          asked.pose.orientation.z * told.pose.orientation.z;
      EXPECT_NEAR(std::abs(same), 1, 1e-9);
    };
    expect_at(start, path.poses.front());
    expect_at(goal, path.poses.back());
  }

  nav2_costmap_2d::Costmap2D costmap_{160, 80, kCell, kLeft, kBottom};
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> ros_ =
      std::make_shared<nav2_costmap_2d::Costmap2DROS>(
          costmap_, std::vector<geometry_msgs::msg::Point>{
                        {-0.1, -0.2, 0}, {0.4, -0.2, 0}, {0.4, 0.2, 0}, {-0.1, 0.2, 0}});
  std::shared_ptr<nav2_core::Node> node_ = std::make_shared<nav2_core::Node>();
  std::unique_ptr<nav2_core::GlobalPlanner> planner_{lasius_nav2_make()};
};

TEST_F(Nav2Planner, PlansRoundAWallInMetresWithYUp) {
  const auto start = pose(-1, 4, 0.5), goal = pose(4.5, 4, -1);
  configure();
  const auto path = plan(start, goal);
  check(path, start, goal);
  double lowest = 9;
  for (const auto& at : path.poses) lowest = std::min(lowest, at.pose.position.y);
  EXPECT_LT(lowest, 2.5);  // by the door
  // The rest of the same way from a pose on it.
  const auto& on = path.poses[path.poses.size() / 2];
  const auto rest = plan(on, goal);
  ASSERT_LE(rest.poses.size(), path.poses.size() / 2 + 2);
  check(rest, on, goal);
  // A wall across it: another.
  for (unsigned int y = 0; y < 12; ++y) costmap_.setCost(80, y, nav2_costmap_2d::LETHAL_OBSTACLE);
  check(plan(start, goal), start, goal);
}

TEST_F(Nav2Planner, CostsLeadAroundWhatIsInflated) {
  // A dear place on the straight way, free beside it.
  for (unsigned int y = 30; y < 50; ++y)
    for (unsigned int x = 110; x < 130; ++x) costmap_.setCost(x, y, 252);
  const auto start = pose(2.6, 3, 0), goal = pose(5.5, 3, 0);
  const auto most_beside = [&](double penalty) {
    planner_.reset(lasius_nav2_make());
    node_ = std::make_shared<nav2_core::Node>();
    set("cost_penalty", penalty);
    configure();
    const auto path = plan(start, goal);
    check(path, start, goal);
    double most = 0;
    for (const auto& at : path.poses) most = std::max(most, std::abs(at.pose.position.y - 3));
    return most;
  };
  EXPECT_NEAR(most_beside(0), 0, 1e-6);
  EXPECT_NEAR(most_beside(0.01), 0, 1e-6);  // around it is farther than that
  EXPECT_GT(most_beside(50), 0.45);
  // The same costs: the same path. Others: what is cheaper then.
  const auto before = plan(start, goal);
  const auto same = plan(start, goal);
  ASSERT_EQ(before.poses.size(), same.poses.size());
  for (std::size_t i = 0; i < before.poses.size(); ++i)
    EXPECT_EQ(before.poses[i].pose.position.y, same.poses[i].pose.position.y);
  for (unsigned int y = 30; y < 50; ++y)
    for (unsigned int x = 110; x < 130; ++x) costmap_.setCost(x, y, 0);
  EXPECT_LT(plan(start, goal).poses.size(), before.poses.size());
}

TEST_F(Nav2Planner, RefusesAPenaltyBelowZero) {
  set("cost_penalty", -1.0);
  EXPECT_THROW(configure(), nav2_core::PlannerException);
}

TEST_F(Nav2Planner, AllMotionModels) {
  for (const char* model : {"REEDS_SHEPP", "DUBIN", "DIFFERENTIAL", "OMNI"}) {
    planner_.reset(lasius_nav2_make());
    node_ = std::make_shared<nav2_core::Node>();
    set("motion_model", std::string(model));
    set("minimum_turning_radius", 0.3);
    configure();
    const auto start = pose(-1, 2, 0), goal = pose(4, 2.5, 0);
    check(plan(start, goal), start, goal);
  }
}

TEST_F(Nav2Planner, SaysWhyThereIsNoPath) {
  set("allow_unknown", false);
  configure();
  const auto good = pose(-1, 2, 0);
  EXPECT_THROW(plan(good, pose(2.1, 4, 0)), nav2_core::GoalOccupied);
  EXPECT_THROW(plan(good, pose(3, 3, 0)), nav2_core::GoalOccupied);  // on what is unknown
  EXPECT_THROW(plan(good, pose(40, 3, 0)), nav2_core::GoalOutsideMapBounds);
  EXPECT_THROW(plan(pose(-40, 3, 0), good), nav2_core::StartOutsideMapBounds);
  auto other = good;
  other.header.frame_id = "odom";
  EXPECT_THROW(plan(other, good), nav2_core::PlannerException);
  EXPECT_THROW(plan(good, pose(4, 4, 0), {}, [] { return true; }), nav2_core::PlannerCancelled);
  for (unsigned int y = 0; y < 30; ++y) costmap_.setCost(80, y, nav2_costmap_2d::LETHAL_OBSTACLE);
  EXPECT_THROW(plan(good, pose(4, 4, 0)), nav2_core::NoValidPathCouldBeFound);
  planner_->deactivate();
  planner_->cleanup();
}

TEST_F(Nav2Planner, TimeEnds) {
  set("max_planning_time", 0.0);
  configure();
  EXPECT_THROW(plan(pose(-1, 4, 0), pose(4, 4, 0)), nav2_core::PlannerTimedOut);
}

TEST_F(Nav2Planner, RefusesUnknownModels) {
  set("motion_model", std::string("HOVERCRAFT"));
  EXPECT_THROW(configure(), nav2_core::PlannerException);
}

#ifdef LASIUS_NAV2_VIAPOINTS
TEST_F(Nav2Planner, GoesThroughViapoints) {
  configure();
  const auto start = pose(-1, 4, 0), goal = pose(1, 4, 0), via = pose(0, 2, 3);
  const auto path = plan(start, goal, {via});
  check(path, start, goal);
  double nearest = 9;
  for (const auto& at : path.poses)
    nearest = std::min(nearest, std::hypot(at.pose.position.x - via.pose.position.x,
                                           at.pose.position.y - via.pose.position.y));
  EXPECT_LT(nearest, 1e-6);
}
#endif

}  // namespace
}  // namespace lasius
