// One tile of a Field. Included by field*.cpp only.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "field.h"
#include "kernels/walk.h"

namespace lasius {

struct Field::Tile {
  using Bits = std::array<std::uint32_t, kernels::kTileSide>;

  int index = 0;
  int x0 = 0, y0 = 0;  // cell (0, 0) of the tile
  Bits changed;        // cells changed since the last refresh
  Bits touched;        // cells changed since the reset
  bool any_changed = false;
  bool any_touched = false;
  std::vector<float> storage;  // the arrays below, all row-major by cell
  float* rows = nullptr;       // 64-byte aligned, see kernels::WalkWorld::tiles
  float* heuristic = nullptr;  // B of each move
  float* tau = nullptr;        // stored tau, one a cell or one a move
  float* eta = nullptr;        // with Heuristic::learned
};

}  // namespace lasius
