// The best tour of a colony on a bitmap, which may move on with its start or be blocked.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/special_values.h"
#include "core/colony/field.h"
#include "core/colony/tour_measures.h"
#include "core/colony/update.h"
#include "core/grid/cell_distance.h"
#include "core/grid/move_rule.h"

namespace lasius {

/// The shortest tour so far, as moves from the start, or none. Its memory is kept.
class BestTour {
 public:
  bool none() const noexcept { return moves_.empty(); }
  std::span<const std::uint8_t> moves() const noexcept { return moves_; }
  double length() const noexcept { return length_; }  ///< infinite without one
  Tour tour() const noexcept { return {moves_, none() ? kNaN : length_}; }
  std::int64_t bytes() const noexcept { return held_bytes(moves_); }

  void drop() noexcept {
    moves_.clear();
    length_ = kInfinity;
  }
  /// Takes the shortest of these tours where it is shorter, ties to the first.
  void offer(std::span<const Tour> tours) {
    const Tour* best = nullptr;
    for (const Tour& tour : tours) {
      if (!(tour.length < length_)) continue;
      best = &tour;
      length_ = tour.length;
    }
    if (best != nullptr) moves_.assign(best->moves.begin(), best->moves.end());
  }
  /// The start moves: what is left of the tour from there, or none where it does not pass.
  void go_on_from(Cell start, Cell to, const kernels::Moves& moves, const TourMeasure& measure) {
    auto passed = moves_.begin();
    while (passed != moves_.end() && start != to) start = start + moves[*passed++].to;
    moves_.erase(moves_.begin(), passed);
    if (none()) return drop();
    length_ = measure.of(moves_, to);
  }
  /// Could a way through free cells of `part` be shorter?
  bool passed_by(const Grid& grid, Cell start, Cell goal, const Rectangle& part) const {
    if (!(distance(start, part) + distance(goal, part) < length_)) return false;
    for (int y = part.y; y < part.y + part.height; ++y) {
      for (int x = part.x; x < part.x + part.width; ++x) {
        if (grid.free({x, y})) return true;
      }
    }
    return false;
  }
  /// Can its moves still be made?
  bool walkable(const Grid& grid, Corners corners, const kernels::Moves& moves, Cell start) const {
    return std::ranges::all_of(moves_, [&](int k) {
      const Cell from = std::exchange(start, start + moves[k].to);
      return move_exists(grid, corners, from, moves[k]);
    });
  }
  /// The largest tau on it; 0 without one.
  double strongest(Field& field, const kernels::Moves& moves, Cell start) const {
    double most = 0;
    for (const int k : moves_) {
      most = std::max(most, field.tau(start, k));
      start = start + moves[k].to;
    }
    return most;
  }

 private:
  std::vector<std::uint8_t> moves_;
  double length_ = kInfinity;
};

}  // namespace lasius
