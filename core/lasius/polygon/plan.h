// Planning among polygons: MAKLINK lines, the algorithms on their crossing points, exact optima.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/base/enum_names.h"
#include "lasius/base/stop.h"
#include "lasius/params/params.h"
#include "lasius/plan/batch_options.h"
#include "lasius/plan/progress.h"
#include "lasius/plan/search_result.h"
#include "lasius/polygon/world.h"

namespace lasius {
struct TourRequest;  // see tour.h
struct TourResult;
}  // namespace lasius

namespace lasius::polygon {

/// How obstacles grow at their corners.
enum class Join {
  mitre,   ///< the margin is kept; corners reach up to 5 margins out, and may close passages
  round,   ///< the margin is kept, and exceeded by less than 0.5% of it, at corners alone
  bevel,   ///< corners are cut off: paths come nearer there
  chords,  ///< what `round` was up to version 0.1: at corners 99.5% of the margin is kept
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 4> kJoinNames{"mitre", "round", "bevel", "chords"};
/// The name of a value.
constexpr std::string_view to_string(Join v) noexcept { return name_of(v, kJoinNames); }

/// What the margin does to the boundary.
enum class Boundary {
  shrink,  ///< the robot keeps the margin to it, as to obstacles
  keep,    ///< paths may run along it
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kBoundaryNames{"shrink", "keep"};
/// The name of a value.
constexpr std::string_view to_string(Boundary v) noexcept { return name_of(v, kBoundaryNames); }

/// How a world grows by the robot's margin.
struct GrowOptions {
  static constexpr double kMostMargin = 1e12;  ///< largest margin, in the world's unit
  std::optional<double> margin = {};           ///< in place of the world's own, 0 to kMostMargin
  Join join = Join::round;                     ///< at corners, the boundary's too if it shrinks
  Boundary boundary = Boundary::shrink;        ///< whether the boundary keeps the margin, too
};

/// Which best path the global update of `maklink-acs` deposits on.
enum class GlobalBest {
  so_far,     ///< of the run
  iteration,  ///< of the iteration that just ended
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kGlobalBestNames{"so-far", "iteration"};
/// The name of a value.
constexpr std::string_view to_string(GlobalBest v) noexcept { return name_of(v, kGlobalBestNames); }

/// Parameters of one plan. The constructor sets the published values of an algorithm, which
/// `algorithms()` lists with its parameters and their ranges; what the algorithm does not read must
/// stay as the constructor left it.
struct LASIUS_POLYGON_EXPORT Params {
  /// Those of `exact`.
  Params() : Params("exact") {}
  /// @throws Error(invalid_parameter) for an unknown name, with the nearest known one.
  explicit Params(std::string_view algorithm);
  /// Its name. To ask another algorithm, make other Params.
  const std::string& algorithm() const noexcept { return algorithm_; }

  std::uint64_t seed = 1;  ///< at most 2^53 - 1
  int threads = 0;         ///< at most 1024; no effect, planning takes one: for the record alone

  int ants = 10;  ///< m
  /// Stands for a number that grows with `values`.
  static constexpr int kUsualIterations = -1;
  int iterations = kUsualIterations;  ///< NC, or generations; see iterations_of
  /// How many points of a line a path may cross it at. They lie at h = 0, 1 / (values - 1), .., 1:
  /// h is the share of the way from the line's end a to its end b, as in Crossing::values.
  int values = 21;
  /// Exponent of visibility (1.1 - |h - h*|) / 1.1; h* is where the best path so far crosses the
  /// line, at first Dijkstra's path.
  double beta = 2;
  double greedy = 0.5;       ///< q0
  double persistence = 0.9;  ///< of both updates: 1 - rho
  /// tau0; 0: 1 / (d L) with d lines and L of Dijkstra's path, the formula of ACS (Dorigo &
  /// Gambardella 1997), which is 0.00022 on the source's world. Its own 0.0002 ties the balance of
  /// old and new paths to the unit of length.
  double initial_pheromone = 0;
  GlobalBest global_best = GlobalBest::so_far;  ///< which path the global update deposits on
  /// The run ends after so many iterations in a row in which all ants went the same way; 0: never.
  /// The source ends at the first; but ants that take the largest weight in 85% of choices agree by
  /// chance, long before the 175 iterations that it takes itself.
  int agreement = 10;
  /// Line sequences that are searched, the shortest first; the source: 1, as the genetic algorithm.
  int routes = 5;

  int population = 50;     ///< chromosomes
  double crossover = 0.6;  ///< probability that two parents cross
  double mutation = 0.05;  ///< probability, by gene, that it is drawn anew
  double blend = 0.3;      ///< share of the other parent in a child that was crossed

