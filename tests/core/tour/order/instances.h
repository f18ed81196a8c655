// Stops for tests, from a seed.
#pragma once

#include <vector>

#include "core/tour/order/costs.h"
#include "kernels/base/random_stream.h"
#include "lasius/grid/geometry.h"

namespace lasius::tour {

struct Instance {
  int size;
  std::vector<Point> places;
  std::vector<Cost> matrix;
  Costs costs() const { return {size, matrix.data()}; }
};

/// Costs by steps along the axes, or where `any`, drawn each alone: without a triangle's
/// inequality.
inline Instance random_instance(int size, std::uint32_t seed, bool any = false) {
  kernels::RandomStream random(seed, 0, 0);
  Instance made{size, {}, std::vector<Cost>(static_cast<std::size_t>(size) * size)};
  for (int v = 0; v < size; ++v)
    made.places.push_back({double(random.below(100)), double(random.below(100))});
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < a; ++b) {
      const Point &p = made.places[a], &q = made.places[b];
      const Cost cost =
          any ? random.below(100)
              : Cost((p.x > q.x ? p.x - q.x : q.x - p.x) + (p.y > q.y ? p.y - q.y : q.y - p.y));
      made.matrix[a * size + b] = made.matrix[b * size + a] = cost;
    }
  return made;
}

/// Row by row.
// Among the first `count` stops, row by row.
inline std::vector<double> legs_of(const Costs& costs, int count) {
  std::vector<double> legs;
  for (int a = 0; a < count; ++a)
    for (int b = 0; b < count; ++b) legs.push_back(costs(a, b));
  return legs;
}

inline std::vector<double> legs_of(const Costs& costs) { return legs_of(costs, costs.size()); }

inline const std::vector<Ends> kEnds = {{},        {false, 2},    {true},
                                        {true, 1}, {true, -1, 2}, {true, 2, 0}};

}  // namespace lasius::tour
