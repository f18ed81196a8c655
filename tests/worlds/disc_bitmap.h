// A disc swept over a fine bitmap of a polygon world, independent of the library's geometry.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lasius/polygon/world.h"

namespace lasius::polygon {

/// The square of the distance; a root would take ten times as long.
inline double square_of_distance_to_segment(Point a, Point b, Point p) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  const double share = std::clamp(along, 0.0, 1.0);
  const double x = a.x + share * dx - p.x, y = a.y + share * dy - p.y;
  return x * x + y * y;
}

/// From a point to the nearest edge of an obstacle, or of the boundary if that counts.
inline double distance_to_edges(const World& world, Point p, bool boundary) {
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      least =
          std::min(least, square_of_distance_to_segment(ring[i], ring[(i + 1) % ring.size()], p));
  };
  for (const Polygon& obstacle : world.obstacles) look(obstacle.outer);
  if (boundary) look(world.boundary.outer);
  return std::sqrt(least);
}

/// Cells on whose centres a disc fits, with half a cell more so that it fits between neighbouring
/// centres, too. For worlds without holes whose boundary is a box from the origin.
class DiscBitmap {
 public:
  DiscBitmap(const World& world, double radius, double cell)
      : cell_(cell), side_(static_cast<int>(world.boundary.outer[2].x / cell)) {
    component_.assign(static_cast<std::size_t>(side_) * side_, kOpen);
    for (const Polygon& obstacle : world.obstacles) {
      fill(obstacle.outer);
      for (std::size_t i = 0; i < obstacle.outer.size(); ++i)
        block_near(obstacle.outer[i], obstacle.outer[(i + 1) % obstacle.outer.size()],
                   radius + cell / 2);
    }
    const Ring& wall = world.boundary.outer;
    for (std::size_t i = 0; i < wall.size(); ++i)
      block_near(wall[i], wall[(i + 1) % wall.size()], radius + cell / 2);
    int number = 0;
    for (std::size_t i = 0; i < component_.size(); ++i)
      if (component_[i] == kOpen) flood(i, number++);
  }

  /// The centre of the free cell that is nearest, row by row outwards. Precondition: there is one.
  Point free_near(Point p) const {
    double least = std::numeric_limits<double>::infinity();
    Point best;
    for (int y = 0; y < side_; ++y) {
      for (int x = 0; x < side_; ++x) {
        if (component_[index(x, y)] < 0) continue;
        const Point c = centre(x, y);
        const double d = (c.x - p.x) * (c.x - p.x) + (c.y - p.y) * (c.y - p.y);
        if (d < least) {
          least = d;
          best = c;
        }
      }
    }
    return best;
  }
  /// Precondition: both are centres of free cells.
  bool joined(Point a, Point b) const { return component_at(a) == component_at(b); }

 private:
  static constexpr int kOpen = -2, kBlocked = -1;

  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * side_ + x; }
  Point centre(int x, int y) const { return {(x + 0.5) * cell_, (y + 0.5) * cell_}; }
  int column(double x) const { return std::clamp(static_cast<int>(x / cell_), 0, side_ - 1); }
  int component_at(Point p) const { return component_[index(column(p.x), column(p.y))]; }

  void block_near(Point a, Point b, double radius) {
    const int right = column(std::max(a.x, b.x) + radius),
              top = column(std::max(a.y, b.y) + radius);
    for (int y = column(std::min(a.y, b.y) - radius); y <= top; ++y)
      for (int x = column(std::min(a.x, b.x) - radius); x <= right; ++x)
        if (square_of_distance_to_segment(a, b, centre(x, y)) < radius * radius)
          component_[index(x, y)] = kBlocked;
  }
  /// Even-odd rule, row by row.
  void fill(const Ring& ring) {
    for (int y = 0; y < side_; ++y) {
      const double level = (y + 0.5) * cell_;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        if ((a.y > level) == (b.y > level)) continue;
        crossings_.push_back(a.x + (level - a.y) / (b.y - a.y) * (b.x - a.x));
      }
      std::sort(crossings_.begin(), crossings_.end());
      for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2)
        for (int x = column(crossings_[i]); x <= column(crossings_[i + 1]); ++x)
          if (const double c = centre(x, y).x; c > crossings_[i] && c < crossings_[i + 1])
            component_[index(x, y)] = kBlocked;
      crossings_.clear();
    }
  }
  void flood(std::size_t from, int number) {
    std::vector<std::size_t> open{from};
    component_[from] = number;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      const int x = static_cast<int>(at % side_), y = static_cast<int>(at / side_);
      const auto go = [&](int nx, int ny) {
        if (nx < 0 || ny < 0 || nx >= side_ || ny >= side_) return;
        int& cell = component_[index(nx, ny)];
        if (cell != kOpen) return;
        cell = number;
        open.push_back(index(nx, ny));
      };
      go(x - 1, y);
      go(x + 1, y);
      go(x, y - 1);
      go(x, y + 1);
    }
  }

  double cell_;
  int side_;
  std::vector<int> component_;
  std::vector<double> crossings_;
};

}  // namespace lasius::polygon
