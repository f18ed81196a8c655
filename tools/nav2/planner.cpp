#include "tools/nav2/planner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <nav2_core/planner_exceptions.hpp>
#include <nav2_costmap_2d/cost_values.hpp>
#include <pluginlib/class_list_macros.hpp>
#include <utility>

#include "lasius/base/error.h"
#include "lasius/vehicle/motion.h"
#include "lasius/vehicle/stop_when.h"

namespace lasius::nav2 {
namespace {

template <class Node, class Value>
void read(Node& node, const std::string& name, Value& value) {
  if (!node.has_parameter(name)) node.declare_parameter(name, rclcpp::ParameterValue(value));
  node.get_parameter(name, value);
}

[[noreturn]] void refuse(const vehicle::Way& way) {
  switch (way.fault) {
    case Fault::start_blocked:
      throw nav2_core::StartOccupied(way.error);
    case Fault::start_outside:
      throw nav2_core::StartOutsideMapBounds(way.error);
    case Fault::goal_blocked:
      throw nav2_core::GoalOccupied(way.error);
    case Fault::goal_outside:
      throw nav2_core::GoalOutsideMapBounds(way.error);
    default:
      break;
  }
  if (way.status == Status::interrupted) throw nav2_core::PlannerCancelled(way.error);
  if (way.status == Status::limit) throw nav2_core::PlannerTimedOut(way.error);
  throw nav2_core::NoValidPathCouldBeFound(way.error);
}

}  // namespace

void Planner::configure(std::tuple_element_t<0, Configured> parent, std::string name,
                        std::tuple_element_t<2, Configured>,
                        std::tuple_element_t<3, Configured> costmap) {
  const auto node = parent.lock();
  if (!node) throw nav2_core::PlannerException("the node has gone");
  name_ = std::move(name);
  costmap_ = costmap;
  Parameters& to = parameters_;
  const auto of = [&](const char* parameter) { return name_ + "." + parameter; };
  read(*node, of("motion_model"), to.motion_model);
  read(*node, of("minimum_turning_radius"), to.minimum_turning_radius);
  read(*node, of("reverse_penalty"), to.reverse_penalty);
  read(*node, of("change_penalty"), to.change_penalty);
  read(*node, of("cost_penalty"), to.cost_penalty);
  read(*node, of("tolerance"), to.tolerance);
  read(*node, of("angle_tolerance"), to.angle_tolerance);
  read(*node, of("max_planning_time"), to.max_planning_time);
  read(*node, of("allow_unknown"), to.allow_unknown);
  read(*node, of("smooth_path"), to.smooth_path);
  if (!(to.cost_penalty >= 0 && to.cost_penalty <= 1e4))
    throw nav2_core::PlannerException(of("cost_penalty") + " is " +
                                      std::to_string(to.cost_penalty) + ": give 0 to 10000");
  const auto& models = {"REEDS_SHEPP", "DUBIN", "DIFFERENTIAL", "OMNI"};
  if (std::find(models.begin(), models.end(), to.motion_model) == models.end())
    throw nav2_core::PlannerException(of("motion_model") + " is \"" + to.motion_model +
                                      "\": give REEDS_SHEPP, DUBIN, DIFFERENTIAL or OMNI");
}

void Planner::cleanup() {
  navigator_.reset();
  costmap_.reset();
}
void Planner::activate() {}
void Planner::deactivate() {}

/// In cells, whose y points down.
vehicle::Vehicle Planner::vehicle() const {
  std::vector<Point> footprint;
  for (const auto& corner : costmap_->getRobotFootprint())
    footprint.push_back({corner.x / resolution_, -corner.y / resolution_});
  const std::string& model = parameters_.motion_model;
  if (model == "OMNI") return vehicle::omni(std::move(footprint));
  if (model == "DIFFERENTIAL") return vehicle::differential(std::move(footprint));
  vehicle::Vehicle car =
      vehicle::car(std::move(footprint), parameters_.minimum_turning_radius / resolution_);
  car.reverse = model == "REEDS_SHEPP";
  car.reverse_cost = parameters_.reverse_penalty;
  car.cusp_cost = parameters_.change_penalty / resolution_;
  return car;
}

/// Takes the costmap over: of the same place what has changed alone.
void Planner::look() {
  nav2_costmap_2d::Costmap2D& costmap = *costmap_->getCostmap();
  const std::unique_lock<nav2_costmap_2d::Costmap2D::mutex_t> lock(*costmap.getMutex());
  const int width = static_cast<int>(costmap.getSizeInCellsX());
  const int height = static_cast<int>(costmap.getSizeInCellsY());
  const bool moved = resolution_ != costmap.getResolution() || left_ != costmap.getOriginX() ||
                     bottom_ != costmap.getOriginY();
  resolution_ = costmap.getResolution();
  left_ = costmap.getOriginX();
  bottom_ = costmap.getOriginY();
  const vehicle::Vehicle vehicle = this->vehicle();
  const bool keep = navigator_ && !moved && vehicle == planned_for_ &&
                    navigator_->map().width() == width && navigator_->map().height() == height;
  Grid grid(width, height);
  std::vector<Cell> now_free, now_blocked;
  std::vector<double> weights(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const unsigned char* costs = costmap.getCharMap();
  for (int row = height - 1; row >= 0; --row) {  // its rows go up
    for (int x = 0; x < width; ++x) {
      const unsigned char cost = *costs++;
      const bool blocked = cost == nav2_costmap_2d::LETHAL_OBSTACLE ||
                           (cost == nav2_costmap_2d::NO_INFORMATION && !parameters_.allow_unknown);
      const Cell cell{x, row};
      constexpr double kDearest = 252;  // where the robot does not touch for certain
      const double value = cost == nav2_costmap_2d::NO_INFORMATION ? 0 : cost / kDearest;
      weights[static_cast<std::size_t>(row) * width + x] =
          1 + parameters_.cost_penalty * std::min(value, 1.0);
      if (!keep && blocked) grid.set_blocked(cell);
      if (keep && blocked != navigator_->map().blocked(cell))
        (blocked ? now_blocked : now_free).push_back(cell);
    }
  }
  if (keep) {
    navigator_->observe(now_free, false);
    navigator_->observe(now_blocked, true);
    return take(std::move(weights));
  }
  // The costmap forgets what it was told by its own rules.
  navigator_.emplace(std::move(grid), vehicle, std::vector<vehicle::Pose>{{}},
                     vehicle::NavigatorOptions{
                         .goal_tolerance = parameters_.tolerance / resolution_,
                         .heading_tolerance = parameters_.angle_tolerance,
                         .smooth = parameters_.smooth_path,
                         .doubt_after = 0,
                     });
  planned_for_ = vehicle;
  weights_.clear();
  take(std::move(weights));
}

/// Costs as they are now, where they have changed: to be told of them costs a plan.
void Planner::take(std::vector<double> weights) {
  if (parameters_.cost_penalty == 0 || weights == weights_) return;
  navigator_->set_costs({navigator_->map().width(), navigator_->map().height(), weights});
  weights_ = std::move(weights);
}

vehicle::Pose Planner::cells_of(const PoseStamped& pose) const {
  if (pose.header.frame_id != costmap_->getGlobalFrameID())
    throw nav2_core::PlannerException("a pose is in the frame \"" + pose.header.frame_id +
                                      "\", the costmap in \"" + costmap_->getGlobalFrameID() +
                                      "\"");
  const auto& q = pose.pose.orientation;
  const double yaw = std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
  return {(pose.pose.position.x - left_) / resolution_,
          navigator_->map().height() - (pose.pose.position.y - bottom_) / resolution_, -yaw};
}

geometry_msgs::msg::PoseStamped Planner::pose_of(const vehicle::Pose& cells) const {
  PoseStamped pose;
  pose.header.frame_id = costmap_->getGlobalFrameID();
  pose.pose.position.x = left_ + cells.x * resolution_;
  pose.pose.position.y = bottom_ + (navigator_->map().height() - cells.y) * resolution_;
  pose.pose.orientation.w = std::cos(cells.yaw / 2);
  pose.pose.orientation.z = -std::sin(cells.yaw / 2);
  return pose;
}

nav_msgs::msg::Path Planner::createPlan(const PoseStamped& start, const PoseStamped& goal,
                                        std::function<bool()> cancel) {
  return createPlan(start, goal, {}, std::move(cancel));
}

nav_msgs::msg::Path Planner::createPlan(const PoseStamped& start, const PoseStamped& goal,
                                        const std::vector<PoseStamped>& viapoints,
                                        std::function<bool()> cancel) {
  const vehicle::StopWhen cancelled(std::move(cancel));
  const StopCondition stop =
      cancelled.within(std::chrono::duration<double>(parameters_.max_planning_time));
  nav_msgs::msg::Path path;
  path.header = start.header;
  try {
    look();
    std::vector<vehicle::Pose> targets;
    for (const PoseStamped& via : viapoints) targets.push_back(cells_of(via));
    targets.push_back(cells_of(goal));
    vehicle::Pose from = cells_of(start);
    for (const vehicle::Pose& target : targets) {
      const bool same = viapoints.empty() && navigator_->goals().front() == target;
      if (!same) navigator_->set_goals({target});
      const vehicle::Way& way = navigator_->step(from, stop);
      if (way.segments.empty()) refuse(way);
      for (const vehicle::PathPose& at : vehicle::poses(way.segments, 1)) {
        path.poses.push_back(pose_of(at.pose));
        path.poses.back().header.stamp = start.header.stamp;
      }
      from = way.segments.back().end();
    }
  } catch (const Error& error) {
    throw nav2_core::PlannerException(error.what());
  }
  return path;
}

}  // namespace lasius::nav2

PLUGINLIB_EXPORT_CLASS(lasius::nav2::Planner, nav2_core::GlobalPlanner)
