// Ant colony system over crossing points, written down from the lecture: `maklink-acs`' baseline.
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "lasius/grid/geometry.h"

namespace lasius::peers {

/// Pheromone in a vector of vectors, std::pow for every value at every choice, a vector of
/// probabilities for every draw, std::mt19937. Plain, but no slower than it has to be: memory is
/// kept between choices, crossing points are computed once.
class TextbookCrossings {
 public:
  struct Options {
    int ants = 10;
    int values = 11;
    double beta = 2;
    double greedy = 0.85;
    double evaporation = 0.1;
    double initial_pheromone = 0.0002;
    std::uint32_t seed = 1;
  };

  /// The lines in the order in which they are crossed.
  TextbookCrossings(Point start, Point goal, const std::vector<std::pair<Point, Point>>& lines,
                    const Options& options);

  void iterate();
  double best_length() const noexcept { return best_length_; }

 private:
  int choose(std::size_t line);
  double length(const std::vector<int>& tour) const;

  Point start_, goal_;
  Options options_;
  std::vector<std::vector<Point>> points_;
  std::vector<std::vector<double>> pheromone_;
  std::vector<double> best_values_;  // h*, the middles at first
  std::vector<double> weights_;
  std::vector<std::vector<int>> tours_;
  std::vector<int> best_;
  std::mt19937 random_;
  double best_length_;
};

}  // namespace lasius::peers
