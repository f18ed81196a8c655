// The draws and random words of eight ants at once, lane by lane against the scalar reference;
// their walks are walk_test's.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "kernels/base/cpu.h"
#include "kernels/base/random_stream.h"
#include "kernels/walk/walk.h"
#include "tests/kernels/base/instruction_sets.h"

#if defined(__x86_64__)

#include "kernels/walk/lockstep_draw.h"

namespace lasius::kernels {
namespace {

constexpr int kLanes = 8;

/// One draw of one ant.
struct Spin {
  alignas(32) std::array<float, 16> row{};
  std::uint32_t open = 0xff;
  std::array<std::uint32_t, 8> words{};  ///< a roulette reads the first
};
using Spins = std::array<Spin, kLanes>;

/// The three bits around an ant, as the planes give them: others may be anything.
template <int kMoves>
LockstepPlanes::Entered entered(const Spins& spins, std::uint32_t others) {
  alignas(32) PerAnt above, beside, below;
  for (int i = 0; i < kLanes; ++i) {
    const std::uint32_t closed = ~spins[i].open;
    if constexpr (kMoves == 4) {
      above[i] = (closed & 1) << 1 | (others & ~2u);
      beside[i] = (closed >> 1 & 1) | (closed & 4) | (others & ~5u);
      below[i] = (closed >> 3 & 1) << 1 | (others & ~2u);
    } else {
      above[i] = (closed & 7) | (others & ~7u);
      beside[i] = (closed >> 3 & 1) | (closed >> 4 & 1) << 2 | (others & ~5u);
      below[i] = (closed >> 5 & 7) | (others & ~7u);
    }
  }
  LockstepPlanes::Entered result;
  std::memcpy(&result.above, above.data(), sizeof(above));
  std::memcpy(&result.beside, beside.data(), sizeof(beside));
  std::memcpy(&result.below, below.data(), sizeof(below));
  return result;
}

/// The moves drawn, -1 for none.
template <int kMoves, bool kMixture, Draw kDraw>
LASIUS_AVX2 std::array<int, kLanes> draw(const WalkWorld& world, const Spins& spins,
                                         std::uint32_t others) {
  using DrawOf = LockstepDraw<kMoves, kMixture>;
  __m256 weight[DrawOf::kWeights];
  for (int k = 0; k < DrawOf::kWeights; ++k) {
    alignas(32) std::array<float, kLanes> weights;
    for (int i = 0; i < kLanes; ++i) weights[i] = spins[i].row[k];
    weight[k] = _mm256_load_ps(weights.data());
  }
  __m256i word[kMoves];
  for (int k = 0; k < kMoves; ++k) {
    alignas(32) PerAnt words;
    for (int i = 0; i < kLanes; ++i) words[i] = spins[i].words[k];
    word[k] = load(words);
  }
  const auto around = entered<kMoves>(spins, others);
  typename DrawOf::Choice choice;
  if constexpr (kDraw == Draw::discard) {
    choice = DrawOf::race(word, around, weight);
  } else {
    choice = DrawOf::roulette(world, word[0], around, weight);
  }
  alignas(32) PerAnt move, stuck;
  store(move, choice.move);
  store(stuck, choice.stuck);
  std::array<int, kLanes> result;
  for (int i = 0; i < kLanes; ++i) result[i] = stuck[i] != 0 ? -1 : static_cast<int>(move[i]);
  return result;
}

template <int kMoves, bool kMixture, Draw kDraw>
void expect_reference(const WalkWorld& world, const Spins& spins, const std::string& what) {
  const WalkShape shape{kMoves, kMixture, false, kDraw};
  const auto reference = walk_table(Isa::scalar).draw[shape.index()];
  for (const std::uint32_t others : {0u, ~0u}) {
    const auto moves = draw<kMoves, kMixture, kDraw>(world, spins, others);
    for (int i = 0; i < kLanes; ++i) {
      const Spin& s = spins[i];
      ASSERT_EQ(moves[i], reference(world, s.row.data(), s.open, kMaxMoves, s.words.data()))
          << what << ", ant " << i << ", open " << s.open << ", word " << s.words[0];
    }
  }
}

/// Of a CPU with AVX2; of others there are no tests.
class LockstepDraws : public testing::TestWithParam<Isa> {
 protected:
  std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
  /// Of so many moves. A move exists for both rules or for none.
  Spins any_spins(int moves) {
    constexpr std::array<std::uint32_t, 6> kEdges{0, ~0u, 0x20000000, 0x3fffffff, 0x7fffffff, 255};
    Spins spins;
    for (Spin& spin : spins) {
      spin.open = word() & (word() % 8 == 0 ? word() : ~0u) & ((1u << moves) - 1);
      for (int k = 0; k < moves; ++k) {
        spin.words[k] = word() % 16 == 0 ? kEdges[word() % kEdges.size()] : word();
        if (word() % 8 == 0) continue;
        for (float* weight : {&spin.row[k], &spin.row[k + moves]}) {
          *weight = word() % 8 == 0 ? 0x1p-60f : static_cast<float>(word()) * 0x1p-32f + 1e-6f;
        }
      }
    }
    return spins;
  }
  template <int kMoves>
  void expect_reference_of_all_draws() {
    WalkWorld wheel;  // shares 1/8 greedy, 1/8 pheromone, 1/4 distance, 1/2 combined
    wheel.rule_start = {0, 0x20000000, 0x40000000, 0x80000000};
    wheel.rule_scale = {0x1p-29f, 0x1p-29f, 0x1p-30f, 0x1p-31f};
    WalkWorld past = wheel;  // points past the last weight, as rounding may
    past.rule_scale = {0, 0x1p-28f, 0x1p-29f, 0x1p-30f};
    WalkWorld combined;
    for (int round = 0; round < 20000; ++round) {
      const Spins spins = any_spins(kMoves);
      for (const WalkWorld* world : std::array{&wheel, &past, &combined}) {
        expect_reference<kMoves, false, Draw::roulette>(*world, spins, "roulette");
        expect_reference<kMoves, true, Draw::roulette>(*world, spins, "mixture");
      }
      expect_reference<kMoves, false, Draw::discard>(combined, spins, "race");
    }
  }

