// A grid's trail and tours as the rules of a trail see them, built-in or a caller's own.
#pragma once

#include <cstddef>

#include "core/base/poller.h"
#include "core/colony/field.h"
#include "core/colony/update.h"
#include "core/grid/move_rule.h"
#include "lasius/params.h"

namespace lasius {

/// What carries pheromone on a grid: with arcs a move out of a cell, with cells the cell itself.
struct GridPlace {
  Cell cell;
  int move = 0;
};

/// A field as the rules of a trail see it.
struct FieldTrail {
  Field& field;

  void evaporate(double persistence) { field.evaporate(persistence); }
  void bound(double least, double most) { field.bound(least, most); }
  void deposit(GridPlace p, double amount) { field.deposit(p.cell, p.move, amount); }
  double tau(GridPlace p) const { return field.tau(p.cell, p.move); }
  void set_tau(GridPlace p, double value) { field.set_tau(p.cell, p.move, value); }
};

/// Tours of a grid as the rules of a trail see them.
struct GridTours : Tours {
  Trail trail;
  Poller& poller;

  /// With arcs, visits the cells that moves leave, with cells all of them; fewer when stopped.
  template <class Visit>
  void along(const Tour& tour, const Visit& visit) const {
    Cell c = start;
    for (const int k : tour.moves) {
      if (poller.stop_after(1)) return;
      visit(GridPlace{c, trail == Trail::arcs ? k : 0});
      c = c + moves[k].to;
    }
    if (trail == Trail::cells) visit(GridPlace{c});
  }
  int choices() const { return moves.count; }
  std::size_t moves_of(const Tour& tour) const { return tour.moves.size(); }
};

}  // namespace lasius
