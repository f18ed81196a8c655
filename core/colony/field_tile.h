// One tile of a Field. Included by field*.cpp only.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/base/parallel.h"
#include "core/colony/field.h"
#include "kernels/walk/walk.h"

namespace lasius {

struct Field::Tile {
  using Bits = std::array<std::uint32_t, kernels::kTileSide>;

  int index = 0;
  int x0 = 0, y0 = 0;  // cell (0, 0) of the tile
  Bits changed;        // cells changed since the last refresh
  Bits touched;        // cells changed since the reset
  bool any_changed = false;
  bool any_touched = false;
  std::unique_ptr<float[]> storage;  // the arrays below, all row-major by cell
  std::size_t room = 0;              // of it, in floats
  float* rows = nullptr;             // 64-byte aligned, see kernels::WalkWorld::tiles
  float* heuristic = nullptr;        // B of each move
  float* tau = nullptr;              // stored tau, one a cell or one a move
  float* eta = nullptr;              // with Heuristic::learned
};

template <class Action>
void Field::for_all_tiles(int threads, const StopCondition& stop, const Action& action) {
  constexpr int kManyTiles = 64;  // fewer are not worth waking threads for
  constexpr int kTilesAPoll = 4;
  const int tiles = static_cast<int>(used_.size());
  std::atomic<bool> stopped{false};
  parallel_for(tiles, tiles > kManyTiles ? threads : 1, [&](int i, int) {
    if (stopped) return;
    if (i % kTilesAPoll == 0 && stop.poll() != StopCondition::Cause::none) {
      stopped = true;
    } else {
      action(*used_[i]);
    }
  });
}

}  // namespace lasius
