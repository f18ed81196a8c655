// The walk kernels against the rule that they state, and every instruction set against the scalar
// reference.
#include "kernels/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

namespace lasius::kernels {
namespace {

const WalkShape kShapes[] = {{4, false, false}, {4, false, true},  {4, true, false},
                             {4, true, true},   {8, false, false}, {8, false, true},
                             {8, true, false},  {8, true, true}};

std::string name(WalkShape s) {
  return std::to_string(s.lanes) + (s.mixture ? "mixture" : "single") + (s.factor ? "factor" : "");
}

/// A world whose rows are random and which is bounded by moves of weight 0.
class World {
 public:
  World(WalkShape shape, int width, int height, unsigned seed, double blocked = 0.2)
      : shape_(shape), width_(width), height_(height), random_(seed) {
    const Moves moves = moves_of(shape.lanes);
    const int tiles_x = (width + kTileSide - 1) / kTileSide;
    const int tiles_y = (height + kTileSide - 1) / kTileSide;
    const int row = shape.lanes * (shape.mixture ? 2 : 1);
    std::vector<char> open(static_cast<std::size_t>(width * height));
    for (auto& o : open) o = uniform() >= blocked;
    open.front() = open.back() = 1;
    storage_.resize(static_cast<std::size_t>(tiles_x * tiles_y * kTileCells * row) + 16, 0.0f);
    float* first = storage_.data();
    while (reinterpret_cast<std::uintptr_t>(first) % 64 != 0) ++first;
    for (int t = 0; t < tiles_x * tiles_y; ++t) tiles_.push_back(first + t * kTileCells * row);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        float* cell = tiles_[(y / kTileSide) * tiles_x + x / kTileSide] +
                      ((y % kTileSide) * kTileSide + x % kTileSide) * row;
        for (int k = 0; k < moves.count; ++k) {
          const int nx = x + moves.dx[k], ny = y + moves.dy[k];
          const bool inside = nx >= 0 && ny >= 0 && nx < width && ny < height;
          if (!inside || !open[ny * width + nx]) continue;
          cell[k] = static_cast<float>(uniform() + 1e-3);
          if (shape.mixture) cell[shape.lanes + k] = static_cast<float>(uniform() + 1e-3);
        }
      }
    }
    view.tiles = tiles_.data();
    view.tiles_x = tiles_x;
    for (int k = 0; k < moves.count; ++k) view.delta[k] = moves.dy[k] * 65536 + moves.dx[k];
    for (auto& factors : view.factor) {
      for (auto& f : factors) f = shape.factor ? static_cast<float>(uniform() + 0.1) : 1.0f;
    }
    view.rule_start = {0, 0x20000000, 0x60000000};
    view.rule_scale = {0x1p-29f, 0x1p-30f, 1.0f / static_cast<float>(0xa0000000)};
    view.start = pack(0, 0);
    view.goal = pack(width - 1, height - 1);
    view.seed = 77;
  }

  struct Walked {
    WalkState state;
    std::vector<std::uint8_t> moves;
    std::vector<PackedCell> dead;
    std::int64_t steps;
    friend bool operator==(const Walked&, const Walked&) = default;
  };

  /// Walks ants to their end, `together` at a time, `rounds` a call.
  std::vector<Walked> walk(Isa isa, int ants, int together, int rounds) {
    const auto cells = static_cast<std::size_t>(width_ * height_);
    const auto words = static_cast<std::size_t>(VisitedPlane::words_for(width_, height_));
    std::vector<Walked> result;
    for (int first = 0; first < ants; first += together) {
      const int count = std::min(together, ants - first);
      std::vector<WalkSlot> slots(count);
      std::vector<std::vector<std::uint64_t>> planes(count, std::vector<std::uint64_t>(words));
      std::vector<std::vector<std::uint8_t>> moves(count, std::vector<std::uint8_t>(2 * cells));
      std::vector<std::vector<PackedCell>> dead(count, std::vector<PackedCell>(2 * cells));
      for (int i = 0; i < count; ++i) {
        slots[i].at = view.start;
        slots[i].state = WalkState::walking;
        slots[i].ant = static_cast<std::uint32_t>(first + i);
        slots[i].moves = moves[i].data();
        slots[i].dead = dead[i].data();
        slots[i].visited = VisitedPlane::over(planes[i].data(), height_);
        slots[i].visited.mark(view.start);
      }
      const auto walking = [&] {
        return std::any_of(slots.begin(), slots.end(),
                           [](const WalkSlot& s) { return s.state == WalkState::walking; });
      };
      while (walking()) walk_table(isa).walk[shape_.index()](view, slots, rounds);
      for (int i = 0; i < count; ++i) {
        const WalkSlot& s = slots[i];
        result.push_back({s.state,
                          {moves[i].begin(), moves[i].begin() + s.move_count},
                          {dead[i].begin(), dead[i].begin() + s.dead_count},
                          s.steps()});
      }
    }
    return result;
  }

