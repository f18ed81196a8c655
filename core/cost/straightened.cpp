#include "core/cost/straightened.h"

#include "core/cost/path_cost.h"

namespace lasius::cost {

std::vector<Leg> straightened(const Terrain& terrain, std::span<const Cell> walk) {
  const auto weight = [&](int x, int y) { return terrain.weight(x, y); };
  std::vector<double> sum(walk.size());  // what the walk costs up to a cell
  for (std::size_t i = 1; i < walk.size(); ++i) {
    PathCost move(weight);
    sum[i] = sum[i - 1] + (move.add(centre(walk[i - 1]), centre(walk[i])) ? move.sum() : kInfinity);
  }
  const auto no_dearer = [&](std::size_t from, std::size_t to) {
    PathCost straight(weight);
    return straight.add(centre(walk[from]), centre(walk[to])) &&
           straight.sum() <= (sum[to] - sum[from]) * (1 + 1e-12);
  };
  std::vector<Leg> legs;
  const auto add = [&](Cell cell, Point to) { legs.push_back({cell, to}); };
  for (std::size_t at = 0; at + 1 < walk.size();) {
    std::size_t step = 1;
    while (at + 2 * step < walk.size() && no_dearer(at, at + 2 * step)) step *= 2;
    for (std::size_t more = step / 2; more > 0; more /= 2)
      if (at + step + more < walk.size() && no_dearer(at, at + step + more)) step += more;
    PathCost pieces(weight, add);
    pieces.add(centre(walk[at]), centre(walk[at + step]));
    at += step;
  }
  return legs;
}

}  // namespace lasius::cost
