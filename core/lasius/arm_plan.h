// The planner `goritov2020`: an ant colony in the lattice of tip positions around the start, which
// learns of obstacles only by trying positions.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/arm_sensor.h"
#include "lasius/arm_trajectory.h"
#include "lasius/enum_names.h"
#include "lasius/params.h"
#include "lasius/progress.h"
#include "lasius/search_result.h"
#include "lasius/stop.h"

namespace lasius::arm {

/// What carries pheromone. The source's set of edges holds ordered pairs of points, its words speak
/// of edges.
enum class Pheromone {
  arcs,   ///< each direction of an edge has its own
  edges,  ///< both directions share it: ants are drawn back as much as on, and take far longer
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kPheromoneNames{"arcs", "edges"};
/// The name of a value.
constexpr std::string_view to_string(Pheromone value) noexcept {
  return name_of(value, kPheromoneNames);
}

/// Parameters of `goritov2020`, as given here those of its base set (Goritov & Goncharov 2020).
struct Params {
  /// The only algorithm there is.
  static constexpr std::string_view algorithm() noexcept { return "goritov2020"; }

  std::uint64_t seed = 1;  ///< at most 2^53 - 1
  int threads = 0;         ///< at most 1024; 0: as many as OpenMP gives; never changes the answer

  int ants = 64;         ///< m
  int iterations = 100;  ///< T
  // Random proportional rule: weight of a move = tau^alpha eta^beta u^gamma, with eta = 1 / weight
  // of the edge and u = 1 / (1 + theta), theta the angle between the move and the way to the goal.
  double alpha = 1;           ///< exponent of pheromone
  double beta = 1;            ///< without effect: all edges that exist weigh the same
  double gamma = 0.25;        ///< exponent of the direction to the goal
  double evaporation = 0.25;  ///< rho: share of pheromone lost in an iteration
  double elite_weight = 0;    ///< e: weight of the iteration's best tour
  /// tau0, at least 1e-12; 0: ants / Manhattan distance from start to goal.
  double initial_pheromone = 0;
  Pheromone pheromone = Pheromone::arcs;  ///< what carries it
  DeadEnd dead_end = DeadEnd::backtrack;  ///< what an ant does when every move is closed

