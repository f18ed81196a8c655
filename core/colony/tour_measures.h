// What a tour on a bitmap measures: its length, and its cells near the straight line.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/special_values.h"
#include "core/cost/path_cost.h"
#include "core/cost/terrain.h"
#include "core/grid/move_rule.h"
#include "kernels/base/moves.h"
#include "lasius/grid/geometry.h"
#include "lasius/path/path.h"

namespace lasius {

using MoveCounts = std::array<std::int64_t, kernels::kMaxMoves>;

/// Length of a tour. Moves are counted by kind, so that the sum does not depend on their order.
inline double length_of(MoveCounts count, const kernels::Moves& moves) {
  // Moves of one length, met first to last, make one product.
  double length = 0;
  for (int k = 0; k < moves.count; ++k) {
    std::int64_t alike = 0;
    for (int j = moves.count - 1; j >= k; --j) {
      if (moves[j].length != moves[k].length) continue;
      alike += count[j];
      count[j] = 0;
    }
    length += static_cast<double>(alike) * moves[k].length;
  }
  return length;
}

inline double length_of(std::span<const std::uint8_t> tour, const kernels::Moves& moves) {
  MoveCounts count{};
  for (const int k : tour) ++count[k];
  return length_of(count, moves);
}

/// What tours and paths are compared by: their length, or over a terrain what they cost.
class TourMeasure {
 public:
  TourMeasure() = default;
  /// `terrain`: null for lengths; both outlive the object.
  TourMeasure(const kernels::Moves& moves, const cost::Terrain* terrain)
      : moves_(&moves), terrain_(terrain) {}

  const cost::Terrain* terrain() const noexcept { return terrain_; }
  /// What so long a way costs at least.
  double least(double length) const noexcept {
    return terrain_ != nullptr ? terrain_->least() * length : length;
  }
  /// Of a tour from `start`.
  double of(std::span<const std::uint8_t> tour, Cell start) const {
    return terrain_ != nullptr ? cost_of(tour, start) : length_of(tour, *moves_);
  }
  /// The same of a tour whose moves are counted.
  double of(std::span<const std::uint8_t> tour, Cell start, const MoveCounts& count) const {
    return terrain_ != nullptr ? cost_of(tour, start) : length_of(count, *moves_);
  }
  /// Of a polyline; infinite where none may go over the terrain.
  double of(std::span<const Point> path) const {
    return terrain_ == nullptr ? path_length(path) : cost::cost_of(*terrain_, path);
  }

 private:
  double cost_of(std::span<const std::uint8_t> tour, Cell c) const {
    const auto weight = [&](int x, int y) { return terrain_->weight(x, y); };
    cost::PathCost sum(weight);
    for (const int k : tour) {
      const Cell next = c + (*moves_)[k].to;
      if (!sum.add(centre(c), centre(next))) return kInfinity;
      c = next;
    }
    return sum.sum();
  }

  const kernels::Moves* moves_ = nullptr;
  const cost::Terrain* terrain_ = nullptr;
};

/// The band within a tenth of the distance from start to goal of the straight line between them.
class Band {
 public:
  Band() = default;
  Band(Cell start, Cell goal, const kernels::Moves& moves) {
    const std::int64_t dx = goal.x - start.x, dy = goal.y - start.y;
    most_ = dx * dx + dy * dy;
    for (int k = 0; k < moves.count; ++k)
      aside_[k] = 10 * (moves[k].to.dx * dy - moves[k].to.dy * dx);
  }
  /// Cells of a tour from the start that lie within; counts its moves by kind, too.
  std::int64_t count(std::span<const std::uint8_t> tour, MoveCounts& count) const {
    std::int64_t off = 0, near = 1;
    for (const int k : tour) {
      ++count[k];
      off += aside_[k];
      near += off <= most_ && -off <= most_;
    }
    return near;
  }

 private:
  std::int64_t most_ = 0;
  std::array<std::int64_t, kernels::kMaxMoves> aside_{};  // ten times, by move
};

}  // namespace lasius
