// What an observer sees of a colony on a bitmap.
#pragma once

#include <span>
#include <stdexcept>
#include <vector>

#include "core/colony/best_path.h"
#include "core/colony/field.h"
#include "core/colony/walkers.h"
#include "kernels/base/moves.h"
#include "lasius/plan/progress.h"

namespace lasius {

/// A view of what its arguments, which outlive it, hold.
class ColonyView final : public GridProgress {
 public:
  ColonyView(const BestPath& best, std::span<const Ant> ants, const kernels::Moves& moves,
             Cell start, const Field& field)
      : best_(best), ants_(ants), moves_(moves), start_(start), field_(field) {}

  std::vector<Point> path() const override { return best_.points(); }
  int ants() const override { return static_cast<int>(ants_.size()); }
  std::vector<Cell> tour(int ant) const override {
    return walked(ant).arrived ? walk(ant) : std::vector<Cell>{};
  }
  std::vector<Cell> walk(int ant) const override {
    std::vector<Cell> cells;
    along_tour(walked(ant).tour(), moves_, start_, [&](Cell c) { cells.push_back(c); });
    return cells;
  }
  double pheromone(Cell c) const override { return field_.pheromone(c); }

 private:
  const Ant& walked(int ant) const {
    if (ant < 0 || ant >= ants()) throw std::out_of_range("there is no such ant");
    return ants_[ant];
  }

  const BestPath& best_;
  std::span<const Ant> ants_;
  const kernels::Moves& moves_;
  Cell start_;
  const Field& field_;
};

}  // namespace lasius
