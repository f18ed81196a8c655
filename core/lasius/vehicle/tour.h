// Tours of a vehicle: many poses in a short order, by legs that are certified plans.
#pragma once

#include <optional>
#include <vector>

#include "lasius/export.h"
#include "lasius/tour/tour.h"
#include "lasius/vehicle/planner.h"

namespace lasius::vehicle {

constexpr int kTourHeadings = 8;  ///< of a stop without a yaw: 0, and every 45 degrees

/// What is asked; fields that are not told of here are as those of tours on maps.
struct TourRequest : lasius::TourRequest {
  /// To each stop the yaw that the vehicle comes with and leaves with, radians; none: that of
  /// kTourHeadings for which the tour is shortest; empty: none of any stop. Start, goal and the
  /// stops where robots begin have one.
  std::vector<std::optional<double>> yaws = {};
};

/// What is answered. Lengths (over costs the costs) are of the legs' plans, which are not the
/// shortest ways; the bound is over all ways of the vehicle, at stops without a yaw of those with
/// the headings that are free. `optimal` where it meets the length.
struct TourResult : lasius::TourResult {
  std::vector<Pose> poses;    ///< at each stop of `order`, the same on arrival and departure
  std::vector<Result> plans;  ///< to each of `legs`; a leg's path has points each half a cell
};

/// Plans a tour. A leg is priced, by the plan that `planner` has between two poses, when an order
/// takes it; till then it costs its lower bound. Up to 12 stops (fewer of several headings: 5e8
/// steps) the order is one of least length over the plans of all pairs, though few are made; above,
/// it is searched, anew each time that legs are priced, till ten searches find none that is
/// shorter. Stops are left out where the vehicle does not fit, the disc inside its footprint cannot
/// get there from the others (proven), or plans find no way there or away, at any heading; a group
/// where that holds of all its stops, and the bound is over all but those that cannot be (proven).
/// A deadline ends the search for orders, but legs are planned, and orders looked for that have no
/// dead ones, till there is a tour; a token ends it with the best tour so far, which may be none.
/// An observer is told tours whose legs are planned.
/// @throws Error(invalid_parameter) as plan_tour of a map, for an order given in part or ants, for
/// more than 2000 poses at all stops, for an end without a yaw, and for a closed tour with a goal
LASIUS_EXPORT TourResult plan_tour(const Planner& planner, const TourRequest& request,
                                   const TourObserver& observer = {});

}  // namespace lasius::vehicle
