// The draws of the walk kernels against the probabilities that they state, and every instruction
// set against the scalar reference.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "kernels/walk/walk.h"
#include "tests/kernels/walk/walk_cases.h"

namespace lasius::kernels {
namespace {

/// Shares 1/8 greedy, 1/8 pheromone, 1/4 distance, 1/2 combined; factors of 1, or random ones.
WalkWorld wheel(bool factor) {
  WalkWorld world;
  world.rule_start = {0, 0x20000000, 0x40000000, 0x80000000};
  world.rule_scale = {0x1p-29f, 0x1p-29f, 0x1p-30f, 0x1p-31f};
  std::mt19937 random(3);
  for (auto& factors : world.factor) {
    for (auto& f : factors) f = factor ? static_cast<float>(random()) * 0x1p-32f + 0.1f : 1.0f;
  }
  return world;
}

class EveryDraw : public testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(Walk, EveryDraw, testing::ValuesIn(walk_isas()), by_isa);

TEST_P(EveryDraw, DrawsAsTheScalarReferenceOnEveryMask) {
  std::mt19937 random(5);
  for (const WalkShape shape : all_shapes()) {
    const WalkWorld world = wheel(shape.factor);
    const auto reference = walk_table(Isa::scalar).draw[shape.index()];
    const auto draw = walk_table(GetParam()).draw[shape.index()];
    const std::uint32_t all = ~std::uint32_t{0} >> (32 - shape.lanes);
    for (std::uint32_t i = 0; i < 20000; ++i) {  // masks of up to 8 moves are all among them
      const std::uint32_t open =
          (shape.lanes <= 8 ? i : static_cast<std::uint32_t>(random())) & all;
      alignas(32) float row[64];
      for (float& w : row) {
        const auto r = random() % 8;
        w = r == 0 ? 0.0f : r == 1 ? 0x1p-60f : static_cast<float>(random()) * 0x1p-32f + 1e-6f;
      }
      for (int k = 0; k < shape.lanes; ++k) {  // a move exists for both rules or for none
        if (row[k] == 0) row[shape.lanes + k] = 0;
        if (row[shape.lanes + k] == 0) row[k] = 0;
      }
      std::array<std::uint32_t, kMaxMoves> words;
      for (auto& word : words) {
        word = i % 40 == 0 ? 0u : i % 40 == 1 ? ~0u : static_cast<std::uint32_t>(random());
      }
      const auto previous = static_cast<std::uint32_t>(random() % (shape.lanes + 1u));
      ASSERT_EQ(draw(world, row, open, previous, words.data()),
                reference(world, row, open, previous, words.data()))
          << name(shape) << " mask " << open << " word " << words[0];
    }
  }
}

TEST_P(EveryDraw, RouletteDrawsEachMoveInProportionToItsWeight) {
  const WalkShape shape{8, false, false, Draw::roulette};
  const WalkWorld world;  // the product alone
  alignas(32) const float row[8] = {1, 0, 2, 4, 0.5f, 0, 1, 3};
  const std::uint32_t open = 0b11011111;  // move 5 is tabu, move 1 does not exist
  const auto draw = walk_table(GetParam()).draw[shape.index()];
  std::array<int, 8> drawn{};
  constexpr std::uint32_t kDraws = 1 << 16;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const std::uint32_t word = i << 16;
    ++drawn[draw(world, row, open, kMaxMoves, &word)];
  }
  // Words on a regular lattice: each count is exact but for the ends of its interval.
  const double total = 11.5;
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(drawn[k], row[k] / total * kDraws, 2) << k;
}

TEST_P(EveryDraw, MixesTheRulesAsTheirShares) {
  // Pheromone allows move 0 or 1 alike; distance, greedy rule and product prefer move 0, by 3 to 1.
  const WalkShape shape{4, true, false, Draw::roulette};
  const WalkWorld world = wheel(false);
  alignas(32) const float row[8] = {1, 1, 0, 0, 0.75f, 0.25f, 0, 0};
  const auto draw = walk_table(GetParam()).draw[shape.index()];
  int first = 0;
  constexpr std::uint32_t kDraws = 1 << 16;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const std::uint32_t word = i << 16;
    first += draw(world, row, 0xf, kMaxMoves, &word) == 0;
  }
  EXPECT_NEAR(first, (0.125 * 1 + 0.125 * 0.5 + 0.25 * 0.75 + 0.5 * 0.75) * kDraws, 4);
}

