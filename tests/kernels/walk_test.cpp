// The walk kernels against the rule that they state, and every instruction set against the scalar
// reference.
#include "kernels/walk.h"

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/kernels/instruction_sets.h"

namespace lasius::kernels {
namespace {

/// Every shape that a kernel is compiled for.
std::vector<WalkShape> all_shapes() {
  std::vector<WalkShape> shapes;
  for (const int lanes : {4, 8, 16, 24, 32}) {
    for (const bool factor : {false, true}) {
      shapes.push_back({lanes, false, factor, Draw::roulette});
      shapes.push_back({lanes, true, factor, Draw::roulette});
      shapes.push_back({lanes, false, factor, Draw::discard});
    }
  }
  return shapes;
}

Neighbourhood neighbourhood(int lanes) {
  switch (lanes) {
    case 4:
      return Neighbourhood::four;
    case 8:
      return Neighbourhood::eight;
    case 16:
      return Neighbourhood::sixteen_knight;
    case 24:
      return Neighbourhood::twenty_four;
    default:
      return Neighbourhood::thirty_two;
  }
}

std::string name(WalkShape s) {
  return std::to_string(s.lanes) + (s.mixture ? "mixture" : "single") + (s.factor ? "factor" : "") +
         (s.draw == Draw::discard ? "discard" : "");
}

/// A world whose rows are random and which is bounded by moves of weight 0.
class World {
 public:
  World(WalkShape shape, int width, int height, unsigned seed, double blocked = 0.2)
      : shape_(shape), width_(width), height_(height), random_(seed) {
    const Moves moves = moves_of(neighbourhood(shape.lanes));
    const int tiles_x = (width + kTileSide - 1) / kTileSide;
    const int tiles_y = (height + kTileSide - 1) / kTileSide;
    std::vector<char> open(static_cast<std::size_t>(width * height));
    for (auto& o : open) o = uniform() >= blocked;
    open.front() = open.back() = open[2 * width + 3] = 1;
    storage_.resize(static_cast<std::size_t>(tiles_x * tiles_y * kTileCells * row_size()) + 16,
                    0.0f);
    float* first = storage_.data();
    while (reinterpret_cast<std::uintptr_t>(first) % 64 != 0) ++first;
    for (int t = 0; t < tiles_x * tiles_y; ++t)
      tiles_.push_back(first + t * kTileCells * row_size());
    view.tiles = tiles_.data();
    view.tiles_x = tiles_x;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        float* cell = row(pack(x, y));
        for (int k = 0; k < moves.count; ++k) {
          const int nx = x + moves[k].to.dx, ny = y + moves[k].to.dy;
          const bool inside = nx >= 0 && ny >= 0 && nx < width && ny < height;
          if (!inside || !open[ny * width + nx]) continue;
          cell[k] = static_cast<float>(uniform() + 1e-3);
          if (shape.mixture) cell[shape.lanes + k] = static_cast<float>(uniform() + 1e-3);
        }
      }
    }
    for (int k = 0; k < moves.count; ++k) view.set_move(k, moves[k].to);
    for (auto& factors : view.factor) {
      for (auto& f : factors) f = shape.factor ? static_cast<float>(uniform() + 0.1) : 1.0f;
    }
    // Shares 1/8 greedy, 1/8 pheromone, 1/4 distance, 1/2 combined.
    view.rule_start = {0, 0x20000000, 0x40000000, 0x80000000};
    view.rule_scale = {0x1p-29f, 0x1p-29f, 0x1p-30f, 0x1p-31f};
    view.start = pack(0, 0);
    view.goal = pack(width - 1, height - 1);
    view.seed = 77;
  }

  struct Walked {
    WalkState state;
    std::vector<std::uint8_t> moves;
    std::vector<PackedCell> dead;
    std::int64_t numbers;  ///< that were drawn
    friend bool operator==(const Walked&, const Walked&) = default;
  };

