// A path over costs made cheaper, through the cells that it passes and those around its corners.
#pragma once

#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/cost/crossings.h"
#include "core/cost/terrain.h"

namespace lasius::cost {

/// A piece of a path, from where the one before ended, that lies in one free cell.
struct Leg {
  Cell cell;
  Point to;
};

/// Moves the path's crossings to the cheapest places on their edges; leads it round corners on the
/// other side where that is cheaper, until it is so nowhere.
class Polish {
 public:
  explicit Polish(const Terrain& terrain) : terrain_(terrain) {}

  /// The polished path, start to goal; ends early, with a good path all the same, when stopped.
  /// @param legs  the last one ends at the goal; cells of consecutive ones share an edge, or a
  /// corner where the first one ends
  std::vector<Point> polish(Point start, std::span<const Leg> legs, Poller& poller);
  /// Of the last path.
  double cost() const noexcept { return cost_; }

 private:
  void take(std::span<const Leg> legs);
  void enter(Cell cell, Point at);
  bool flip_all(Poller& poller);
  bool flip(std::size_t first, std::size_t last);
  bool replace(std::size_t first, std::size_t last, std::span<const Cell> cells, double offset);

  const Terrain& terrain_;
  Point start_, goal_;
  std::vector<Cell> cells_;  // one more than crossings
  std::vector<Crossing> crossings_;
  std::vector<double> weights_;  // of cells_
  std::vector<char> fresh_;      // of crossings: not tried since something moved near it
  std::vector<Crossing> window_;
  std::vector<double> window_weights_;
  CrossingsOptimizer optimizer_;
  double cost_ = 0;
};

/// A walk from centre to centre as legs.
std::vector<Leg> legs_of(std::span<const Cell> walk);

}  // namespace lasius::cost