  std::mt19937 random_{7};
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(LockstepDraws);
INSTANTIATE_TEST_SUITE_P(Walk, LockstepDraws,
                         testing::ValuesIn(supported_isa() < Isa::avx2 ? std::vector<Isa>{}
                                                                       : std::vector{Isa::avx2}),
                         by_isa);

TEST_P(LockstepDraws, EachLaneDrawsAsTheScalarReference) {
  expect_reference_of_all_draws<4>();
  expect_reference_of_all_draws<8>();
}

// The sum at the third of four moves, and at the fourth, whose weight is 0.
float at_third(float a, float b, float c) { return (c + b) + a; }
float at_fourth(float a, float b, float c) { return c + (b + a); }

TEST_P(LockstepDraws, RoundingNeverDrawsAMoveOfNoWeight) {
  const WalkWorld world;
  constexpr std::uint32_t kBelowOne = 0xffffff00;  // a share of 1 - 2^-24
  int found = 0;
  for (int round = 0; round < 20000 && found < 3 * kLanes; ++round) {
    const float a = static_cast<float>(word()), b = static_cast<float>(word());
    const float c = static_cast<float>(word()), fourth = at_fourth(a, b, c);
    const float threshold = 0x1.fffffep-1f * fourth;
    if (at_third(a, b, c) != threshold) continue;
    const std::array<Spin, 3> gaps = {{
        // The fourth sum passes, not the third; so do the next ones, but only the last has weight.
        {{a, b, c, 0, 0, 0, 0, 0x1p-60f}, 0xff, {kBelowOne}},
        {{a, b, c, 0, 0, 0, 0, 0}, 0xff, {kBelowOne}},
        {{0, 0, 0, 0, a, b, c, 0}, 0xff, {kBelowOne}},
    }};
    Spins spins = any_spins(8);
    Spin& spin = spins[found % kLanes];
    spin = gaps[found / kLanes];
    expect_reference<8, false, Draw::roulette>(world, spins, "gap");
    const int expected = std::array{7, 2, 6}[found / kLanes];
    EXPECT_EQ((draw<8, false, Draw::roulette>(world, spins, 0)[found % kLanes]), expected);
    // By two rules, whose product is the same.
    for (int k = 0; k < 8; ++k) spin.row[k + 8] = spin.row[k] > 0 ? 1.0f : 0.0f;
    expect_reference<8, true, Draw::roulette>(world, spins, "gap of a mixture");
    spin.row = {a, b, c, 0, 1, 1, 1, 0};
    expect_reference<4, false, Draw::roulette>(world, spins, "gap of four");
    expect_reference<4, true, Draw::roulette>(world, spins, "gap of four and a mixture");
    ++found;
  }
  EXPECT_EQ(found, 3 * kLanes);
}

LASIUS_AVX2 std::array<PerAnt, 4> blocks(const WalkWorld& world, const PerAnt& block,
                                         const PerAnt& ant) {
  __m256i words[4];
  philox(world, load(block), load(ant), words);
  alignas(32) std::array<PerAnt, 4> result;
  for (int w = 0; w < 4; ++w) store(result[w], words[w]);
  return result;
}

TEST_P(LockstepDraws, RandomWordsAreThoseOfPhilox) {
  for (int round = 0; round < 1000; ++round) {
    WalkWorld world;
    world.seed = std::uint64_t{word()} << 32 | word();
    world.iteration = word();
    alignas(32) PerAnt block, ant;
    for (int i = 0; i < kLanes; ++i) {
      block[i] = word();
      ant[i] = word();
    }
    const auto words = blocks(world, block, ant);
    for (int i = 0; i < kLanes; ++i) {
      const auto expected = random_words(world.seed, {block[i], ant[i], world.iteration, 0});
      for (int w = 0; w < 4; ++w) EXPECT_EQ(words[w][i], expected[w]) << "ant " << i;
    }
  }
}

}  // namespace
}  // namespace lasius::kernels

#endif
