// Which of the stops a tour can visit.
#pragma once

#include <span>
#include <vector>

#include "lasius/tour.h"

namespace lasius {

/// The stops that a tour can visit, by their index in the request; names the others in `tour`, but
/// for those whose task can be done elsewhere.
std::vector<int> visited(const Planner& planner, const TourRequest& request,
                         std::span<const Point> points, TourResult& tour);

/// Places of the regions that a free point is of: a point where cells meet may be of two, which no
/// path joins there; then the centres of these cells stand for it.
std::vector<Point> anchors_of(const Planner& planner, Point p);

/// Where robots begin and end, by their index.
std::vector<int> ends_of(const TourRequest& request);

}  // namespace lasius
