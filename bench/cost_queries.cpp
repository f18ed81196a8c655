#include "bench/cost_queries.h"

#include <cmath>
#include <random>

#include "lasius/base/error.h"

namespace lasius::bench {
namespace {

/// 0 to 1, by its place and a number.
double random_at(int x, int y, std::uint64_t number) {
  std::uint64_t bits = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15 ^
                       static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4f ^
                       number * 0x165667b19e3779f9;
  bits = (bits ^ bits >> 29) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ bits >> 32) * 0x94d049bb133111eb;
  return static_cast<double>((bits ^ bits >> 29) >> 11) * 0x1p-53;
}

/// The same between whole places, smoothly.
double smooth_at(double x, double y, std::uint64_t number) {
  const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
  const auto ease = [](double t) { return t * t * (3 - 2 * t); };
  const double fx = ease(x - left), fy = ease(y - top);
  const auto row = [&](int at) {
    return random_at(left, at, number) * (1 - fx) + random_at(left + 1, at, number) * fx;
  };
  return row(top) * (1 - fy) + row(top + 1) * fy;
}

double weight_at(int x, int y, const std::string& kind) {
  if (kind == "checker") return 1 + std::floor(10 * random_at(x / 24, y / 24, 3));
  if (kind == "white") return 1 + 8 * random_at(x, y, 5);
  return 1 + 4 * (0.5 * smooth_at(x / 32.0, y / 32.0, 7) + 0.3 * smooth_at(x / 12.0, y / 12.0, 8) +
                  0.2 * smooth_at(x / 5.0, y / 5.0, 9));
}

/// Steps from a cell, along axes; -1 where it does not lead, or is blocked.
std::vector<int> steps_from(const Grid& grid, Cell from, std::vector<Cell>& order) {
  const auto at = [&](Cell c) { return static_cast<std::size_t>(c.y) * grid.width() + c.x; };
  std::vector<int> steps(static_cast<std::size_t>(grid.width()) * grid.height(), -1);
  order.assign(1, from);
  steps[at(from)] = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Cell c = order[i];
    for (const Cell next :
         {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}}) {
      if (!grid.free(next) || steps[at(next)] >= 0) continue;
      steps[at(next)] = steps[at(c)] + 1;
      order.push_back(next);
    }
  }
  return steps;
}

}  // namespace

CostField make_weights(const Grid& grid, const std::string& kind) {
  if (kind == "inflation") {
    CostField field(grid.width(), grid.height());
    field.add(grid, Inflation{.radius = 20, .scaling = 0.5, .weight = 4, .inscribed = 1});
    return field;
  }
  std::vector<double> weights;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) weights.push_back(weight_at(x, y, kind));
  }
  return {grid.width(), grid.height(), weights};
}

std::vector<Query> long_queries(const Grid& grid, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  std::vector<Query> queries;
  std::vector<Cell> order;
  const std::int64_t least = grid.count_free() / 4;
  for (int tries = 0; queries.size() < count; ++tries) {
    if (tries == 100'000) {
      throw Error(ErrorCode::invalid_parameter, "no cell leads to a quarter of the free ones",
                  "use another map");
    }
    const Cell start{static_cast<int>(below(static_cast<std::size_t>(grid.width()))),
                     static_cast<int>(below(static_cast<std::size_t>(grid.height())))};
    if (grid.blocked(start)) continue;
    const std::vector<int> steps = steps_from(grid, start, order);
    if (order.size() < 2 || static_cast<std::int64_t>(order.size()) < least) continue;
    const auto many = [&](Cell c) {
      return steps[static_cast<std::size_t>(c.y) * grid.width() + c.x];
    };
    const int most = many(order.back());
    Cell goal = start;
    while (many(goal) < 0.6 * most) goal = order[below(order.size())];
    queries.push_back({start, goal});
  }
  return queries;
}

}  // namespace lasius::bench