  double pitch = 0;         ///< d, metres; 0: a twentieth of the arm's reach
  int side = 0;             ///< lattice points a side, about the middle of start and goal; 0: all
                            ///< that the arm can reach
  double joint_step = 0.5;  ///< an edge is closed where a joint moves further, radians or metres
  int patience = 0;         ///< stop after so many iterations without a shorter path; 0: never
  double line_ants = 0;     ///< ants whose deposits lie on the straight way before the first
  bool shortcut = true;     ///< leave out waypoints before the motion: TrajectoryOptions::shortcut
};

/// All parameters by name, with ranges, as `lasius algorithms` lists them; valid for ever.
LASIUS_ARM_EXPORT std::span<const Algorithm> algorithms() noexcept;
/// One of them. @throws Error(invalid_parameter) for an unknown name, with the nearest.
LASIUS_ARM_EXPORT const Algorithm& find_algorithm(std::string_view name);
/// Sets a parameter by its name, from text.
/// @throws Error(invalid_parameter) for an unknown name (with the nearest), value or range.
LASIUS_ARM_EXPORT void set_parameter(Params& parameters, std::string_view name,
                                     std::string_view value);
/// The value as text, which set_parameter reads. @throws Error(invalid_parameter) for an unknown
/// name, with the nearest.
LASIUS_ARM_EXPORT std::string get_parameter(const Params& parameters, std::string_view name);
/// Checks every field.
/// @throws Error(invalid_parameter) for the first field out of range.
LASIUS_ARM_EXPORT void validate(const Params& parameters);

/// One question.
struct Request {
  JointVector start;                               ///< a value for each joint
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();  ///< of the tip, its orientation is free
  StopCondition stop = {};                         ///< of the search and the motion together
  double target_gap = 0;  ///< stop at this gap to what was learned so far, as a fraction; 0: never
  bool motion = true;     ///< make the motion, too; if not, the answer is waypoints
};

/// Questions that the sensor was asked: by the search each once, then by the making of the motion.
struct Questions {
  std::int64_t positions = 0;   ///< by the search
  std::int64_t motions = 0;     ///< by the search
  std::int64_t trajectory = 0;  ///< motions, by make_trajectory
  friend bool operator==(const Questions&, const Questions&) = default;
};

/// One answer; `length` is moves times pitch, the source's L, in metres. Without a path `joints`
/// and `tips` have no columns, and the trajectory is empty. Where the search is solved, `status` is
/// that of the motion.
struct Result : SearchResult {
  Eigen::MatrixXd joints;       ///< q^(0) .. q^(p), a column for each lattice point of the path
  Eigen::Matrix3Xd tips;        ///< where the tip is then, likewise
  Trajectory trajectory;        ///< the motion along `joints`; empty where none was asked for
  int waypoints = 0;            ///< of the motion, left after shortcutting
  bool stops = false;           ///< the motion rests at each waypoint: see TrajectoryResult
  double pitch = 0;             ///< as used
  std::array<int, 3> points{};  ///< of the lattice, by axis
  Questions questions;          ///< that the sensor was asked
  std::int64_t steps = 0;       ///< of all ants, those taken back included
};

/// What an observer sees after each iteration.
class ArmProgress : public Progress {
 public:
  Questions questions;  ///< so far
};
/// Called on the thread that called `plan`.
using Observer = std::function<void(const ArmProgress&)>;

/// Searches for a short way of the tip from where the arm stands to the goal, and makes a motion of
/// it: make_trajectory along the waypoints, with the request's stop condition and
/// Params::shortcut.
///
/// The lattice (D.1): points start + d v, v in Z^3, edges between points at Manhattan distance 1.
/// The goal's nearest point is moved onto the goal, by at most d / 2 along each axis. The joint
/// values of a point are found by kinematics from those of the neighbour towards the start, along
/// the axis with the largest |v_i| (or the next largest, where that one has none): a function of v
/// alone. An edge is closed where an end has none, a joint would move further than `joint_step`, or
/// the sensor says so.
///
/// An ant draws among the neighbours that it has not visited, and tries what it drew: if the way is
/// closed it draws again among the rest. That is the source's rule, and makes a walk depend on the
/// world alone, not on what others have learned: so the answer is the same for any number of
/// threads. At a dead end an ant steps back, the point stays visited.
///
/// Robot, sensor and request are read during the call only; several plans may be made at a time.
/// @throws Error(invalid_parameter) for a robot that `validate` refuses, parameters or a target gap
///         out of range, a lattice that is too large, or (for a motion) a sensor's clearance below
///         its least; what the sensor or the observer throws. A bad start or goal is an answer:
///         Status::invalid.
LASIUS_ARM_EXPORT Result plan(const Robot& robot, const Sensor& sensor, const Request& request,
                              const Params& parameters = {}, const Observer& observer = {});

/// The shortest way in the same lattice when everything is known: A*, which asks the sensor about
/// whatever it needs. A measure for `plan`, not a planner for unknown worlds. Status::solved with
/// `length`, `lower_bound` and `questions`, Status::unreachable, or as `plan`; no joints, no tips,
/// no motion.
LASIUS_ARM_EXPORT Result shortest_lattice_way(const Robot& robot, const Sensor& sensor,
                                              const Request& request,
                                              const Params& parameters = {});

/// The way of the tip that keeps nearest to the straight line: Status::solved with its `length`
/// where it is open, Status::no_path where something is in the way, or as `plan`. Likewise a
/// measure: of how hard a question is.
LASIUS_ARM_EXPORT Result straight_lattice_way(const Robot& robot, const Sensor& sensor,
                                              const Request& request,
                                              const Params& parameters = {});

}  // namespace lasius::arm
