// The known world, and what holds for every result.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "lasius/polygon/plan.h"
#include "tests/worlds/random_world.h"

namespace lasius::polygon {

/// Four obstacles in a square of 200, all of whose lengths are known.
inline World known_world() {
  World world = empty_world(200, 200, Point{20, 180}, Point{160, 90});
  world.obstacles = {{{{40, 140}, {60, 160}, {100, 140}, {60, 120}}, {}},
                     {{{50, 30}, {30, 40}, {80, 80}, {100, 40}}, {}},
                     {{{120, 160}, {140, 100}, {180, 170}, {165, 180}}, {}},
                     {{{120, 40}, {170, 40}, {140, 80}}, {}}};
  return world;
}

/// Bounds, optima and lengths of a result are in the order that their definitions give.
inline void expect_order(const Result& result, const std::string& which) {
  ASSERT_FALSE(result.path.empty()) << which;
  constexpr double kSlack = 1 + 1e-12;
  EXPECT_LE(*result.lower_bound, result.sequence_optimum->length * kSlack) << which;
  EXPECT_LE(result.sequence_optimum->length, result.discrete_optimum->length * kSlack) << which;
  EXPECT_LE(result.length, result.dijkstra->length * kSlack) << which;
}

}  // namespace lasius::polygon
