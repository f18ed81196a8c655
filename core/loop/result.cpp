#include <stdexcept>

#include "lasius/plan/progress.h"
#include "lasius/plan/search_result.h"

namespace lasius {

std::optional<double> SearchResult::gap() const {
  if (length == 0) return 0;
  if (!lower_bound || !(*lower_bound > 0) || !(length > 0)) return std::nullopt;
  return (length - *lower_bound) / *lower_bound;
}

GridProgress::~GridProgress() = default;

std::vector<Cell> GridProgress::tour(int) const {
  throw std::out_of_range("the algorithm has no ants");
}

double GridProgress::pheromone(Cell) const { return 0; }

}  // namespace lasius
