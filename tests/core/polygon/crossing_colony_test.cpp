// The ants' draws, updates and lengths against the formulas.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "kernels/base/proportional.h"
#include "kernels/base/random_stream.h"
#include "tests/core/polygon/known_world.h"

namespace lasius::polygon {
namespace {

/// The curve of mean lengths where ants cross one line, a draw an ant: the formulas as they stand.
std::vector<double> means_by_the_formulas(const std::vector<double>& lengths, const Params& p) {
  const int values = static_cast<int>(lengths.size());
  const double rho = p.evaporation, tau0 = p.initial_pheromone;
  std::vector<double> tau(lengths.size(), tau0), weights(lengths.size()), means;
  const auto h = [&](int k) { return static_cast<double>(k) / (values - 1); };
  double best_h = 0.5;  // Dijkstra's
  int best_so_far = -1;
  for (int q = 0; q < p.iterations; ++q) {
    double sum = 0;
    int best = -1;
    for (int a = 0; a < p.ants; ++a) {
      for (int k = 0; k < values; ++k) {
        weights[k] = tau[k] * std::pow((1.1 - std::abs(h(k) - best_h)) / 1.1, p.beta);
      }
      kernels::RandomStream words(p.seed, static_cast<std::uint32_t>(a),
                                  static_cast<std::uint32_t>(q));
      const int k = kernels::proportional_choice(weights, p.greedy, words.next());
      tau[k] = (1 - rho) * tau[k] + rho * tau0;
      sum += lengths[k];
      if (best < 0 || lengths[k] < lengths[best]) best = k;
    }
    if (best_so_far < 0 || lengths[best] < lengths[best_so_far]) best_so_far = best;
    best_h = h(best_so_far);
    const int deposits = p.global_best == GlobalBest::iteration ? best : best_so_far;
    tau[deposits] = (1 - rho) * tau[deposits] + rho / lengths[deposits];
    means.push_back(sum / p.ants);
  }
  return means;
}

TEST(Ants, DrawAndUpdateByTheFormulas) {
  World world;  // a wedge, and one line from its tip up; small, so that 1 / L is much beside tau0
  world.boundary.outer = {{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  world.obstacles = {{{{1.8, 0}, {2.2, 0}, {2, 1}}, {}}};
  const Point start{0.5, 0.5}, goal{3.5, 0.3};
  const Planner planner(world);
  Params parameters("maklink-acs");
  parameters.initial_pheromone = 0.2;
  parameters.ants = 3;
  parameters.values = 41;
  parameters.iterations = 30;
  parameters.agreement = 0;
  parameters.greedy = 0.1;
  parameters.routes = 1;
  int improved = 0;
  for (const GlobalBest global_best : {GlobalBest::so_far, GlobalBest::iteration}) {
    parameters.global_best = global_best;
    for (parameters.seed = 1; parameters.seed <= 40; ++parameters.seed) {
      const Result result = planner.plan({.start = start, .goal = goal}, parameters);
      ASSERT_EQ(result.crossing.lines.size(), 1u);
      const Line& line = planner.maklink().lines[result.crossing.lines[0]];
      std::vector<double> lengths;
      for (int k = 0; k < parameters.values; ++k) {
        const double h = k / 40.0;
        const Point p{line.a.x + h * (line.b.x - line.a.x), line.a.y + h * (line.b.y - line.a.y)};
        lengths.push_back(std::hypot(p.x - start.x, p.y - start.y) +
                          std::hypot(goal.x - p.x, goal.y - p.y));
      }
      const auto means = means_by_the_formulas(lengths, parameters);
      // The run ends at the shortest path of all, over the wedge's tip.
      improved += result.iterations > 5 ? 1 : 0;
      for (int q = 0; q < result.iterations; ++q) {
        ASSERT_NEAR(result.mean[q], means[q], 1e-12) << "iteration " << q;
      }
    }
  }
  EXPECT_GT(improved, 5);
}

// Up to 64 values, lengths between lines come from a table.
TEST(Ants, MeasureAlikeWithAndWithoutATable) {
  const Planner planner(known_world());
  for (const int values : {64, 65}) {
    Params parameters("maklink-acs");
    parameters.values = values;
    const Result result = planner.plan({}, parameters);
    ASSERT_LT(result.length, result.dijkstra->length);
    EXPECT_NEAR(result.best.back(), result.length, 1e-9) << values;
    for (const double mean : result.mean) {
      EXPECT_GE(mean, result.discrete_optimum->length - 1e-9) << values;
    }
  }
}

}  // namespace
}  // namespace lasius::polygon
