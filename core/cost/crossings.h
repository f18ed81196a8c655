// A path through a given chain of cells, by where it crosses the edges between them.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "core/cost/terrain.h"

namespace lasius::cost {

/// Where a path crosses the edge between two cells: `t` of the way from the edge's upper or left
/// end.
struct Crossing {
  int x = 0, y = 0;    ///< of that end
  bool level = false;  ///< an edge along x
  double t = 0;        ///< 0 to 1

  Point point() const noexcept { return {x + (level ? t : 0), y + (level ? 0 : t)}; }
  /// At an end of the edge, or so near that it may be held there by rounding.
  bool at_end() const noexcept { return t < 1e-5 || t > 1 - 1e-5; }
  /// The lattice point where it is, of one at an end.
  Cell corner() const noexcept {
    const int far = t > 0.5 ? 1 : 0;
    return {x + (level ? far : 0), y + (level ? 0 : far)};
  }
};

/// The edge between two cells that share one, crossed at its upper or left end.
constexpr Crossing crossing_between(Cell a, Cell b) noexcept {
  if (a.y == b.y) return {a.x > b.x ? a.x : b.x, a.y, false, 0};
  return {a.x, a.y > b.y ? a.y : b.y, true, 0};
}

/// The cost of a path from `from` to `to` through crossings; weights[i] is that of the cell before
/// crossing i, the last one that of the cell after all.
double cost_through(Point from, Point to, std::span<const Crossing> crossings,
                    std::span<const double> weights) noexcept;

/// Moves crossings along their edges to where such a path is cheapest.
class CrossingsOptimizer {
 public:
  /// Returns the cost, which is no more than before.
  double optimize(Point from, Point to, std::span<Crossing> crossings,
                  std::span<const double> weights, int most_steps);

 private:
  void derive(Point from, Point to, std::span<const Crossing> crossings,
              std::span<const double> weights);
  void derive_within(Point from, Point to, std::span<const Crossing> crossings,
                     std::span<const double> weights);
  void solve(double damping);

  std::vector<double> slope_, bend_, coupling_, move_, scratch_;
  std::vector<Crossing> trial_;
};

}  // namespace lasius::cost
