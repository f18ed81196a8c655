// Proofs of bounds: those of searches hold, those in which one number is changed do not.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/cost/cost_search.h"
#include "lasius/cost/proof.h"
#include "tests/worlds/weights.h"

namespace lasius {
namespace {

CostProof proof_of(const WeightedWorld& world, double target_gap = 0) {
  const cost::Terrain terrain(world.grid, world.costs);
  cost::CostSearch search;
  cost::CostAnswer answer;
  CostProof proof{.start = world.start,
                  .goal = world.goal,
                  .map_hash = world.grid.hash(),
                  .costs_hash = world.costs.hash()};
  search.search(terrain, {world.start, world.goal}, {.target_gap = target_gap}, {}, answer,
                &proof.levels);
  proof.lower_bound = answer.lower_bound;
  return proof;
}

std::string fault_of(const WeightedWorld& world, const CostProof& proof) {
  return check_proof(world.grid, world.costs, proof).value_or("");
}

TEST(CostProof, ThoseOfSearchesHold) {
  std::mt19937 random(11);
  constexpr double kTargets[] = {0, 0.02, 0.01, 1e-4};
  int levels = 0;
  for (int i = 0; i < 500; ++i) {
    const bool large = i % 10 == 0;
    const WeightedWorld world = random_weights(random, large ? 30 : 4, large ? 60 : 12);
    const CostProof proof = proof_of(world, kTargets[i % 4]);
    EXPECT_EQ(fault_of(world, proof), "") << i;
    EXPECT_GT(proof.lower_bound, 0) << i;
    levels += static_cast<int>(proof.levels.size());
  }
  EXPECT_GT(levels, 1000);
}

TEST(CostProof, OneChangedNumberIsRefused) {
  std::mt19937 random(12);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int changed = 0;
  for (int i = 0; changed < 500; ++i) {
    WeightedWorld world = random_weights(random, 4, 14);
    CostProof proof = proof_of(world);
    const double least = world.costs.range(world.grid).least;
    if (proof.levels.empty()) continue;  // the straight way's bound
    ++changed;
    CostProof::Level& level = proof.levels[below(proof.levels.size())];
    switch (changed % 10) {
      case 0:  // by more than the search and the check differ by rounding
        proof.lower_bound *= 1 + 1e-8;
        break;
      case 1:
        proof.lower_bound = std::numeric_limits<double>::quiet_NaN();
        break;
      case 2:  // Blocks are often alike: one that moved may prove as much. Not so their number.
        level.runs[3 * below(level.runs.size() / 3) + (level.block > 1 ? 2 : below(3))] +=
            below(2) == 0 ? 1 : -1;
        break;
      case 3:
        level.values.erase(level.values.begin() +
                           static_cast<std::ptrdiff_t>(below(level.values.size())));
        break;
      case 4: {
        std::vector<double> weights(world.costs.weights().begin(), world.costs.weights().end());
        weights[below(weights.size())] *= 0.999;
        world.costs = CostField(world.grid.width(), world.grid.height(), weights);
        break;
      }
      case 5:
        world.grid.set_blocked(world.start, true);
        break;
      case 6:
        level.intervals *= 2;
        break;
      default: {  // no chord is so dear as this
        const double most = 2 * world.costs.range(world.grid).most * level.block;
        level.values[below(level.values.size())] += most + least;
      }
    }
    EXPECT_NE(fault_of(world, proof), "") << i;
  }
}

// Who writes the hash of the costs anew has to answer for chords.
TEST(CostProof, CheaperCellsAreRefusedByTheirChords) {
  std::mt19937 random(13);
  for (int i = 0; i < 50; ++i) {
    WeightedWorld world = random_weights(random, 6, 12);
    CostProof proof = proof_of(world);
    std::vector<double> weights(world.costs.weights().begin(), world.costs.weights().end());
    for (double& weight : weights) weight *= 0.9;
    world.costs = CostField(world.grid.width(), world.grid.height(), weights);
    EXPECT_EQ(fault_of(world, proof), "the proof is of other costs");
    proof.costs_hash = world.costs.hash();
    const std::string fault = proof.levels.empty() ? "the bound is " : "level 0: ";
    EXPECT_EQ(fault_of(world, proof).substr(0, fault.size()), fault);
  }
}

// A level of the row above a wall alone: the cheapest path leaves it at the wall's corner.
TEST(CostProof, AWayOutAtACornerCounts) {
  const Grid grid = drawn({".......", "####...", "####...", "......."});
  const WeightedWorld world{grid, CostField(7, 4), {0, 0}, {0, 3}};
  CostProof proof = proof_of(world);
  if (!proof.levels.back().from_start) proof.levels.pop_back();
  ASSERT_GT(proof.levels.size(), 2U);
  CostProof::Level& level = proof.levels.back();
  const int k = level.intervals;
  level.runs.resize(3);
  level.values.resize(4 * k + (level.runs[2] - 1) * (3 * k - 1));
  proof.lower_bound = 1.001 * (2 * std::hypot(3.5, 0.5) + 2);
  EXPECT_EQ(fault_of(world, proof).find("the bound is "), 0U) << fault_of(world, proof);
}

TEST(CostProof, WithoutLevelsTheStraightWayIsProven) {
  const Grid grid(20, 10);
  const WeightedWorld world{grid, CostField(20, 10), {1, 2}, {13, 7}};
  CostProof proof = proof_of(world);
  proof.levels.clear();
  proof.lower_bound = 12.99;
  EXPECT_EQ(fault_of(world, proof), "");
  proof.lower_bound = 13.01;
  EXPECT_EQ(fault_of(world, proof).find("the bound is 13.01, the levels prove 12.99"), 0U);
}

}  // namespace
}  // namespace lasius
