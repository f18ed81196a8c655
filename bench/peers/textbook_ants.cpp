#include "bench/peers/textbook_ants.h"

#include <cmath>

namespace lasius::peers {

TextbookAnts::TextbookAnts(const Grid& grid, Cell start, Cell goal, const Options& options)
    : width_(grid.width()),
      height_(grid.height()),
      start_(start),
      goal_(goal),
      options_(options),
      blocked_(height_, std::vector<bool>(width_)),
      pheromone_(height_, std::vector<double>(width_, 1.0)),
      heuristic_(height_, std::vector<double>(width_)),
      tabu_(height_, std::vector<char>(width_, 0)),
      tours_(options.ants),
      random_(options.seed) {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      blocked_[y][x] = grid.blocked({x, y});
      heuristic_[y][x] = 1.0 / std::max(0.5, std::hypot(x - goal.x, y - goal.y));
    }
  }
}

void TextbookAnts::walk(Tour& tour) {
  tour.cells.assign(1, start_);
  tour.length = 0;
  Cell at = start_;
  tabu_[at.y][at.x] = 1;
  Cell candidates[8];
  double weights[8];
  while (at != goal_) {
    int count = 0;
    double total = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell c{at.x + dx, at.y + dy};
        if (c.x < 0 || c.y < 0 || c.x >= width_ || c.y >= height_) continue;
        if (blocked_[c.y][c.x] || tabu_[c.y][c.x] != 0) continue;
        if (blocked_[at.y][c.x] || blocked_[c.y][at.x]) continue;
        candidates[count] = c;
        weights[count] = std::pow(pheromone_[c.y][c.x], options_.alpha) *
                         std::pow(heuristic_[c.y][c.x], options_.beta);
        total += weights[count++];
      }
    }
    if (count == 0) break;
    double draw = std::uniform_real_distribution<double>(0, total)(random_);
    int chosen = 0;
    while (chosen + 1 < count && (draw -= weights[chosen]) > 0) ++chosen;
    tour.length += candidates[chosen].x != at.x && candidates[chosen].y != at.y ? std::sqrt(2) : 1;
    at = candidates[chosen];
    tabu_[at.y][at.x] = 1;
    tour.cells.push_back(at);
  }
  steps_ += static_cast<std::int64_t>(tour.cells.size()) - 1;
  tour.arrived = at == goal_;
  for (const Cell c : tour.cells) tabu_[c.y][c.x] = 0;
}

void TextbookAnts::iterate() {
  for (Tour& tour : tours_) walk(tour);
  for (auto& row : pheromone_) {
    for (double& tau : row) tau *= 1 - options_.evaporation;
  }
  for (const Tour& tour : tours_) {
    if (!tour.arrived) continue;
    for (const Cell c : tour.cells) pheromone_[c.y][c.x] += options_.deposit / tour.length;
  }
}

}  // namespace lasius::peers