  /// Walks ants to their end, `rounds` a call, up to `together` at a time: where one ends the next
  /// sets out, whatever the others do. In the order of the ants.
  std::vector<Walked> walk(Isa isa, int ants, int together, int rounds) {
    const auto cells = static_cast<std::size_t>(width_ * height_);
    const auto words = static_cast<std::size_t>(VisitedPlane::words_for(width_, height_));
    std::vector<WalkSlot> slots(std::min(together, ants));
    std::vector<std::vector<std::uint64_t>> planes(slots.size());
    std::vector<std::vector<std::uint8_t>> moves(slots.size());
    std::vector<std::vector<PackedCell>> dead(slots.size());
    std::vector<Walked> result(ants);
    int sent = 0, ended = 0;
    const auto send = [&](std::size_t i) {
      planes[i].assign(words, 0);
      moves[i].resize(2 * cells);
      dead[i].resize(2 * cells);
      slots[i].send(view.start, static_cast<std::uint32_t>(sent++));
      slots[i].moves = moves[i].data();
      slots[i].dead = dead[i].data();
      slots[i].visited = VisitedPlane::over(planes[i].data(), height_);
      slots[i].visited.mark(view.start);
    };
    for (std::size_t i = 0; i < slots.size(); ++i) send(i);
    while (ended < ants) {
      walk_table(isa).walk[shape_.index()](view, slots, rounds);
      for (std::size_t i = 0; i < slots.size(); ++i) {
        WalkSlot& s = slots[i];
        if (s.state == WalkState::idle || s.state == WalkState::walking) continue;
        result[s.ant] = {s.state,
                         {moves[i].begin(), moves[i].begin() + s.move_count},
                         {dead[i].begin(), dead[i].begin() + s.dead_count},
                         s.numbers_used(shape_.draw)};
        ++ended;
        s.state = WalkState::idle;
        if (sent < ants) send(i);
      }
    }
    return result;
  }

  float* row(PackedCell cell) const {
    const int x = packed_x(cell), y = packed_y(cell);
    return view.tiles[(y / kTileSide) * view.tiles_x + x / kTileSide] +
           ((y % kTileSide) * kTileSide + x % kTileSide) * row_size();
  }

  WalkWorld view;

 private:
  int row_size() const { return shape_.lanes * (shape_.mixture ? 2 : 1); }
  double uniform() { return std::uniform_real_distribution<>(0, 1)(random_); }

  WalkShape shape_;
  int width_, height_;
  std::mt19937 random_;
  std::vector<float> storage_;
  std::vector<float*> tiles_;
};

class EveryIsa : public testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(Walk, EveryIsa, testing::ValuesIn(supported_isas()));

TEST_P(EveryIsa, DrawsAsTheScalarReferenceOnEveryMask) {
  std::mt19937 random(5);
  for (const WalkShape shape : all_shapes()) {
    World world(shape, 64, 64, 3);
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
      ASSERT_EQ(draw(world.view, row, open, previous, words.data()),
                reference(world.view, row, open, previous, words.data()))
          << name(shape) << " mask " << open << " word " << words[0];
    }
  }
}

TEST_P(EveryIsa, RouletteDrawsEachMoveInProportionToItsWeight) {
  const WalkShape shape{8, false, false, Draw::roulette};
  World world(shape, 64, 64, 3);
  world.view.rule_start = {0, 0, 0, 0};
  world.view.rule_scale = {0, 0, 0, 0x1p-32f};
  alignas(32) const float row[8] = {1, 0, 2, 4, 0.5f, 0, 1, 3};
  const std::uint32_t open = 0b11011111;  // move 5 is tabu, move 1 does not exist
  const auto draw = walk_table(GetParam()).draw[shape.index()];
  std::array<int, 8> drawn{};
  constexpr std::uint32_t kDraws = 1 << 16;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const std::uint32_t word = i << 16;
    ++drawn[draw(world.view, row, open, kMaxMoves, &word)];
  }
  // Words on a regular lattice: each count is exact but for the ends of its interval.
  const double total = 11.5;
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(drawn[k], row[k] / total * kDraws, 2) << k;
}

TEST_P(EveryIsa, MixesTheRulesAsTheirShares) {
  // Pheromone allows move 0 or 1 alike, distance prefers move 0 by 3 to 1; the greedy rule and the
  // product, too.
  const WalkShape shape{4, true, false, Draw::roulette};
  World world(shape, 64, 64, 3);
  alignas(32) const float row[8] = {1, 1, 0, 0, 0.75f, 0.25f, 0, 0};
  const auto draw = walk_table(GetParam()).draw[shape.index()];
  int first = 0;
  constexpr std::uint32_t kDraws = 1 << 16;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const std::uint32_t word = i << 16;
    first += draw(world.view, row, 0xf, kMaxMoves, &word) == 0;
  }
  EXPECT_NEAR(first, (0.125 * 1 + 0.125 * 0.5 + 0.25 * 0.75 + 0.5 * 0.75) * kDraws, 4);
}

