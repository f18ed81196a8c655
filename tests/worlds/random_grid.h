// Random grids and walks for tests, the same on every machine.
#pragma once

#include <initializer_list>
#include <random>
#include <vector>

#include "lasius/grid.h"
#include "lasius/moves.h"

namespace lasius {

/// Each cell blocked with probability `percent` / 100.
inline Grid random_grid(int width, int height, int percent, std::mt19937& random) {
  Grid grid(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (static_cast<int>(random() % 100) < percent) grid.set_blocked({x, y});
    }
  }
  return grid;
}

/// A number of [lo, hi].
inline int random_in(int lo, int hi, std::mt19937& random) {
  return lo + static_cast<int>(random() % static_cast<unsigned>(hi - lo + 1));
}

/// Any cell, blocked or free.
inline Cell random_cell(const Grid& grid, std::mt19937& random) {
  return {random_in(0, grid.width() - 1, random), random_in(0, grid.height() - 1, random)};
}

using Walk = std::vector<Cell>;

/// A walk of random steps from a random free cell; it leans to one side for a while at a time;
/// empty if that cell is blocked.
inline Walk random_walk(const Grid& grid, int steps, bool diagonal, Corners corners,
                        std::mt19937& random) {
  Cell at = random_cell(grid, random);
  if (grid.blocked(at)) return {};
  Walk walk{at};
  int lean_x = 0;
  int lean_y = 0;
  for (int i = 0; i < steps; ++i) {
    if (random() % 16 == 0) {
      lean_x = random_in(-1, 1, random);
      lean_y = random_in(-1, 1, random);
    }
    const bool lean = random() % 2 == 0;
    const int dx = lean ? lean_x : random_in(-1, 1, random);
    const int dy = lean ? lean_y : random_in(-1, 1, random);
    const Cell next{at.x + dx, at.y + dy};
    if (grid.blocked(next) || (!diagonal && dx != 0 && dy != 0)) continue;
    const int free_sides = grid.free({at.x + dx, at.y}) + grid.free({at.x, at.y + dy});
    if (corners == Corners::forbid && free_sides < 2) continue;
    if (corners == Corners::one_side && free_sides < 1) continue;
    at = next;
    walk.push_back(at);
  }
  return walk;
}

/// A walk by straight moves of at least 1000 cells.
inline Walk long_walk(const Grid& grid, std::mt19937& random) {
  Walk walk;
  while (walk.size() < 1000) walk = random_walk(grid, 5000, false, Corners::forbid, random);
  return walk;
}

/// A grid drawn from text: '#' is blocked.
inline Grid drawn(std::initializer_list<const char*> rows) {
  int width = 0;
  while ((*rows.begin())[width] != '\0') ++width;
  Grid grid(width, static_cast<int>(rows.size()));
  int y = 0;
  for (const char* row : rows) {
    for (int x = 0; x < width; ++x) grid.set_blocked({x, y}, row[x] == '#');
    ++y;
  }
  return grid;
}

}  // namespace lasius
