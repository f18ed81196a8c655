// A map and stops that tests of tours share.
#pragma once

#include <vector>

#include "lasius/grid/grid.h"
#include "lasius/tour/tour.h"

namespace lasius {

// Rooms behind doors, so that legs are longer than straight lines.
inline Grid rooms() {
  Grid grid(60, 40);
  for (int y = 0; y < 40; ++y)
    if (y != 20) grid.set_blocked({30, y});
  for (int x = 0; x < 60; ++x)
    if (x != 10 && x != 50) grid.set_blocked({x, 12});
  return grid;
}

inline std::vector<Cell> some_stops(const Grid& grid, int count) {
  std::vector<Cell> stops;
  for (unsigned word = 1; static_cast<int>(stops.size()) < count;) {
    word = word * 1664525u + 1013904223u;
    const Cell c{static_cast<int>((word >> 8) % 60), static_cast<int>((word >> 16) % 40)};
    if (grid.free(c)) stops.push_back(c);
  }
  return stops;
}

inline TourRequest ask(std::vector<Cell> stops) {
  TourRequest request;
  request.stops = std::move(stops);
  return request;
}

}  // namespace lasius
