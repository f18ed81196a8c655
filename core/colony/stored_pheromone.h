// The trail behind lasius::Pheromone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/colony/field.h"
#include "lasius/grid/grid.h"
#include "lasius/params/own_rules.h"
#include "lasius/params/params.h"

namespace lasius {

/// Divides places, below 2^53, by one number: a product and a correction, which overlap from place
/// to place as divisions do not.
class PlaceDivisor {
 public:
  explicit PlaceDivisor(std::int64_t divisor) noexcept
      : divisor_(divisor), reciprocal_(1.0 / static_cast<double>(divisor)) {}

  struct Parts {
    std::int64_t quotient, remainder;
  };
  /// Exact, for a place from 0 on.
  Parts divide(TrailPlace place) const noexcept {
    auto quotient = static_cast<std::int64_t>(static_cast<double>(place) * reciprocal_);
    quotient -= quotient * divisor_ > place;  // the product is off by one at most
    quotient += place - quotient * divisor_ >= divisor_;
    return {quotient, place - quotient * divisor_};
  }

 private:
  std::int64_t divisor_;
  double reciprocal_;
};

/// A trail as a Pheromone changes it, and that Pheromone.
class StoredPheromone {
 public:
  /// The trail of a colony with `choices` moves out of a cell, which outlives the object.
  StoredPheromone(Field& trail, const Grid& grid, const Params& params, int choices)
      : field(trail),
        kind(params.trail),
        learned(params.heuristic == Heuristic::learned),
        width(grid.width()),
        moves(kind == Trail::arcs ? choices : 1),
        cells(std::int64_t{width} * grid.height()),
        by_width(width),
        by_moves(moves) {}

  std::int64_t places() const noexcept { return cells * moves; }
  Cell cell(TrailPlace cell) const noexcept {
    const auto [y, x] = by_width.divide(cell);
    return {static_cast<int>(x), static_cast<int>(y)};
  }
  GridPlace at(TrailPlace place) const noexcept {
    const auto [number, move] = by_moves.divide(place);
    return {cell(number), static_cast<int>(move)};
  }
  /// Calls act(at(place), i) for the i-th place, one after the other. The divisions go ahead of
  /// a block, so that its misses of the cache overlap.
  template <class Act>
  void for_each(std::span<const TrailPlace> places, const Act& act) const {
    std::array<GridPlace, 64> block;
    for (std::size_t i = 0; i < places.size();) {
      const auto count = std::min(block.size(), places.size() - i);
      for (std::size_t k = 0; k < count; ++k) block[k] = at(places[i + k]);
      for (std::size_t k = 0; k < count; ++k, ++i) act(block[k], i);
    }
  }

  Field& field;
  const Trail kind;
  const bool learned;  ///< cells teach, see Heuristic::learned
  const int width;
  const int moves;  ///< places a cell
  const std::int64_t cells;
  const PlaceDivisor by_width, by_moves;
  Pheromone pheromone{*this};
};

}  // namespace lasius
