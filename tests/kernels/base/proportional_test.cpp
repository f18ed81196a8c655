#include "kernels/base/proportional.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "kernels/base/random_stream.h"

namespace lasius::kernels {
namespace {

constexpr std::uint32_t share(double of_wheel) {
  return static_cast<std::uint32_t>(of_wheel * 0x1p32);
}

/// A word, and the choice that it makes.
using Choices = std::initializer_list<std::pair<std::uint32_t, int>>;

void expect_choices(const std::array<double, 4>& weights, double greedy, const Choices& choices) {
  for (const auto& [word, choice] : choices)
    EXPECT_EQ(proportional_choice(weights, greedy, word), choice) << word;
}

TEST(Proportional, SharesOfTheWheelByHand) {
  // Shares 1/8, none, 3/8, 4/8.
  expect_choices({1, 0, 3, 4}, 0,
                 {{0, 0},
                  {share(0.124), 0},
                  {share(0.125), 2},
                  {share(0.499), 2},
                  {share(0.5), 3},
                  {0xffffffff, 3}});
}

TEST(Proportional, TheGreedyShareTakesTheLargest) {
  // q0 = 0.5: words below one half are greedy, the others are spread over the wheel.
  const std::array<double, 4> weights{1, 4, 4, 1};
  expect_choices(weights, 0.5, {{0, 1}, {share(0.499), 1}, {share(0.5), 0}, {share(0.96), 3}});
  expect_choices(weights, 1, {{0xffffffff, 1}});
}

TEST(Proportional, NothingOpen) {
  EXPECT_EQ(proportional_choice({}, 0, 5), -1);
  EXPECT_EQ(proportional_choice({}, 1, 5), -1);
  const std::array<double, 2> closed{0, 0};
  EXPECT_EQ(proportional_choice(closed, 0, 5), -1);
  EXPECT_EQ(proportional_choice(closed, 1, 5), -1);
}

TEST(Proportional, FrequenciesFollowTheWeights) {
  const std::array<double, 3> weights{0.2, 0.3, 0.5};
  std::array<int, 3> count{};
  RandomStream random(7, 3, 11);
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) ++count[proportional_choice(weights, 0, random.next())];
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double deviation = std::sqrt(kDraws * weights[k] * (1 - weights[k]));
    EXPECT_NEAR(count[k], kDraws * weights[k], 4 * deviation);
  }
}

}  // namespace
}  // namespace lasius::kernels
