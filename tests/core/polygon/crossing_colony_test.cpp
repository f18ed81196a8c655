// The ants' draws, updates and lengths against the formulas.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/polygon/crossing_run.h"
#include "kernels/base/proportional.h"
#include "kernels/base/random_stream.h"
#include "tests/core/polygon/known_world.h"

namespace lasius::polygon {
namespace {

/// The curve of mean lengths where ants cross one line, a draw an ant: the formulas as they stand.
std::vector<double> means_by_the_formulas(const std::vector<double>& lengths, const Params& p) {
  const int values = static_cast<int>(lengths.size());
  const double rho = 0.1, tau0 = p.initial_pheromone;
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
  // A wedge, and one line from its tip up; small, so that 1 / L is much beside tau0.
  World world = empty_world(4, 2);
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
      improved += result.curves.iterations > 5 ? 1 : 0;
      for (int q = 0; q < result.curves.iterations; ++q) {
        ASSERT_NEAR(result.curves.mean[q], means[q], 1e-12) << "iteration " << q;
      }
    }
  }
  EXPECT_GT(improved, 5);
}

TEST(Ants, BeginWithAShareOfDijkstrasPath) {
  const Planner planner(known_world());
  Params parameters("maklink-acs");
  parameters.routes = 1;
  const Result result = planner.plan({}, parameters);  // of 1 / (n L) for n lines
  ASSERT_GT(result.crossing.lines.size(), 1u);
  parameters.initial_pheromone =
      1 / (static_cast<double>(result.crossing.lines.size()) * result.dijkstra->length);
  EXPECT_EQ(planner.plan({}, parameters).curves.mean, result.curves.mean);
}

// Children of blend 1 are the other parent: nothing is shorter than the first generation's best.
TEST(Genes, AreAllBlended) {
  Params parameters("real-ga");
  parameters.iterations = 20;
  parameters.crossover = parameters.blend = 1;
  parameters.mutation = 0;
  parameters.routes = 1;
  const Result result = Planner(known_world()).plan({}, parameters);
  EXPECT_NEAR(result.curves.best.back(), result.curves.best.front(), 1e-9);
}

// Up to 64 values, lengths between lines come from a table.
TEST(Ants, MeasureAlikeWithAndWithoutATable) {
  const Planner planner(known_world());
  for (const int values : {64, 65}) {
    Params parameters("maklink-acs");
    parameters.values = values;
    const Result result = planner.plan({}, parameters);
    ASSERT_LT(result.length, result.dijkstra->length);
    EXPECT_NEAR(result.curves.best.back(), result.length, 1e-9) << values;
    for (const double mean : result.curves.mean) {
      EXPECT_GE(mean, result.discrete_optimum->length - 1e-9) << values;
    }
  }
}

// The lecture's world is lost, its figures are printed: Dijkstra's path 507.692 m, and over nine
// lines the best of 11 values 440.233 m, of 21 values 439.372 m, with their h. These nine lines in
// 200 m x 200 m are a reconstruction that has all of them.
TEST(Ants, FindThePrintedValuesOnReconstructedLines) {
  const double lines[9][4] = {
      {58.315, 117.688, 72.476, 155.909},  {107.772, 75.603, 77.397, 33.431},
      {135.364, 33.619, 104.248, 29.679},  {140.779, 37.856, 146.168, 12.14},
      {123.429, 121.427, 173.525, 79.731}, {178.006, 114.141, 123.373, 150.567},
      {155.601, 151.582, 194.71, 155.177}, {100.257, 186.499, 106.636, 185.553},
      {21.852, 181.074, 128.718, 133.969}};
  Route route;
  route.start.given = {15.628, 180.629};
  route.goal.given = {80.736, 122.075};
  for (const auto& line : lines) {
    Gate& gate = route.gates.emplace_back();
    gate.a = {line[0], line[1]};
    gate.b = {line[2], line[3]};
  }
  const Crossing dijkstra = cross_at(route, std::vector<double>(9, 0.5));
  EXPECT_NEAR(dijkstra.length, 507.692, 0.0005);
  RunControl control;
  control.observe = [](const Convergence&, const auto&) { return StopCondition::Cause::none; };
  struct Printed {
    std::vector<double> h;
    double length;
  };
  for (const auto& [h, length] : {Printed{{0.2, 0.1, 0, 0, 0.5, 0.5, 0, 1, 0.7}, 440.233},
                                  Printed{{0.2, 0.1, 0, 0, 0.5, 0.45, 0, 1, 0.65}, 439.372}}) {
    Params parameters("maklink-acs");
    parameters.values = length > 440 ? 11 : 21;
    const StopCondition never;
    Poller poller(never);
    const auto optimum = discrete_optimum(route, parameters.values, poller);
    ASSERT_TRUE(optimum);
    EXPECT_NEAR(optimum->length, length, 0.0005);
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(optimum->values[i], h[i], 1e-12);
    // The source's settings, and its stop, when all ants agree: with 15% of the choices drawn they
    // do not on nine lines, so all of NC = 200 iterations are done.
    parameters.iterations = 200;
    parameters.greedy = 0.85;
    parameters.initial_pheromone = 0.0002;
    parameters.agreement = 1;
    int found = 0;
    for (parameters.seed = 1; parameters.seed <= 30; ++parameters.seed) {
      const auto run = run_crossing_colony(route, dijkstra, parameters, control);
      EXPECT_EQ(run.curves.iterations, 200);
      found += run.best.values == optimum->values ? 1 : 0;
    }
    EXPECT_GE(found, 20);
  }
}

}  // namespace
}  // namespace lasius::polygon
