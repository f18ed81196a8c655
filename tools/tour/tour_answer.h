// A tour, with all that is told of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lasius/tour/tour.h"
#include "tools/bitmap/map_file.h"

namespace lasius::tool {

struct TourAnswer {
  LoadedMap map;
  std::vector<Place> stops;
  std::vector<std::string> names;  ///< of those of the file, where it has some
  std::optional<int> start, goal;  ///< indices of stops
  std::vector<int> robots;         ///< likewise, where each of several begins
  TourResult tour;
  Result ends;  ///< of a tour whose start or goal is invalid: what a plan says of them
  double elapsed_ms = 0;
};

/// What a plan from an invalid end of a tour to itself says, of that end. Of a disc's it may speak
/// of the goal, as there may be a way out of the start's place. Tours have no goal tolerance.
inline Result of_tour(Result said, bool start) {
  const bool outside = said.fault == Fault::start_outside || said.fault == Fault::goal_outside;
  said.fault = start ? (outside ? Fault::start_outside : Fault::start_blocked)
                     : (outside ? Fault::goal_outside : Fault::goal_blocked);
  said.nearest_reachable.reset();
  return said;
}

}  // namespace lasius::tool
