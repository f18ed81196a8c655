// Small maps and questions for discs: noise, blocks, walls, and doors just wide enough.
#pragma once

#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>

#include "core/disc/disc_space.h"
#include "tests/worlds/grids.h"

namespace lasius::disc {

/// LASIUS_DISC_MAPS scales the random tests.
inline int scaled(int count) {
  const char* const scale = std::getenv("LASIUS_DISC_MAPS");
  return scale == nullptr ? count : count * std::max(1, std::atoi(scale));
}

/// A radius of [0.3, most]: any, a multiple of 1/2, or half the distance of two lattice points.
inline double random_radius(double most, std::mt19937& random) {
  const auto any = [&] { return 0.3 + (most - 0.3) * random_in(0, 1 << 20, random) / (1 << 20); };
  double radius = any();
  if (random_in(0, 2, random) == 0)
    radius = std::max(1.0, std::round(2 * radius)) / 2;
  else if (random_in(0, 1, random) == 0) {
    const int limit = std::max(1, static_cast<int>(2 * radius));
    const int x = random_in(1, limit, random), y = random_in(0, limit, random);
    radius = std::sqrt(static_cast<double>(x * x + y * y)) / 2;
  }
  return radius;
}

/// Rows or columns of walls, each with a door as wide as the disc where that is whole.
inline Grid walls(int width, int height, double radius, std::mt19937& random) {
  Grid grid(width, height);
  const bool upright = random_in(0, 1, random) == 0;
  const int along = upright ? height : width, across = upright ? width : height;
  const int door = static_cast<int>(std::ceil(2 * radius - 1e-9));
  for (int at = door + random_in(0, door + 1, random); at < across;
       at += door + 1 + random_in(0, 2, random)) {
    const int opens = random_in(0, std::max(0, along - door), random);
    for (int i = 0; i < along; ++i) {
      if (i < opens || i >= opens + door) grid.set_blocked(upright ? Cell{at, i} : Cell{i, at});
    }
  }
  return grid;
}

/// A small map whose sides suit the radius.
inline Grid random_map(double radius, std::mt19937& random) {
  const int least = static_cast<int>(4 * radius) + 3;
  const int width = random_in(least, least + 12, random),
            height = random_in(least, least + 12, random);
  switch (random_in(0, 3, random)) {
    case 0: {  // noise; thinner for larger discs
      const double share = random_in(2, 60, random) / (1 + radius * radius);
      return grid_of(width, height,
                     [&](int, int) { return random_in(0, 9999, random) < 100 * share; });
    }
    case 1: {
      Grid grid(width, height);
      for (int blocks = random_in(1, 6, random); blocks > 0; --blocks) {
        const Cell at = random_cell(grid, random);
        const int side = random_in(1, 4, random), other = random_in(1, 4, random);
        for (const Cell c : cells_of({at.x, at.y, side, other})) {
          if (grid.contains(c)) grid.set_blocked(c);
        }
      }
      return grid;
    }
    default:
      return walls(width, height, radius, random);
  }
}

/// A clear point: any, or a multiple of 1/2; nothing after many tries.
inline std::optional<Point> random_clear(const DiscSpace& space, std::mt19937& random) {
  for (int i = 0; i < 64; ++i) {
    const int grain = random_in(0, 1, random) == 0 ? 2 : 1 << 16;
    const Point p{1.0 * random_in(0, grain * space.map().width(), random) / grain,
                  1.0 * random_in(0, grain * space.map().height(), random) / grain};
    if (space.clear(p)) return p;
  }
  return std::nullopt;
}

}  // namespace lasius::disc
