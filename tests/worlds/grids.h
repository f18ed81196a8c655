// Grids and walks for tests: drawn, by a rule, and random, the same on every machine.
#pragma once

#include <initializer_list>
#include <random>
#include <string_view>
#include <vector>

#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// The cells of a part of a map, row by row.
inline std::vector<Cell> cells_of(const Rectangle& part) {
  std::vector<Cell> cells;
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) cells.push_back({x, y});
  }
  return cells;
}
inline std::vector<Cell> cells_of(const Grid& grid) {
  return cells_of(Rectangle{0, 0, grid.width(), grid.height()});
}

/// Blocked where `blocked(x, y)` holds, which is asked row by row.
template <class Blocked>
Grid grid_of(int width, int height, const Blocked& blocked) {
  Grid grid(width, height);
  for (const Cell c : cells_of(grid)) grid.set_blocked(c, blocked(c.x, c.y));
  return grid;
}

/// Blocked in these parts alone.
inline Grid walled(int width, int height, std::initializer_list<Rectangle> parts) {
  Grid grid(width, height);
  for (const Rectangle& part : parts) grid.fill(part, true);
  return grid;
}
/// Blocked at these cells alone.
inline Grid with_blocked(int width, int height, std::initializer_list<Cell> cells) {
  Grid grid(width, height);
  for (const Cell c : cells) grid.set_blocked(c);
  return grid;
}

/// A grid drawn from text: '#' and '@' are blocked.
inline Grid drawn(std::initializer_list<std::string_view> rows) {
  return grid_of(static_cast<int>(rows.begin()->size()), static_cast<int>(rows.size()),
                 [&](int x, int y) {
                   const char cell = rows.begin()[y][x];
                   return cell == '#' || cell == '@';
                 });
}

/// Of every second row only one end is free, right and left in turn: one way leads through all.
inline Grid snake(int side) {
  return grid_of(side, side,
                 [side](int x, int y) { return y % 2 == 1 && x != (y % 4 == 1 ? side - 1 : 0); });
}

/// Each cell blocked with probability `percent` / 100.
inline Grid random_grid(int width, int height, int percent, std::mt19937& random) {
  return grid_of(width, height,
                 [&](int, int) { return static_cast<int>(random() % 100) < percent; });
}

/// A random grid whose lower half mirrors the upper one.
inline Grid mirrored_grid(int width, int height, int percent, std::mt19937& random) {
  Grid grid = random_grid(width, height, percent, random);
  for (const Cell c : cells_of({0, 0, width, height / 2})) {
    grid.set_blocked({c.x, height - 1 - c.y}, grid.blocked(c));
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

/// Blocks of up to `most` x `most` cells, some across each other.
inline Grid random_blocks(int width, int height, int blocks, int most, std::mt19937& random) {
  Grid grid(width, height);
  for (int i = 0; i < blocks; ++i) {
    const int w = random_in(1, most, random), h = random_in(1, most, random);
    grid.fill({random_in(0, width - w, random), random_in(0, height - h, random), w, h}, true);
  }
  return grid;
}

using Walk = std::vector<Cell>;

/// Whether a step between neighbours may pass the two cells beside it.
inline bool passes_corner(const Grid& grid, Corners corners, Cell from, Cell to) {
  const int free_sides = grid.free({to.x, from.y}) + grid.free({from.x, to.y});
  return free_sides >= (corners == Corners::forbid ? 2 : corners == Corners::one_side ? 1 : 0);
}

/// Goes from cell to cell, breadth first, wherever `enter(from, to)` lets it.
template <class Enter>
void flood(Cell seed, bool diagonal, const Enter& enter) {
  std::vector<Cell> queue{seed};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Cell from = queue[i];
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell to{from.x + dx, from.y + dy};
        if ((diagonal || dx == 0 || dy == 0) && enter(from, to)) queue.push_back(to);
      }
    }
  }
}

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
    if (!passes_corner(grid, corners, at, next)) continue;
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

}  // namespace lasius
