// A map from a robot's occupancy bytes: one byte a cell, row by row from the top left.
#include <lasius/lasius.h>

#include <cstdint>
#include <iostream>
#include <vector>

int main() {
  using namespace lasius;
  constexpr int kWidth = 64, kHeight = 32;
  std::vector<std::uint8_t> occupied(kWidth * kHeight, 0);
  for (int y = 0; y < 24; ++y) occupied[y * kWidth + 30] = 255;  // a wall, open below

  Grid grid(kWidth, kHeight, occupied, Nonzero::blocked);
  grid.fill({40, 8, 6, 24}, true);  // x, y, width, height

  const Planner planner(std::move(grid));
  const Result result = planner.plan({.start = {2, 2}, .goal = {61, 29}});
  for (const Point p : result.path) std::cout << p.x << ' ' << p.y << '\n';
  return result.status == Status::solved ? 0 : 1;
}
