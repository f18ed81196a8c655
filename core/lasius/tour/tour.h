// Tours: many stops on a map, in a cheap order, with a bound that no order is below.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lasius/base/status.h"
#include "lasius/base/stop.h"
#include "lasius/cost/planner.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/plan/planner.h"
#include "lasius/plan/search_result.h"
#include "lasius/tour/ants.h"
#include "lasius/tour/tsplib.h"
#include "lasius/tour/world.h"

namespace lasius {

/// What is asked.
struct TourRequest {
  std::vector<Cell> stops;  ///< each to be visited once, at its centre
  /// Stops as points of the map, on free cells or their borders; then `stops` are not looked at.
  std::vector<Point> points = {};
  bool open = false;              ///< no way back to the first stop
  std::optional<int> start = {};  ///< index of the first stop; none: any
  std::optional<int> goal = {};   ///< of the last one, of an open tour; none: any
  /// What is given of the order: to each stop those that come before it; or empty.
  std::vector<std::vector<int>> after = {};
  std::vector<int> load = {};  ///< that each stop adds to what is carried, or takes off; or empty
  /// At no stop is more carried, from 0 before the first one; none: any load. It may fall below 0.
  std::optional<std::int64_t> capacity = {};
  /// To each stop the task that is done there, a number from 0, or -1: one of its own; or empty:
  /// all have their own. Of a task one stop is visited.
  std::vector<int> group = {};
  /// Stops where robots begin, one a robot, in place of `start`: the sum of their tours is to be
  /// short, and one may stay where it is. None: one robot, `tours` stays empty.
  std::vector<int> robots = {};
  int most_stops = 0;      ///< that a robot visits, its start aside; 0: any
  std::uint64_t seed = 1;  ///< of the search for the order
  /// Of the tours that recombine, of more than 12 stops; 0: local search and its kicks alone. Where
  /// the order is given in part: each 1000 steps, and 10 a stop, unless there is a deadline.
  int generations = 20;
  /// Who finds the order: `exact` the search that is told of here, others a colony, in place of all
  /// of it, also of few stops; at most 2000, whose legs are all priced first. Where the order is
  /// given in part, ants step to stops that it allows alone, and of local search make exchanges of
  /// pieces.
  tour::AntParams ants = {};
  double target_gap = 0;  ///< a tour with this gap ends the search; 0: as short as it can
  int threads = 0;        ///< that legs are planned on; never changes the tour
  /// Ends the search with the best order so far, whose legs are planned all the same; without any
  /// where the token asks before the search began, or time is up among thousands of regions. Three
  /// fifths of the time to a deadline are for the order (four where it is given in part), the rest
  /// for the bound.
  StopCondition stop = {};
};

/// One leg of a tour.
struct TourLeg {
  int from = 0;             ///< stop
  int to = 0;               ///< stop
  double length = 0;        ///< cells, the shortest
  std::vector<Point> path;  ///< as Result::path
  double cost = 0;          ///< over costs
};

/// A stop that no tour visits, and why, in a sentence.
struct LeftOut {
  int stop = 0;     ///< its index
  std::string why;  ///< in a sentence
  int group = -1;   ///< a task whose stops are all left out; `stop` is the first of them
};

/// What one of several robots does.
struct RobotTour {
  int start = 0;           ///< stop
  std::vector<int> order;  ///< stops, the start first
  int first_leg = 0;       ///< among all legs
  int legs = 0;            ///< that follow from there; none: it stays
  double length = 0;       ///< sum of the legs', cells
  double cost = 0;         ///< over costs
};

/// What is answered.
struct TourResult {
  Status status = Status::no_path;  ///< as Result::status
  std::string error;                ///< where there is no tour, but for a stop; else empty
  /// Stops; of a closed tour the first is not told again; of several robots one after another.
  std::vector<int> order;
  std::vector<TourLeg> legs;          ///< in that order, of closed tours with the way back
  std::vector<RobotTour> tours;       ///< of several robots, by the request's
  double length = 0;                  ///< sum of the legs', cells
  std::optional<double> cost = {};    ///< over costs, the sum of the legs'; then the bound is of it
  std::optional<double> lower_bound;  ///< no tour over these stops is shorter
  /// (length - lower_bound) / lower_bound, over costs of the cost; 0 at 0.
  std::optional<double> gap() const;
  /// Proven shortest, up to the rounding of sums: up to 12 stops, and where the gap is 0.
  bool optimal = false;
  std::vector<LeftOut> left_out;  ///< by rising stop
  Convergence curves = {};        ///< of ants, in cells: a path is a tour
  std::int64_t priced = 0;        ///< legs planned to find the order and the bound
};

/// Told each better order, and its length as known by then. Go::stop ends the search: the result is
/// `interrupted`, with the best order so far.
using TourObserver = Callback<std::span<const int>, double>;

/// Plans a tour. Up to 12 stops the order is a shortest; above, it is searched (tours of the same
/// request and seed are the same, unless stopped). Stops that are outside, blocked or not joined to
/// the others are left out: the tour is over the stops that are joined to the start or goal, else
/// over the region that has most stops. Legs are priced when they are asked for, those to near
/// stops before; what is kept of them stays below 110 MB; up to 100 stops (500 of groups and
/// robots), and on prepared maps where it is quick, all are priced at once. A planner for a point
/// that is not prepared is prepared for 30 stops and more, in the memory that PrepareOptions allow.
/// Of stops that are left out, what comes behind them still comes behind what is before them. Of a
/// task with several stops those that cannot be visited are left out in silence, as long as there
/// is another. With tasks of several stops or robots at most 2000 stops; up to 12 tasks (and 5e8
/// steps) the answer is a shortest one, where all are priced at once. Where no order keeps what is
/// given the tour is unreachable (proven), or no_path (none was found).
/// @throws Error(invalid_parameter) for start or goal that are no stops or the same one, for stops
/// that come before themselves, where a number is out of range, and where groups or robots are
/// asked for together with an order given in part or ants, several robots with a start or goal.
LASIUS_EXPORT TourResult plan_tour(const Planner& planner, const TourRequest& request,
                                   const TourObserver& observer = {});

/// The same over costs, of at most 200 stops: legs are cheapest paths, each within 0.2% of its
/// bound (or half the target gap), the order is of least cost, and bound and gap are of the cost,
/// what is open of the legs included. All legs are priced at once, on all threads, in at most 0.7
/// of the time to a deadline; the order is a shortest of those that are priced. An observer is told
/// costs.
LASIUS_EXPORT TourResult plan_tour(const CostPlanner& planner, const TourRequest& request,
                                   const TourObserver& observer = {});

/// The same in any world, of at most 2000 stops, given as points: all legs are priced first, which
/// no deadline cuts short.
LASIUS_EXPORT TourResult plan_tour(const TourWorld& world, const TourRequest& request,
                                   const TourObserver& observer = {});

/// The same of a problem of TSPLIB: lengths are by its rounding, `request.stops` is not read, the
/// result has no legs. One of sequential ordering is open, from its first place to its last, and
/// has its own order alone; a bound is told where the tour is proven. It has no groups and no
/// robots.
LASIUS_EXPORT TourResult plan_tour(const Tsplib& problem, const TourRequest& request,
                                   const TourObserver& observer = {});

}  // namespace lasius