 private:
  std::string algorithm_;
};

/// All algorithms among polygons, the default first; valid for ever.
LASIUS_POLYGON_EXPORT std::span<const Algorithm> algorithms() noexcept;
/// One of them. @throws Error(invalid_parameter) for an unknown name, with the nearest.
LASIUS_POLYGON_EXPORT const Algorithm& find_algorithm(std::string_view name);
/// Sets a parameter by its name, from text.
/// @throws Error(invalid_parameter) for an unknown name (with the nearest), value or range.
LASIUS_POLYGON_EXPORT void set_parameter(Params& parameters, std::string_view name,
                                         std::string_view value);
/// The value as text, which set_parameter reads. @throws Error(invalid_parameter) for an unknown
/// name, with the nearest.
LASIUS_POLYGON_EXPORT std::string get_parameter(const Params& parameters, std::string_view name);
/// The rules of a colony in a line each, see lasius::formulas(); empty for others.
LASIUS_POLYGON_EXPORT std::vector<std::string> formulas(const Params& parameters);
/// Checks every field.
/// @throws Error(invalid_parameter) for the first field that is out of range, or was changed
/// although the algorithm does not read it.
LASIUS_POLYGON_EXPORT void validate(const Params& parameters);

/// The iterations in force: 200 with up to 11 values, and in proportion more with more of them;
/// 1000 of the genetic algorithm. What was set is left.
LASIUS_POLYGON_EXPORT int iterations_of(const Params& parameters);

/// A free MAKLINK line, and the two convex regions of free space that it parts.
struct Line {
  Point a;        ///< one end
  Point b;        ///< the other end
  int left = 0;   ///< region on the left of the way from a to b, by number
  int right = 0;  ///< region on its right
  /// Half way from a to b.
  Point midpoint() const noexcept { return {a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y)}; }
};

/// The MAKLINK graph of a world: free space cut into convex regions by free lines.
struct Maklink {
  std::vector<Line> lines;                     ///< free ones, each between two regions
  std::vector<std::vector<Point>> regions;     ///< convex, counter-clockwise
  std::vector<std::vector<int>> region_lines;  ///< lines on the border of each region
  std::vector<Polygon> free_space;             ///< what was cut up, see Planner::free_space
};

/// What is asked of the planner.
struct Request {
  std::optional<Point> start = {};  ///< in place of the world's
  std::optional<Point> goal = {};   ///< in place of the world's
  StopCondition stop = {};          ///< deadline and token of the plan
  double target_gap = 0;  ///< stop at this gap to the exact optimum, as a fraction; 0: never
  /// Where the goal cannot be reached, the path ends at the point nearest to it that can be, at
  /// most so far from it; 0 or more.
  double goal_tolerance = 0;
};

/// A way across lines, and the crossing point on each: a + h (b - a).
struct Crossing {
  std::vector<int> lines;      ///< numbers in Maklink::lines, in the order they are crossed
  std::vector<double> values;  ///< h of each line: 0 at its end a, 1 at b
  std::vector<Point> path;     ///< start, crossing points, goal
  double length = 0;           ///< of the path, in the world's unit
};

/// One answer, lengths in the world's unit. `lower_bound` is the exact optimum of the whole world,
/// so every path has its true gap. The crossings are empty or missing for `exact`.
struct Result : SearchResult {
  std::vector<Point> path;            ///< one point where start and goal are the same; or empty
  std::optional<Point> goal_reached;  ///< with a goal tolerance: where the path ends
  std::optional<Point> nearest_free;  ///< to a start or goal that is blocked or outside
  /// The same among the points that are joined to the other end, where that is free; with a goal
  /// tolerance also of a goal in another piece of free space.
  std::optional<Point> nearest_reachable;
  Crossing crossing;                 ///< of the ants' or the genetic algorithm's best path
  std::optional<Crossing> dijkstra;  ///< through midpoints; none for `exact`
  /// Of the same lines and values, by dynamic programming; none where the run was stopped first.
  std::optional<Crossing> discrete_optimum;
  std::optional<Crossing> sequence_optimum;  ///< of the same lines, any crossing points (funnel)
  std::optional<double> optimum;             ///< length of the shortest path, where it was found
  std::chrono::nanoseconds optimum_time{};   ///< what that took beside the algorithm itself
  /// What mitre joins do to the answer, where they close what round ones leave open; or empty.
  std::string note;
};

/// What an observer sees of a plan among polygons.
struct PlanProgress : Progress {
  /// The best path so far, made when it is asked for; holds until the observer returns.
  std::function<std::vector<Point>()> path;
};
/// Called on the thread that called `plan`.
using Observer = Callback<const PlanProgress&>;

/// A world made ready: obstacles grown, clipped and merged, the MAKLINK graph made. Immutable: use
/// one from many threads.
///
/// A path may touch obstacles and slide along their edges; it may not pass between two that touch.
/// Coordinates are put on a grid of 2^-42 of the world's size, but no finer than 16 roundings of
/// the largest coordinate of the boundary: in it every decision (sides, sight, convexity) is made
/// in integers, without rounding. What is within 8 of these roundings of an edge or a corner
/// touches it. Where the obstacles or the margin leave no free space, no start or goal is free.
class LASIUS_POLYGON_EXPORT Planner {
 public:
  /// @throws Error(invalid_parameter) for a world that `check` refuses, a margin that is not a
  ///         number of at least 0, or where GEOS cannot work with it.
  explicit Planner(const World& world, const GrowOptions& options = {});
  /// As the constructor, for those who may have to stop: empty if stopped while lines were drawn.
  /// Growing and merging the obstacles, GEOS's part, is not cut short.
  [[nodiscard]] static std::optional<Planner> make(const World& world, const GrowOptions& options,
                                                   const StopCondition& stop);
  ~Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  /// What it was made of; valid as long as the planner, as all references that it returns.
  const World& world() const noexcept;
  /// The margin in force, in the world's unit.
  double margin() const noexcept;
  /// How obstacles were grown at their corners.
  Join join() const noexcept;
  /// What the margin did to the boundary.
  Boundary boundary() const noexcept;
  /// The graph; without obstacles one region and no lines.
  const Maklink& maklink() const noexcept;
  /// What the margin leaves of the boundary's inside. For round joins the graph is drawn in a
  /// little less, so that it has few lines: there corners reach up to twice the margin out, but for
  /// those that would come near to others. Paths go straight on to a start or goal that lies
  /// between.
  const std::vector<Polygon>& free_space() const noexcept;
  /// Pieces of free space that are not joined.
  int components() const noexcept;
  /// Obstacles as grown and merged, clipped to the boundary.
  const std::vector<Polygon>& grown_obstacles() const noexcept;

