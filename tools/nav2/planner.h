// lasius as a planner of Nav2: certified motions of the costmap's footprint.
#pragma once

#include <functional>
#include <memory>
#include <nav2_core/global_planner.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "lasius/vehicle/navigator.h"

namespace lasius::nav2 {

/// The arguments of a member function.
template <class>
struct ArgumentsOf;
template <class Class, class... Arguments>
struct ArgumentsOf<void (Class::*)(Arguments...)> {
  using Type = std::tuple<Arguments...>;
};

/// What does not change from a plan to the next; all of it are parameters of the plug-in, by these
/// names. Lengths in metres.
struct Parameters {
  std::string motion_model = "REEDS_SHEPP";  ///< or DUBIN, DIFFERENTIAL, OMNI
  double minimum_turning_radius = 0.4;       ///< of the first two
  double reverse_penalty = 2.0;              ///< at least 1: what a length backwards counts
  double change_penalty = 0.0;               ///< a length: what a change of gear counts
  double cost_penalty = 2.0;                 ///< what the dearest cell counts more; 0: lethal only
  double tolerance = 0.0;                    ///< the path may end so far from the goal
  double angle_tolerance = 0.0;              ///< radians, likewise
  double max_planning_time = 5.0;            ///< seconds
  bool allow_unknown = true;                 ///< cells of no information are free
  bool smooth_path = true;
};

/// A plug-in of planner_server. It compiles against the interface with and without viapoints: both
/// functions are there, and what the base has is overridden, so none is marked.
class Planner : public nav2_core::GlobalPlanner {
  using Configured = ArgumentsOf<decltype(&nav2_core::GlobalPlanner::configure)>::Type;
  using PoseStamped = geometry_msgs::msg::PoseStamped;

 public:
  void configure(std::tuple_element_t<0, Configured> parent, std::string name,
                 std::tuple_element_t<2, Configured> tf,
                 std::tuple_element_t<3, Configured> costmap);
  void cleanup();
  void activate();
  void deactivate();

  /// Poses a cell apart; where the gear changes one stands twice. The way that was planned last is
  /// kept where it leads to the same goal, and its rest holds from the start on.
  /// @throws nav2_core's exceptions of planners
  nav_msgs::msg::Path createPlan(const PoseStamped& start, const PoseStamped& goal,
                                 std::function<bool()> cancel);
  /// The same through some poses.
  nav_msgs::msg::Path createPlan(const PoseStamped& start, const PoseStamped& goal,
                                 const std::vector<PoseStamped>& viapoints,
                                 std::function<bool()> cancel);

 private:
  vehicle::Vehicle vehicle() const;
  void look();
  void take(std::vector<double> weights);
  vehicle::Pose cells_of(const PoseStamped& pose) const;
  PoseStamped pose_of(const vehicle::Pose& cells) const;

  std::string name_;
  Parameters parameters_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
  std::optional<vehicle::Navigator> navigator_;
  vehicle::Vehicle planned_for_;  ///< by it
  std::vector<double> weights_;   ///< over these
  double resolution_ = 1, left_ = 0, bottom_ = 0;
};

}  // namespace lasius::nav2
