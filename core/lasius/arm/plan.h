// The planner for arms: two trees of certified motions, or an ant colony in the lattice of tip
// positions around the start. Both learn of obstacles only by asking a sensor.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/arm/sensor.h"
#include "lasius/arm/trajectory.h"
#include "lasius/base/enum_names.h"
#include "lasius/base/stop.h"
#include "lasius/params/params.h"
#include "lasius/plan/progress.h"
#include "lasius/plan/search_result.h"

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
constexpr std::string_view to_string(Pheromone v) noexcept { return name_of(v, kPheromoneNames); }

/// What a way through the lattice is measured by.
enum class Objective {
  length,  ///< moves times pitch, metres: the source's L
  joint,   ///< joint travel: how long the way is in joint space, radians and metres alike
  /// Seconds that a way takes at the joints' largest velocities, straight from point to point: less
  /// than a motion along it, which speeds up and slows down, and is told by Result::duration.
  duration,
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 3> kObjectiveNames{"length", "joint", "duration"};
/// The name of a value.
constexpr std::string_view to_string(Objective v) noexcept { return name_of(v, kObjectiveNames); }

/// Parameters of one plan. The constructor sets the values of an algorithm, which `algorithms()`
/// lists: `postures`, the default, or `goritov2020`, the source's system and base set (Goritov &
/// Goncharov 2020). Both read all of them; `postures` is other values: it tries the straight line,
/// then two trees (Params::trees) in place of the lattice.
struct LASIUS_ARM_EXPORT Params {
  /// Those of `postures`.
  Params() : Params("postures") {}
  /// @throws Error(invalid_parameter) for an unknown name, with the nearest known one.
  explicit Params(std::string_view algorithm);
  /// Its name. To ask another algorithm, make other Params.
  const std::string& algorithm() const noexcept { return algorithm_; }

  std::uint64_t seed = 1;  ///< at most 2^53 - 1
  int threads = 0;         ///< at most 1024; 0: as many as OpenMP gives; never changes the answer

  // As given here, those of the source's base set.
  int ants = 64;         ///< m
  int iterations = 100;  ///< T
  // Random proportional rule: weight of a move = tau^alpha eta^beta u^gamma, with eta = pitch /
  // weight of the edge and u = 1 / (1 + theta), theta the angle between the move and the way to the
  // goal.
  double alpha = 1;           ///< exponent of pheromone
  double beta = 1;            ///< of eta: without effect, a move is drawn as if all weighed a pitch
  double gamma = 0.25;        ///< exponent of the direction to the goal
  double persistence = 0.75;  ///< share of pheromone that remains: 1 - rho
  double elite_weight = 0;    ///< e: weight of the iteration's best tour
  /// tau0, at least 1e-12; 0: ants / Manhattan distance from start to goal. Of both algorithms
  /// 0.01: the source's is "a small positive number", the same for any number of ants.
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

  // What the source has not.
  bool direct = false;  ///< first try the straight joint-space line to each posture of the goals
  /// Then two trees of straight motions grow from the start and the goals, by so many joint values
  /// at most, 0 .. 10^9, and no lattice is searched; 0: none.
  int trees = 0;
  Objective objective = Objective::length;  ///< what is optimised
  /// Questions that may be asked, the motion's included; 0: any number. Otherwise one thread walks.
  int max_questions = 0;
  int shortcuts = 0;  ///< random shortcuts of the motion: TrajectoryOptions::shortcuts
  Timing timing = Timing::splines;  ///< of the motion: TrajectoryOptions::timing

 private:
  std::string algorithm_;
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
/// Why a run does not read a parameter, as "it is read only with trees=0"; empty where it does.
/// @throws as get_parameter.
LASIUS_ARM_EXPORT std::string why_unread(const Params& parameters, std::string_view name);
/// The rules of a colony in a line each, see lasius::formulas(); empty for others.
LASIUS_ARM_EXPORT std::vector<std::string> formulas(const Params& parameters);
/// Checks every field.
/// @throws Error(invalid_parameter) for the first field out of range.
LASIUS_ARM_EXPORT void validate(const Params& parameters);

/// What the arm is to reach: a position of the tip, a pose of it, or joint values.
struct LASIUS_ARM_EXPORT Goal {
  /// What it says.
  enum class Kind { position, pose, joints };
  static constexpr double kTolerance = 1e-7;  ///< metres and radians, unless said otherwise