  WalkWorld view;

 private:
  double uniform() { return std::uniform_real_distribution<>(0, 1)(random_); }

  WalkShape shape_;
  int width_, height_;
  std::mt19937 random_;
  std::vector<float> storage_;
  std::vector<float*> tiles_;
};

class EveryIsa : public testing::TestWithParam<Isa> {
 protected:
  void SetUp() override {
    if (GetParam() > supported_isa()) GTEST_SKIP() << "this CPU lacks the instruction set";
  }
};
INSTANTIATE_TEST_SUITE_P(Walk, EveryIsa, testing::Values(Isa::scalar, Isa::avx2, Isa::avx512));

TEST_P(EveryIsa, DrawsAsTheScalarReferenceOnEveryMask) {
  std::mt19937 random(5);
  for (const WalkShape shape : kShapes) {
    World world(shape, 64, 64, 3);
    const auto reference = walk_table(Isa::scalar).draw[shape.index()];
    const auto draw = walk_table(GetParam()).draw[shape.index()];
    for (std::uint32_t open = 0; open < 1u << shape.lanes; ++open) {
      for (int i = 0; i < 40; ++i) {
        alignas(32) float row[16];
        for (float& w : row) {
          const auto r = random() % 8;
          w = r == 0 ? 0.0f : r == 1 ? 0x1p-60f : static_cast<float>(random()) * 0x1p-32f + 1e-6f;
        }
        for (int k = 0; k < shape.lanes; ++k) {  // a move exists for both rules or for none
          if (row[k] == 0) row[shape.lanes + k] = 0;
          if (row[shape.lanes + k] == 0) row[k] = 0;
        }
        const auto word = i == 0 ? 0u : i == 1 ? ~0u : static_cast<std::uint32_t>(random());
        const auto previous = static_cast<std::uint32_t>(random() % 9);
        EXPECT_EQ(draw(world.view, row, open, previous, word),
                  reference(world.view, row, open, previous, word))
            << name(shape) << " mask " << open << " word " << word;
      }
    }
  }
}

TEST_P(EveryIsa, DrawsEachMoveInProportionToItsWeight) {
  World world({8, false, false}, 64, 64, 3);
  alignas(32) const float row[8] = {1, 0, 2, 4, 0.5f, 0, 1, 3};
  const std::uint32_t open = 0b11011111;  // move 5 is tabu, move 1 does not exist
  const auto draw = walk_table(GetParam()).draw[WalkShape{8, false, false}.index()];
  std::array<int, 8> drawn{};
  constexpr int kDraws = 1 << 16;
  for (std::uint32_t i = 0; i < kDraws; ++i) ++drawn[draw(world.view, row, open, 8, i << 16)];
  // Words on a regular lattice: each count is exact but for the ends of its interval.
  const double total = 11.5;
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(drawn[k], row[k] / total * kDraws, 2) << k;
}

TEST_P(EveryIsa, MixesTheRulesAsTheirShares) {
  // Pheromone allows move 0 or 1 alike, distance prefers move 0 by 3 to 1.
  World world({4, true, false}, 64, 64, 3);
  alignas(32) const float row[8] = {1, 1, 0, 0, 0.75f, 0.25f, 0, 0};
  const auto draw = walk_table(GetParam()).draw[WalkShape{4, true, false}.index()];
  int first = 0;
  constexpr int kDraws = 1 << 16;
  for (std::uint32_t i = 0; i < kDraws; ++i) first += draw(world.view, row, 0xf, 8, i << 16) == 0;
  // Shares 1/8 pheromone, 2/8 distance, 5/8 combined.
  EXPECT_NEAR(first, (0.125 * 0.5 + 0.25 * 0.75 + 0.625 * 0.75) * kDraws, 4);
}