TEST_P(EveryDraw, DiscardLeavesAMoveAsOftenAsSuccessiveDiscardsWould) {
  // Weights 1, 2, 3: move 0 is left with probability P(discard 2 then 1) + P(discard 1 then 2) =
  // 3/6 * 2/3 + 2/6 * 3/4 = 7/12; move 1: 3/6 * 1/3 + 1/6 * 3/5 = 4/15; move 2: 3/20.
  const WalkShape shape{4, false, false, Draw::discard};
  const WalkWorld world;
  alignas(32) const float row[4] = {1, 1.0f / 2, 1.0f / 3, 1.0f / 5};
  const auto draw = walk_table(GetParam()).draw[shape.index()];
  std::array<int, 4> left{};
  std::mt19937 random(1);
  constexpr int kDraws = 400000;
  for (int i = 0; i < kDraws; ++i) {
    std::array<std::uint32_t, 4> words;
    for (auto& word : words) word = static_cast<std::uint32_t>(random());
    ++left[draw(world, row, 0b0111, kMaxMoves, words.data())];
  }
  // Five standard errors of a share near a half.
  const double tolerance = 5 * std::sqrt(0.25 / kDraws);
  EXPECT_NEAR(left[0] / double{kDraws}, 7.0 / 12, tolerance);
  EXPECT_NEAR(left[1] / double{kDraws}, 4.0 / 15, tolerance);
  EXPECT_NEAR(left[2] / double{kDraws}, 3.0 / 20, tolerance);
  EXPECT_EQ(left[3], 0);
}

// Of two like moves the one with half the factor is drawn once in three.
TEST_P(EveryDraw, AFactorMakesAMoveLikelierInEitherDraw) {
  for (const Draw kind : {Draw::roulette, Draw::discard}) {
    const WalkShape shape{4, false, true, kind};
    WalkWorld world;
    world.factor[kMaxMoves] = {1, 0.5f, 1, 1};
    alignas(32) const float row[4] = {1, 1, 0, 0};
    const auto draw = walk_table(GetParam()).draw[shape.index()];
    std::mt19937 random(1);
    constexpr int kDraws = 1 << 17;
    int second = 0;
    for (int i = 0; i < kDraws; ++i) {
      std::array<std::uint32_t, 4> numbers;
      for (auto& n : numbers) n = static_cast<std::uint32_t>(random());
      second += draw(world, row, 0xf, kMaxMoves, numbers.data()) == 1;
    }
    EXPECT_NEAR(second, kDraws / 3.0, 5 * std::sqrt(kDraws / 3.0)) << name(shape);
  }
}

// Moves 1 and 5, or 0 to 7 but 3, whose numbers share words.
TEST_P(EveryDraw, DiscardOfMovesThatShareWordsLeavesEachAsOftenAsItShould) {
  const WalkShape shape{8, false, false, Draw::discard};
  const WalkWorld world;
  alignas(32) std::array<float, 8> row;
  for (int k = 0; k < 8; ++k) row[k] = 1.0f / static_cast<float>(1 << k);
  const auto draw = walk_table(GetParam()).draw[shape.index()];
  std::array<std::uint32_t, 8> numbers;
  constexpr int kDraws = 1 << 19;
  std::array<int, 8> left_of_two{}, left_of_seven{};
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    for (std::uint32_t k = 0; k < 8; ++k) numbers[k] = number_of(world, shape.draw, i, k);
    ++left_of_two[draw(world, row.data(), 0b00100010, kMaxMoves, numbers.data())];
    ++left_of_seven[draw(world, row.data(), 0b11110111, kMaxMoves, numbers.data())];
  }
  const auto expect = [&](int left, double share) {
    EXPECT_NEAR(left, share * kDraws, 5 * std::sqrt(share * kDraws));
  };
  expect(left_of_two[5], 2.0 / (2 + 32));
  // The last of all, by every subset of those that may outlast it.
  for (int k = 0; k < 8; ++k) {
    if (k == 3) continue;
    double share = 0;
    for (int others = 0; others < 256; ++others) {
      if ((others >> 3 & 1) != 0 || (others >> k & 1) != 0) continue;
      const double own = 1 << k;
      share +=
          (std::popcount(static_cast<unsigned>(others)) % 2 == 0 ? 1 : -1) * own / (own + others);
    }
    expect(left_of_seven[k], share);
  }
}

}  // namespace
}  // namespace lasius::kernels