  /// The tip at `position`, its orientation free.
  Goal(const Eigen::Vector3d& position);
  /// The same.
  static Goal position(const Eigen::Vector3d& position) { return {position}; }
  /// The tip's frame at `pose`, within tolerances of at least kTolerance: metres, and radians of
  /// the turn between the two frames (pi or more: any orientation).
  static Goal pose(const Pose& pose, double position_tolerance = kTolerance,
                   double angle_tolerance = kTolerance);
  /// A value for each joint; one that turns freely may get there by any number of turns.
  static Goal joints(const JointRef& q);

  Kind kind = Kind::position;              ///< which of the following counts
  Pose target = Pose::Identity();          ///< of the tip, in the world
  double position_tolerance = kTolerance;  ///< metres
  double angle_tolerance = kTolerance;     ///< radians
  JointVector values;                      ///< of the joints
};

/// Their names.
inline constexpr std::array<std::string_view, 3> kGoalKindNames{"position", "pose", "joints"};
/// The name of a value.
constexpr std::string_view to_string(Goal::Kind v) noexcept { return name_of(v, kGoalKindNames); }

/// What is asked of the planner.
struct Request {
  JointVector start;        ///< a value for each joint
  std::vector<Goal> goals;  ///< any one of them is to be reached; at least one
  StopCondition stop = {};  ///< of the search and the motion together
  double target_gap = 0;  ///< stop at this gap to what was learned so far, as a fraction; 0: never
  bool motion = true;     ///< make the motion, too; if not, the answer is waypoints
  double duration = 0;    ///< TrajectoryOptions::duration, the source's T