TEST_P(EveryIsa, WalksAsTheScalarReferenceHoweverManyTogether) {
  for (const WalkShape shape : kShapes) {
    World world(shape, 100, 70, 11);
    const auto reference = world.walk(Isa::scalar, 20, 1, 1000000);
    EXPECT_EQ(world.walk(GetParam(), 20, 1, 1), reference) << name(shape);
    EXPECT_EQ(world.walk(GetParam(), 20, 7, 13), reference) << name(shape);
    EXPECT_EQ(world.walk(GetParam(), 20, kMaxSlots, 128), reference) << name(shape);
  }
}

TEST_P(EveryIsa, NeverEntersACellTwiceAndEndsAtTheGoal) {
  for (const WalkShape shape : kShapes) {
    World world(shape, 90, 60, 2);
    int arrived = 0;
    for (const auto& ant : world.walk(GetParam(), 30, 8, 128)) {
      std::vector<char> entered(90 * 60);
      PackedCell at = world.view.start;
      const auto enter = [&](PackedCell c) {
        return entered[packed_y(c) * 90 + packed_x(c)]++ == 0;
      };
      EXPECT_TRUE(enter(at));
      for (const auto move : ant.moves) {
        at += static_cast<PackedCell>(world.view.delta[move]);
        ASSERT_TRUE(packed_x(at) < 90 && packed_y(at) < 60);
        EXPECT_TRUE(enter(at));
      }
      for (const auto c : ant.dead) EXPECT_TRUE(enter(c));
      EXPECT_EQ(at, ant.state == WalkState::arrived ? world.view.goal : world.view.start);
      EXPECT_EQ(ant.steps, static_cast<std::int64_t>(ant.moves.size() + 2 * ant.dead.size()) +
                               (ant.state == WalkState::lost));
      arrived += ant.state == WalkState::arrived;
    }
    EXPECT_GT(arrived, 0) << name(shape);
  }
}

TEST_P(EveryIsa, AKilledAntStopsAtItsFirstDeadEnd) {
  World world({4, false, false}, 64, 64, 9);
  world.view.backtrack = false;
  int lost = 0;
  for (const auto& ant : world.walk(GetParam(), 50, 8, 128)) {
    EXPECT_TRUE(ant.dead.empty());
    lost += ant.state == WalkState::lost;
  }
  EXPECT_GT(lost, 0);
}

TEST(VisitedPlane, MarksWhatItsWindowsSee) {
  constexpr int kWidth = 100, kHeight = 5;
  std::vector<std::uint64_t> words(VisitedPlane::words_for(kWidth, kHeight));
  const auto plane = VisitedPlane::over(words.data(), kHeight);
  for (int x = 0; x < kWidth; ++x) {
    plane.mark(pack(x, 2));
    for (int from = std::max(0, x - 16); from < std::min(kWidth, x + 16); ++from) {
      const PackedCell c = pack(from, 2);
      const int bit = VisitedPlane::bit(c) + x - from;
      if (bit < 0 || bit > 63) continue;
      EXPECT_EQ(*plane.word(c) >> bit & 1, 1u) << x << " seen from " << from;
    }
    plane.clear(pack(x, 2));
    EXPECT_EQ(words, std::vector<std::uint64_t>(words.size())) << x;
  }
}

TEST(Moves, StandInScanOrder) {
  const Moves four = moves_of(4), eight = moves_of(8);
  EXPECT_EQ(four.count, 4);
  EXPECT_EQ(eight.count, 8);
  const std::array<std::pair<int, int>, 8> expected{
      {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
  for (int k = 0; k < 8; ++k) {
    EXPECT_EQ(std::pair(int{eight.dx[k]}, int{eight.dy[k]}), expected[k]);
  }
}

}  // namespace
}  // namespace lasius::kernels
