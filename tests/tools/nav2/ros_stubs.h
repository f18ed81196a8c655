// What the plug-in needs of ROS 2 and Nav2, written from their documents for tests alone: names and
// signatures of https://docs.ros.org/en/jazzy/p/nav2_core and, with LASIUS_NAV2_VIAPOINTS, of the
// interface that takes viapoints (navigation2 pull request 5995).
#pragma once

#include <algorithm>
#include <any>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace rclcpp {
struct ParameterValue {
  template <class Value>
  explicit ParameterValue(const Value& given) : value(given) {}
  std::any value;
};
}  // namespace rclcpp

namespace rclcpp_lifecycle {
class LifecycleNode {
 public:
  using WeakPtr = std::weak_ptr<LifecycleNode>;
  bool has_parameter(const std::string& name) const { return parameters_.contains(name); }
  void declare_parameter(const std::string& name, const rclcpp::ParameterValue& value) {
    parameters_.insert({name, value.value});
  }
  template <class Value>
  bool get_parameter(const std::string& name, Value& to) const {
    to = std::any_cast<Value>(parameters_.at(name));
    return true;
  }

 private:
  std::map<std::string, std::any> parameters_;
};
}  // namespace rclcpp_lifecycle

namespace nav2 {
class LifecycleNode : public rclcpp_lifecycle::LifecycleNode {
 public:
  using WeakPtr = std::weak_ptr<LifecycleNode>;
};
}  // namespace nav2

namespace geometry_msgs::msg {
struct Point {
  double x = 0, y = 0, z = 0;
};
struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};
struct PoseStamped {
  struct Header {
    std::string frame_id;
    int stamp = 0;
  } header;
  struct Pose {
    Point position;
    Quaternion orientation;
  } pose;
};
}  // namespace geometry_msgs::msg

namespace nav_msgs::msg {
struct Path {
  geometry_msgs::msg::PoseStamped::Header header;
  std::vector<geometry_msgs::msg::PoseStamped> poses;
};
}  // namespace nav_msgs::msg

namespace tf2_ros {
class Buffer {};
}  // namespace tf2_ros

namespace nav2_costmap_2d {
inline constexpr unsigned char NO_INFORMATION = 255, LETHAL_OBSTACLE = 254;

class Costmap2D {
 public:
  using mutex_t = std::recursive_mutex;
  Costmap2D(unsigned int width, unsigned int height, double resolution, double x, double y)
      : width_(width),
        height_(height),
        resolution_(resolution),
        x_(x),
        y_(y),
        costs_(std::size_t{width} * height) {}
  unsigned int getSizeInCellsX() const { return width_; }
  unsigned int getSizeInCellsY() const { return height_; }
  double getResolution() const { return resolution_; }
  double getOriginX() const { return x_; }
  double getOriginY() const { return y_; }
  unsigned char* getCharMap() { return costs_.data(); }
  void setCost(unsigned int x, unsigned int y, unsigned char cost) {
    costs_[std::size_t{y} * width_ + x] = cost;
  }
  mutex_t* getMutex() { return &mutex_; }

 private:
  unsigned int width_, height_;
  double resolution_, x_, y_;
  std::vector<unsigned char> costs_;
  mutex_t mutex_;
};

class Costmap2DROS {
 public:
  Costmap2DROS(Costmap2D& costmap, std::vector<geometry_msgs::msg::Point> footprint)
      : costmap_(costmap), footprint_(std::move(footprint)) {}
  Costmap2D* getCostmap() { return &costmap_; }
  std::string getGlobalFrameID() const { return "map"; }
  std::vector<geometry_msgs::msg::Point> getRobotFootprint() const { return footprint_; }

 private:
  Costmap2D& costmap_;
  std::vector<geometry_msgs::msg::Point> footprint_;
};
}  // namespace nav2_costmap_2d

namespace nav2_core {
class PlannerException : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
struct StartOccupied : PlannerException {
  using PlannerException::PlannerException;
};
struct GoalOccupied : PlannerException {
  using PlannerException::PlannerException;
};
struct StartOutsideMapBounds : PlannerException {
  using PlannerException::PlannerException;
};
struct GoalOutsideMapBounds : PlannerException {
  using PlannerException::PlannerException;
};
struct NoValidPathCouldBeFound : PlannerException {
  using PlannerException::PlannerException;
};
struct PlannerTimedOut : PlannerException {
  using PlannerException::PlannerException;
};
struct PlannerCancelled : PlannerException {
  using PlannerException::PlannerException;
};

#ifdef LASIUS_NAV2_VIAPOINTS
using Node = nav2::LifecycleNode;
#else
using Node = rclcpp_lifecycle::LifecycleNode;
#endif

class GlobalPlanner {
 public:
  virtual ~GlobalPlanner() = default;
  virtual void configure(const Node::WeakPtr& parent, std::string name,
                         std::shared_ptr<tf2_ros::Buffer> tf,
                         std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) = 0;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;
  virtual nav_msgs::msg::Path createPlan(
      const geometry_msgs::msg::PoseStamped& start, const geometry_msgs::msg::PoseStamped& goal,
#ifdef LASIUS_NAV2_VIAPOINTS
      const std::vector<geometry_msgs::msg::PoseStamped>& viapoints,
#endif
      std::function<bool()> cancel_checker) = 0;
};
}  // namespace nav2_core

/// What pluginlib's library finds.
#define PLUGINLIB_EXPORT_CLASS(Class, Base) \
  extern "C" Base* lasius_nav2_make();      \
  extern "C" Base* lasius_nav2_make() { return new Class; }
