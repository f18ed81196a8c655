// Random grids for tests, the same on every machine.
#pragma once

#include <random>

#include "lasius/grid.h"

namespace lasius {

/// Each cell blocked with probability `percent` / 100.
inline Grid random_grid(int width, int height, int percent, std::mt19937& random) {
  Grid grid(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (static_cast<int>(random() % 100) < percent) grid.set_blocked({x, y});
    }
  }
  return grid;
}

/// A number of [lo, hi].
inline int random_in(int lo, int hi, std::mt19937& random) {
  return lo + static_cast<int>(random() % static_cast<unsigned>(hi - lo + 1));
}

/// A grid drawn from text: '#' is blocked.
inline Grid drawn(std::initializer_list<const char*> rows) {
  int width = 0;
  while ((*rows.begin())[width] != '\0') ++width;
  Grid grid(width, static_cast<int>(rows.size()));
  int y = 0;
  for (const char* row : rows) {
    for (int x = 0; x < width; ++x) grid.set_blocked({x, y}, row[x] == '#');
    ++y;
  }
  return grid;
}

}  // namespace lasius
