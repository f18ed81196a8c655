// What a Pheromone acts on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/poller.h"
#include "core/colony/grid_tours.h"
#include "lasius/grid.h"
#include "lasius/own_rules.h"
#include "lasius/params.h"

namespace lasius {

class Pheromone::Impl {
 public:
  /// The trail of a colony with `choices` moves out of a cell. Field and `stop` outlive the object.
  Impl(Field& field, const Grid& grid, const Params& params, int choices, Poller& stop)
      : trail{field},
        kind(params.trail),
        learned(params.heuristic == Heuristic::learned),
        width(grid.width()),
        moves(kind == Trail::arcs ? choices : 1),
        cells(std::int64_t{width} * grid.height()),
        poller(stop) {}

  std::int64_t places() const noexcept { return cells * moves; }
  Cell cell(TrailPlace cell) const noexcept {
    return {static_cast<int>(cell % width), static_cast<int>(cell / width)};
  }
  GridPlace at(TrailPlace place) const noexcept {
    return {cell(place / moves), static_cast<int>(place % moves)};
  }
  /// Calls act(place, i) for the i-th place, one after the other; for fewer when stopped.
  template <class Act>
  void for_each(std::span<const TrailPlace> places, const Act& act) const {
    for (std::size_t i = 0; i < places.size() && !poller.stop_after(1); ++i) act(places[i], i);
  }

  FieldTrail trail;
  const Trail kind;
  const bool learned;  ///< cells teach, see Heuristic::learned
  const int width;
  const int moves;  ///< places a cell
  const std::int64_t cells;
  Poller& poller;
};

}  // namespace lasius
