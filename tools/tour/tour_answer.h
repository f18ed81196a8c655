// A tour, with all that is told of it.
#pragma once

#include <optional>
#include <vector>

#include "lasius/tour.h"
#include "tools/bitmap/map_file.h"

namespace lasius::tool {

struct TourAnswer {
  LoadedMap map;
  std::vector<Place> stops;
  std::optional<int> start, goal;  ///< indices of stops
  std::vector<int> robots;         ///< likewise, where each of several begins
  TourResult tour;
  Result ends;  ///< of a tour whose start or goal is invalid: what a plan says of them
  double elapsed_ms = 0;
};

}  // namespace lasius::tool
