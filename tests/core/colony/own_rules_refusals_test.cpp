// What a caller's own rules may not be.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lasius/params/own_rules.h"
#include "lasius/plan/batch.h"
#include "tests/core/base/refusal.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

/// What a plan is refused with, and a batch.
std::string refusal_of(const Planner& planner, const Params& params, const OwnRules& own) {
  const std::vector<Request> requests{{.start = {0, 0}, .goal = {4, 3}}};
  const auto plan = refusal([&] { (void)planner.plan(requests[0], params, {.own_rules = own}); });
  const auto batch = refusal([&] { (void)plan_batch(planner, requests, params, {}, own); });
  EXPECT_EQ(plan, batch);
  return plan;
}

TEST(OwnRules, ATableThatIsWrongIsRefused) {
  Grid grid(5, 4);
  grid.set_blocked({2, 1});
  const Planner planner(grid);
  const Params params = quick("ras");  // eight moves
  const auto of = [&](std::vector<double> table) {
    return refusal_of(planner, params, {.heuristic = table});
  };
  const auto with = [](int size, int at, double value) {
    std::vector<double> table(size, 1);
    table[at] = value;
    return table;
  };
  expect_says(of(std::vector<double>(19, 1)), "19 values");
  expect_says(of(std::vector<double>(19, 1)), "20, one a cell");
  expect_says(of(std::vector<double>(19, 1)), "160, one a move");
  EXPECT_EQ(of(std::vector<double>(20, 1)), "accepted");
  EXPECT_EQ(of(std::vector<double>(160, 1)), "accepted");
  expect_says(of(with(20, 9, std::nan(""))), "heuristic[9], of cell (4, 1), is nan");
  expect_says(of(with(20, 0, -1)), "heuristic[0], of cell (0, 0), is -1");
  expect_says(of(with(20, 19, 1e16)), "heuristic[19], of cell (4, 3), is 1e+16");
  EXPECT_EQ(of(with(20, 7, std::nan(""))), "accepted");   // blocked
  EXPECT_EQ(of(with(160, 0, std::nan(""))), "accepted");  // out of the map
  EXPECT_EQ(of(with(160, 8 * 6 + 4, -1)), "accepted");    // from (1, 1) to the blocked cell
  expect_says(of(with(160, 8 * 6 + 3, -1)), "heuristic[51], of cell (1, 1)");
}

TEST(OwnRules, WhatDoesNotComposeIsRefused) {
  const Planner planner(Grid(5, 4));
  const OwnRules update{.update = [](Pheromone&, const IterationTours&) {}};
  const std::vector<double> ones(20, 1);
  const OwnRules heuristic{.heuristic = ones};
  expect_says(refusal_of(planner, Params("exact"), update), "exact is no colony");
  expect_says(refusal_of(planner, quick("grid-ga"), heuristic), "grid-ga is no colony");
  expect_says(refusal_of(planner, quick("terminal-index"), update),
              "the terminal index is no pheromone");
  expect_says(refusal_of(planner, quick("cong2009"), heuristic), "the ants learn theirs");
  Params bad = quick("ras");
  bad.ants = 0;
  expect_says(refusal_of(planner, bad, update), "ants is 0");
}

TEST(OwnRules, AScheduleOutOfRangeIsRefused) {
  const Planner planner(Grid(5, 4));
  const auto of = [&](const StepWeights& weights, const char* algorithm = "ras") {
    const OwnRules own{.schedule = [&](int q) { return q < 2 ? StepWeights{} : weights; }};
    return refusal_of(planner, quick(algorithm), own);
  };
  expect_says(of({.alpha = std::nan("")}), "alpha of the own schedule at iteration 2 is nan");
  expect_says(of({.beta = -0.5}), "beta of the own schedule at iteration 2");
  expect_says(of({.beta = 20.5}), "it must be 0 .. 20");
  expect_says(of({.greedy = 1.5}), "greedy");
  expect_says(of({.combined_rule = 0}), "every rule's share");
  expect_says(of({.pheromone_rule = 0.5}), "pheromone_rule of the own schedule");
  expect_says(of({.distance_rule = 0.5}), "of the parameters a share above 0");
  EXPECT_EQ(of({.distance_rule = 0.5}, "fan2004"), "accepted");
  expect_says(of({.distance_rule = -1}, "fan2004"), "distance_rule");
}

}  // namespace
}  // namespace lasius
