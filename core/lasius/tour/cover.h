// Coverage: swaths over the free space of a map, in a short order, joined by shortest paths.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/plan/planner.h"
#include "lasius/tour/tour.h"

namespace lasius {

/// What is asked. What the tool works on is all within `width` / 2 of its centre; its body is the
/// planner's robot, whose centre keeps its radius.
struct CoverRequest {
  double width = 0;                 ///< cells, more than 0, at most the map's longer side
  bool open = false;                ///< no way back to where it began
  std::optional<Point> start = {};  ///< where the tour begins; none: at any end of a swath
  std::uint64_t seed = 1;           ///< of the search for the order
  int generations = 20;             ///< as TourRequest::generations, of more than 6 swaths
  int threads = 0;                  ///< never changes the tour
  /// As TourRequest::stop. Out of time or by the token, directions that were not tried yet are not;
  /// where the map has more than 1.5 million cells the token leaves no tour before the first was.
  StopCondition stop = {};
};

/// What is answered. The stops of the tour are the ends of swaths: 2 i and 2 i + 1 those of swath
/// i, which are neighbours in the order; where there is a start, it is the last of them. Each
/// swath is a straight leg, the other legs are shortest paths. `tour.lower_bound` is of all tours
/// over these swaths, not of other swaths.
struct CoverResult {
  TourResult tour;           ///< over the ends of swaths
  std::vector<Point> stops;  ///< these ends; none lies outside of the map
  /// From +x towards +y, degrees from 0 to below 180: what most swaths are parallel to; those that
  /// cover what is left over may be across.
  double angle = 0;
  double swept = 0;  ///< length of all swaths, cells
  /// Cells from one sample of area to the next; shares are of samples. With a radius, places of the
  /// tool that lie between samples count as none.
  double resolution = 0;
  /// Of the free area: that which the tool does not come to from the start (without one: from the
  /// largest region), because it is walled off or nearer to obstacles than it gets. 0 to 1.
  double unreachable = 0;
  double covered = 0;  ///< of the free area that the tool can come to, within width / 2 of the tour
  double overlap = 0;  ///< of what swaths cover, what two or more do
  /// How many swaths there are.
  int swaths() const noexcept { return static_cast<int>(stops.size()) / 2; }
};

/// Plans a tour that covers a map. Lines `width` apart or less are laid over the free space in
/// eight directions (multiples of 45 degrees, and the diagonals of two cells), in each of them once
/// over the whole map, once fitted into the cells of its boustrophedon decomposition (Choset &
/// Pignol 1998); what they leave is covered by pieces of lines along and across it where these
/// are worth their length, swaths are cut where others cover all that they do, and the plan of
/// least estimated length is taken. Its swaths are brought in order as the stops of a tour are, two
/// ends a swath. At most 10 000 swaths: plans of more are passed over, and out of time before one
/// of fewer there is no tour (Status::limit). Status::invalid where the start is outside or
/// blocked, or no free place is wide enough; no_path where none is found from one swath to the
/// next.
/// @throws Error(invalid_parameter) for a width out of range or that asks for too many swaths in
/// every direction, more than 100 000 lines across the longer side or 200 million samples of area,
/// generations below 0, and as Planner::plan for a robot's radius.
LASIUS_EXPORT CoverResult plan_cover(const Planner& planner, const CoverRequest& request,
                                     const TourObserver& observer = {});

}  // namespace lasius