  /// Is it in free space, its edges included? False of what is no number.
  bool free(Point p) const;
  /// The point of free space nearest to `p`, if there is one.
  std::optional<Point> nearest_free(Point p) const;

  /// Answers one request. Deterministic in (world, request, parameters) and the version of GEOS;
  /// a deadline or token may change the answer. An unreachable goal is proven first.
  /// @throws Error(invalid_parameter) for parameters that validate() refuses, a target gap out of
  /// range, without start or goal, or where their coordinates are not finite; what the observer
  /// throws. Start or goal outside or blocked is an answer: Status::invalid.
  Result plan(const Request& request = {}, const Params& parameters = {},
              const Observer& observer = {}) const;

  class Impl;

 private:
  friend struct PlannerParts;  // internal
  explicit Planner(std::unique_ptr<const Impl> impl);
  std::unique_ptr<const Impl> impl_;
};

using BatchAnswer = BatchAnswerOf<Result>;      ///< one answer of a batch
using BatchReceiver = BatchReceiverOf<Result>;  ///< called with each

/// Answers `requests` with `parameters`, several at a time, each, save for time limits, as
/// `planner.plan` does with the answer's seed. Order, threads, stops, what is thrown on and what is
/// returned are those of lasius::plan_batch; a start or goal that is outside or blocked is an
/// answer, Status::invalid.
/// @throws Error(invalid_parameter) for parameters that validate() refuses, options or a target gap
///         out of range, for a request without start or goal where the world names none, for
///         coordinates of either that are not finite, and for an empty receiver, before anything is
///         planned.
LASIUS_POLYGON_EXPORT std::size_t plan_batch(const Planner& planner,
                                             std::span<const Request> requests,
                                             const Params& parameters, const BatchOptions& options,
                                             const BatchReceiver& receive);

/// The same, all answers at the end, in that order; fewer when stopped.
LASIUS_POLYGON_EXPORT std::vector<BatchAnswer> plan_batch(const Planner& planner,
                                                          std::span<const Request> requests,
                                                          const Params& parameters = {},
                                                          const BatchOptions& options = {});

/// Plans a tour as lasius::plan_tour does, of at most 2000 stops, given as points in the world's
/// unit: legs are shortest paths of `exact`. Once all of them are priced, deadlines count. Include
/// lasius/tour/tour.h.
/// @throws Error(invalid_parameter) as that, and for coordinates that are not finite.
LASIUS_POLYGON_EXPORT TourResult
plan_tour(const Planner& planner, const TourRequest& request,
          const Callback<std::span<const int>, double>& observer = {});

}  // namespace lasius::polygon