  /// Values of the start and of joint goals that are outside of a joint's limits by no more are
  /// taken at the limit, which Result::notes tells: radians or metres.
  static constexpr double kLimitTolerance = 1e-3;
};

/// Questions that the sensor was asked: by the search each once, then by the making of the motion.
struct Questions {
  std::int64_t positions = 0;   ///< by the search
  std::int64_t motions = 0;     ///< by the search
  std::int64_t trajectory = 0;  ///< motions, by make_trajectory
  friend bool operator==(const Questions&, const Questions&) = default;
};

/// One answer; `length` is in the unit of the objective: metres of lattice moves, radians (or
/// metres) of the joints, seconds at full speed (no motion's: see Objective). Without a path
/// `joints` and `tips` have no columns, and the trajectory is empty. Where the search is solved,
/// `status` is that of the motion.
struct Result : SearchResult {
  Eigen::MatrixXd joints;          ///< q^(0) .. q^(p), a column for each lattice point of the path
  Eigen::Matrix3Xd tips;           ///< where the tip is then, likewise
  Trajectory trajectory;           ///< the motion along `joints`; empty where none was asked for
  int waypoints = 0;               ///< of the motion, left after shortcutting
  bool stops = false;              ///< the motion rests at each waypoint: see TrajectoryResult
  int goal = -1;                   ///< which of the request's was reached, from 0; -1: none
  bool direct = false;             ///< the straight joint-space line was free
  bool trees = false;              ///< two trees met
  double tip_travel = 0;           ///< of the motion (without one, of `joints`), metres
  double joint_travel = 0;         ///< likewise, how long the way is in joint space
  double duration = 0;             ///< of the motion, seconds
  double pitch = 0;                ///< as used, of the lattice
  std::array<int, 3> points{};     ///< of the lattice, by axis
  Questions questions;             ///< that the sensor was asked
  std::vector<Questions> asked;    ///< the same so far, after each iteration
  std::int64_t steps = 0;          ///< of all ants, those taken back included
  std::vector<std::string> notes;  ///< what of the request was changed, for people
};

/// What an observer sees after each iteration.
struct ArmProgress : Progress {
  Questions questions;  ///< so far
  /// Joint values of the best way so far, a column for each lattice point, the start first; none
  /// without one. Made when they are asked for; holds until the observer returns.
  std::function<Eigen::MatrixXd()> joints;
};
/// Called on the thread that called `plan`.
using Observer = Callback<const ArmProgress&>;

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
///         out of range, a lattice that is too large, or (for a motion) a duration that is none or
///         a sensor's clearance below its least; what the sensor or the observer throws. A bad
///         start, or goals all of which are proven out of reach or blocked, are an answer:
///         Status::invalid. That no way was found is Status::no_path, with `error`
///         saying what to change.
LASIUS_ARM_EXPORT Result plan(const Robot& robot, const Sensor& sensor, const Request& request,
                              const Params& parameters = {}, const Observer& observer = {});

/// The shortest way in the same lattice when everything is known: A*, which asks the sensor about
/// whatever it needs. A measure for `plan`, not a planner for unknown worlds: neither the straight
/// joint-space line nor trees are tried. Status::solved with `length`, `lower_bound` and
/// `questions`, Status::no_path, or as `plan`; no joints, no tips, no motion.
LASIUS_ARM_EXPORT Result shortest_lattice_way(const Robot& robot, const Sensor& sensor,
                                              const Request& request,
                                              const Params& parameters = {});

/// The way of the tip that keeps nearest to the straight line: Status::solved with its `length`
/// where it is open, Status::no_path where something is in the way, or as `plan`. Likewise a
/// measure: of how hard a request is.
LASIUS_ARM_EXPORT Result straight_lattice_way(const Robot& robot, const Sensor& sensor,
                                              const Request& request,
                                              const Params& parameters = {});

/// Joint values within the limits that reach the goal, those nearest to `near` first, no two alike:
/// at most `most`, of what inverse kinematics makes of `near` and of 64 values drawn at random.
/// None where none was found, which is no proof; what is in the way is not looked at. Told to stop
/// it returns those found so far.
/// @throws Error(invalid_parameter) for a robot that `validate` refuses, values that are not within
///         its limits, and a goal that is proven out of its reach or has no such values.
LASIUS_ARM_EXPORT std::vector<JointVector> inverse_kinematics(const Robot& robot, const Goal& goal,
                                                              const JointVector& near, int most = 8,
                                                              std::uint64_t seed = 1,
                                                              const StopCondition& stop = {});

/// The robot holding something: a link more, that moves with the last joint. The solids are placed
/// in the tip's frame. It may touch the links named, and those that move with the last joint.
/// @throws Error(invalid_parameter) for a name that is no link's, and what `validate` refuses.
LASIUS_ARM_EXPORT Robot holding(Robot robot, const std::string& name, std::vector<Solid> solids,
                                const std::vector<std::string>& may_touch = {});

/// How near to a straight line the tip is to keep, and how far a joint may go between waypoints.
struct TipLineOptions {
  double tolerance = 1e-3;        ///< metres that the tip may be off the line, 1e-6 or more
  double angle_tolerance = 0.01;  ///< radians, 1e-6 or more; pi or more: turned as it likes
  double joint_step = 0.3;        ///< of any joint, radians or metres, 0.001 or more
  StopCondition stop = {};        ///< polled before each waypoint
  /// Make the motion in time, too; its corners are rounded, all of it within the tolerances, of
  /// which waypoints then leave half.
  bool motion = false;
  double duration = 0;  ///< of it: TrajectoryOptions::duration
};

/// A motion of the tip along a line, as far as it goes: `joints` are waypoints, the start first,
/// and the status says `solved` where they go all along (with a motion: how that ended), else why
/// they end before; of those that do, no travel is told. Then `length` is that of the line, `goal`
/// 0, and the trajectory is there where a motion was asked for.
struct TipLine : Result {
  double reached = 0;  ///< share of the line, 0 .. 1
};

/// Straight with the tip from where it is to `goal`, turning evenly about one axis. Between two
/// waypoints, which are on the line, joints go straight: the tip's way is within the tolerance of
/// it by a bound of its acceleration, its frame turned off by no more than the other one (proofs in
/// docs/theory.md), and the sensor calls the motion free. Joint values are continued from waypoint
/// to waypoint, so a line through a singular posture or past a joint's limit ends there: status
/// no_path. A start that is not free, and a goal proven out of reach: invalid.
/// @throws Error(invalid_parameter) for a robot that `validate` refuses, a start outside of its
///         limits, a goal that is no pose, and options out of range; what the sensor throws.
LASIUS_ARM_EXPORT TipLine tip_line(const Robot& robot, const Sensor& sensor,
                                   const JointVector& start, const Pose& goal,
                                   const TipLineOptions& options = {});

}  // namespace lasius::arm
