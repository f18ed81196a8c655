// Paths through centres of cells, for tests.
#pragma once

#include <span>
#include <vector>

#include "lasius/grid/geometry.h"

namespace lasius {

inline std::vector<Point> centres(std::span<const Cell> cells) {
  std::vector<Point> path;
  for (const Cell c : cells) path.push_back(centre(c));
  return path;
}

}  // namespace lasius