TEST_P(EveryIsa, DiscardLeavesAMoveAsOftenAsSuccessiveDiscardsWould) {
  // Weights 1, 2, 3: move 0 is left with probability P(discard 2 then 1) + P(discard 1 then 2) =
  // 3/6 * 2/3 + 2/6 * 3/4 = 7/12; move 1: 3/6 * 1/3 + 1/6 * 3/5 = 4/15; move 2: 3/20.
  const WalkShape shape{4, false, false, Draw::discard};
  World world(shape, 64, 64, 3);
  alignas(32) const float row[4] = {1, 1.0f / 2, 1.0f / 3, 1.0f / 5};
  const auto draw = walk_table(GetParam()).draw[shape.index()];
  std::array<int, 4> left{};
  std::mt19937 random(1);
  constexpr int kDraws = 400000;
  for (int i = 0; i < kDraws; ++i) {
    std::array<std::uint32_t, 4> words;
    for (auto& word : words) word = static_cast<std::uint32_t>(random());
    ++left[draw(world.view, row, 0b0111, kMaxMoves, words.data())];
  }
  // Five standard errors of a share near a half.
  const double tolerance = 5 * std::sqrt(0.25 / kDraws);
  EXPECT_NEAR(left[0] / double{kDraws}, 7.0 / 12, tolerance);
  EXPECT_NEAR(left[1] / double{kDraws}, 4.0 / 15, tolerance);
  EXPECT_NEAR(left[2] / double{kDraws}, 3.0 / 20, tolerance);
  EXPECT_EQ(left[3], 0);
}

// Of two like moves the one with half the factor is drawn once in three.
TEST_P(EveryIsa, AFactorMakesAMoveLikelierInEitherDraw) {
  for (const Draw kind : {Draw::roulette, Draw::discard}) {
    const WalkShape shape{4, false, true, kind};
    World world(shape, 64, 64, 3);
    world.view.factor[kMaxMoves] = {1, 0.5f, 1, 1};
    world.view.rule_start = WalkWorld().rule_start;  // the product alone
    world.view.rule_scale = WalkWorld().rule_scale;
    alignas(32) const float row[4] = {1, 1, 0, 0};
    const auto draw = walk_table(GetParam()).draw[shape.index()];
    std::mt19937 random(1);
    constexpr int kDraws = 1 << 17;
    int second = 0;
    for (int i = 0; i < kDraws; ++i) {
      std::array<std::uint32_t, 4> numbers;
      for (auto& n : numbers) n = static_cast<std::uint32_t>(random());
      second += draw(world.view, row, 0xf, kMaxMoves, numbers.data()) == 1;
    }
    EXPECT_NEAR(second, kDraws / 3.0, 5 * std::sqrt(kDraws / 3.0)) << name(shape);
  }
}

// Number `index` of an ant in iteration 0, as WalkSlot says.
std::uint32_t number_of(const WalkWorld& world, Draw draw, std::uint32_t ant, std::uint32_t index) {
  const std::uint32_t each = draw == Draw::discard ? 8 : 4;
  const auto block = r123::Philox4x32()(
      {{index / each, ant, 0, 0}},
      {{static_cast<std::uint32_t>(world.seed), static_cast<std::uint32_t>(world.seed >> 32)}});
  return std::rotl(block[index % 4], index % each < 4 ? 0 : 16);
}

