#include "bench/peers/textbook_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lasius::peers {

TextbookCrossings::TextbookCrossings(Point start, Point goal,
                                     const std::vector<std::pair<Point, Point>>& lines,
                                     const Options& options)
    : start_(start),
      goal_(goal),
      options_(options),
      pheromone_(lines.size(), std::vector<double>(options.values, options.initial_pheromone)),
      best_values_(lines.size(), 0.5),
      weights_(options.values),
      tours_(options.ants, std::vector<int>(lines.size())),
      random_(options.seed),
      best_length_(std::numeric_limits<double>::infinity()) {
  for (const auto& [a, b] : lines) {
    auto& points = points_.emplace_back();
    for (int k = 0; k < options.values; ++k) {
      const double h = static_cast<double>(k) / (options.values - 1);
      points.push_back({a.x + h * (b.x - a.x), a.y + h * (b.y - a.y)});
    }
  }
}

int TextbookCrossings::choose(std::size_t line) {
  double sum = 0;
  for (int k = 0; k < options_.values; ++k) {
    const double h = static_cast<double>(k) / (options_.values - 1);
    const double visibility = (1.1 - std::abs(h - best_values_[line])) / 1.1;
    weights_[k] = pheromone_[line][k] * std::pow(visibility, options_.beta);
    sum += weights_[k];
  }
  std::uniform_real_distribution<double> unit(0, 1);
  if (unit(random_) <= options_.greedy) {
    return static_cast<int>(std::max_element(weights_.begin(), weights_.end()) - weights_.begin());
  }
  double left = unit(random_) * sum;
  for (int k = 0; k + 1 < options_.values; ++k) {
    left -= weights_[k];
    if (left < 0) return k;
  }
  return options_.values - 1;
}

double TextbookCrossings::length(const std::vector<int>& tour) const {
  Point at = start_;
  double sum = 0;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const Point next = points_[i][tour[i]];
    sum += std::hypot(next.x - at.x, next.y - at.y);
    at = next;
  }
  return sum + std::hypot(goal_.x - at.x, goal_.y - at.y);
}

void TextbookCrossings::iterate() {
  const double rho = options_.evaporation;  // the source's letter
  for (std::size_t i = 0; i < points_.size(); ++i) {
    for (auto& tour : tours_) {
      const int k = choose(i);
      tour[i] = k;
      pheromone_[i][k] = (1 - rho) * pheromone_[i][k] + rho * options_.initial_pheromone;
    }
  }
  for (const auto& tour : tours_) {
    const double found = length(tour);
    if (!(found < best_length_)) continue;
    best_length_ = found;
    best_ = tour;
  }
  for (std::size_t i = 0; i < best_.size(); ++i) {
    best_values_[i] = static_cast<double>(best_[i]) / (options_.values - 1);
    double& tau = pheromone_[i][best_[i]];
    tau = (1 - rho) * tau + rho / best_length_;
  }
}

}  // namespace lasius::peers
