// The ant system as textbooks and most repositories write it: the baseline of our walk kernel.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "lasius/grid/grid.h"

namespace lasius::peers {

/// Ant system on 8 neighbours (Dorigo, Maniezzo & Colorni 1996): pheromone in a vector of vectors,
/// std::pow for every candidate, std::mt19937, a tabu matrix an ant; an ant that traps itself dies.
/// Plain, but no slower than it has to be: distances to the goal are computed once, and matrices
/// are kept between ants.
class TextbookAnts {
 public:
  struct Options {
    int ants = 10;
    double alpha = 1, beta = 5;
    double evaporation = 0.3;
    double deposit = 1;
    std::uint32_t seed = 1;
  };

  TextbookAnts(const Grid& grid, Cell start, Cell goal, const Options& options);

  /// One iteration: every ant walks, pheromone evaporates, ants that arrived deposit.
  void iterate();

  std::int64_t steps() const noexcept { return steps_; }  ///< moves made since construction

 private:
  struct Tour {
    std::vector<Cell> cells;
    double length = 0;
    bool arrived = false;
  };
  void walk(Tour& tour);

  int width_, height_;
  Cell start_, goal_;
  Options options_;
  std::vector<std::vector<bool>> blocked_;
  std::vector<std::vector<double>> pheromone_;
  std::vector<std::vector<double>> heuristic_;  // 1 / distance to the goal
  std::vector<std::vector<char>> tabu_;
  std::vector<Tour> tours_;
  std::mt19937 random_;
  std::int64_t steps_ = 0;
};

}  // namespace lasius::peers