// Moves 1 and 5, or 0 to 7 but 3, whose numbers share words.
TEST_P(EveryIsa, DiscardOfMovesThatShareWordsLeavesEachAsOftenAsItShould) {
  const WalkShape shape{8, false, false, Draw::discard};
  World world(shape, 64, 64, 3);
  alignas(32) std::array<float, 8> row;
  for (int k = 0; k < 8; ++k) row[k] = 1.0f / static_cast<float>(1 << k);
  const auto draw = walk_table(GetParam()).draw[shape.index()];
  std::array<std::uint32_t, 8> numbers;
  constexpr int kDraws = 1 << 19;
  std::array<int, 8> left_of_two{}, left_of_seven{};
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    for (std::uint32_t k = 0; k < 8; ++k) numbers[k] = number_of(world.view, shape.draw, i, k);
    ++left_of_two[draw(world.view, row.data(), 0b00100010, kMaxMoves, numbers.data())];
    ++left_of_seven[draw(world.view, row.data(), 0b11110111, kMaxMoves, numbers.data())];
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

TEST_P(EveryIsa, WalksAsTheScalarReferenceHoweverManyTogether) {
  for (const WalkShape shape : all_shapes()) {
    World world(shape, 100, 70, 11);
    const auto reference = world.walk(Isa::scalar, 20, 1, 1000000);
    EXPECT_EQ(world.walk(GetParam(), 20, 1, 1), reference) << name(shape);
    EXPECT_EQ(world.walk(GetParam(), 20, 7, 13), reference) << name(shape);
    EXPECT_EQ(world.walk(GetParam(), 20, kMaxSlots, 128), reference) << name(shape);
  }
}

TEST_P(EveryIsa, WalksAbreastAsOneByOne) {
  using Change = void (*)(WalkWorld&);
  const std::array<std::pair<const char*, Change>, 6> changes = {{
      {"as it is", [](WalkWorld&) {}},
      {"a goal nearby", [](WalkWorld& w) { w.goal = pack(3, 2); }},
      {"dead ends kill", [](WalkWorld& w) { w.backtrack = false; }},
      {"always greedy",
       [](WalkWorld& w) {
         w.rule_start = {0, 1ull << 32, 1ull << 32, 1ull << 32};
       }},
      {"by pheromone alone",
       [](WalkWorld& w) {
         w.rule_start = {0, 0, 1ull << 32, 1ull << 32};
       }},
      // Half of the words point past the last weight, as rounding may.
      {"past the wheel",
       [](WalkWorld& w) {
         w.rule_scale = {0, 0x1p-28f, 0x1p-29f, 0x1p-30f};
       }},
  }};
  for (const WalkShape shape : all_shapes()) {
    if (shape.lanes > 8) continue;
    for (const auto& [what, change] : changes) {
      World world(shape, 40, 36, 4);  // four tiles
      change(world.view);
      // Twice as many ants as slots: some set out while others are anywhere on their way.
      constexpr int kAnts = 2 * kMaxSlots;
      const auto reference = world.walk(Isa::scalar, kAnts, 1, 1000000);
      const auto [first, last] =
          std::ranges::minmax_element(reference, {}, &World::Walked::numbers);
      if (world.view.goal == pack(3, 2)) {
        EXPECT_GT(last->numbers, 10 * first->numbers) << name(shape);
      }
      // One by one, and in one group or two, even or not.
      for (const int together : {1, 5, 6, 8, 9, 11, 15, kMaxSlots}) {
        for (const int rounds : {4, 10, 128}) {
          EXPECT_EQ(world.walk(GetParam(), kAnts, together, rounds), reference)
              << name(shape) << ", " << what << ", " << together << " together, " << rounds;
        }
      }
    }
  }
}

TEST_P(EveryIsa, WalksAsTheScalarReferenceFarFromTheOrigin) {
  const WalkShape shape{8};
  constexpr int kMost = 32768, kFew = 40;
  for (const auto& [width, height] : {std::pair{kMost, kFew}, std::pair{kFew, kMost}}) {
    World world(shape, width, height, 6);
    world.view.start = world.view.goal - pack(30, 30);
    world.view.backtrack = false;  // so that walks stay there
    const auto reference = world.walk(Isa::scalar, 64, 1, 1000000);
    EXPECT_GT(std::ranges::count(reference, WalkState::arrived, &World::Walked::state), 0);
    EXPECT_EQ(world.walk(GetParam(), 64, kMaxSlots, 128), reference) << width << " x " << height;
  }
}

TEST_P(EveryIsa, EachStepDrawsByTheNextNumbersOfItsAnt) {
  for (const WalkShape shape : all_shapes()) {
    World world(shape, 64, 64, 3, 0);
    world.view.start = pack(31, 31);  // where four tiles meet
    world.view.backtrack = false;
    const auto draw = walk_table(Isa::scalar).draw[shape.index()];
    const auto walked = world.walk(GetParam(), 32, kMaxSlots, 128);
    for (std::uint32_t ant = 0; ant < walked.size(); ++ant) {
      PackedCell at = world.view.start;
      std::uint32_t previous = kMaxMoves, index = 0;
      std::set<PackedCell> entered{at};
      for (const auto move : walked[ant].moves) {
        std::uint32_t open = 0;
        std::array<std::uint32_t, kMaxMoves> numbers;
        for (int k = 0; k < shape.lanes; ++k) {
          const auto to = at + static_cast<PackedCell>(world.view.delta[k]);
          open |= std::uint32_t{!entered.contains(to)} << k;
          if (k > 0 && shape.draw == Draw::roulette) continue;
          numbers[k] = number_of(world.view, shape.draw, ant, index++);
        }
        ASSERT_EQ(draw(world.view, world.row(at), open, previous, numbers.data()), move)
            << name(shape) << ", ant " << ant << ", step " << entered.size();
        at += static_cast<PackedCell>(world.view.delta[move]);
        entered.insert(at);
        previous = move;
      }
    }
  }
}

TEST_P(EveryIsa, NeverEntersACellTwiceAndEndsAtTheGoal) {
  for (const WalkShape shape : all_shapes()) {
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
      const auto steps = static_cast<std::int64_t>(ant.moves.size() + 2 * ant.dead.size()) +
                         (ant.state == WalkState::lost);
      EXPECT_EQ(ant.numbers, steps * (shape.draw == Draw::discard ? shape.lanes : 1));
      arrived += ant.state == WalkState::arrived;
    }
    EXPECT_GT(arrived, 0) << name(shape);
  }
}

TEST_P(EveryIsa, AKilledAntStopsAtItsFirstDeadEnd) {
  World world({4, false, false, Draw::roulette}, 64, 64, 9);
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

}  // namespace
}  // namespace lasius::kernels
