// Lengths of shortest paths from places to others near to them.
#pragma once

#include <functional>
#include <span>

#include "lasius/plan/planner.h"

namespace lasius {

/// Told the lengths from one place to all, in cells: infinite where they are not known, which is
/// only of what is at least `beyond` long. From several threads at once.
using TakeLengths = std::function<void(int place, std::span<const double> lengths, double beyond)>;

/// Of each place the lengths to at least `nearest[place]` of the others, those that are nearest, by
/// searches of a prepared map that go no farther; 0: none. All places are free, and joined to each
/// other. False if stopped, or where the map is not prepared for a point.
bool lengths_near(const Planner& planner, std::span<const Point> places,
                  std::span<const int> nearest, int threads, const StopCondition& stop,
                  const TakeLengths& take);

}  // namespace lasius
