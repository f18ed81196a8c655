// Paths of your own: check them, straighten them, pull them taut.
#include <lasius/lasius.h>

#include <iostream>
#include <vector>

int main() {
  using namespace lasius;
  Grid grid(20, 20);
  grid.fill({5, 5, 10, 10}, true);

  std::vector<Cell> walk;  // around the block, cell by cell
  for (int x = 0; x < 18; ++x) walk.push_back({x, 2});
  for (int y = 2; y < 20; ++y) walk.push_back({17, y});

  std::vector<Point> centres;
  for (const Cell c : straighten(grid, walk)) centres.push_back(centre(c));
  const std::vector<Point> taut = pull_taut(grid, centres);
  std::cout << path_length(centres) << " over cell centres, " << path_length(taut) << " taut\n";
  return path_fault(grid, taut) || path_length(taut) > path_length(centres) ? 1 : 0;
}
