// Which of the stops a tour can visit.
#pragma once

#include <span>
#include <vector>

#include "lasius/tour/tour.h"

namespace lasius {

/// Where stops are, as a world tells it.
struct StopPlaces {
  std::vector<std::vector<int>> regions;  ///< of each; none of one that is outside or blocked
  std::vector<char> outside;
  StopCondition::Cause cause = StopCondition::Cause::none;  ///< why the rest is not known
};
/// Stopped only among thousands of regions.
StopPlaces places_of(const Planner& planner, std::span<const Point> points,
                     const StopCondition& stop);
StopPlaces places_of(const TourWorld& world, std::span<const Point> points);

/// The stops that a tour can visit, by their index in the request; names the others in `tour`, but
/// for those whose task can be done elsewhere.
std::vector<int> visited(const StopPlaces& places, const TourRequest& request, TourResult& tour);

/// Makes what is said of a stop say it of its group, of which no stop can be visited.
void tell_of_group(LeftOut& out, int group);

/// Places of the regions that a free point is of: a point where cells meet may be of two, which no
/// path joins there; then the centres of these cells stand for it.
std::vector<Point> anchors_of(const Planner& planner, Point p);

/// Where robots begin and end, by their index.
std::vector<int> ends_of(const TourRequest& request);

}  // namespace lasius
