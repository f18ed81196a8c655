// The kernels' walks against the rule that they state, every instruction set against the scalar.
#include "kernels/walk/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "core/grid/move_rule.h"
#include "tests/kernels/walk/walk_cases.h"

namespace lasius::kernels {
namespace {

Neighbours neighbours(int lanes) {
  switch (lanes) {
    case 4:
      return Neighbours::four;
    case 8:
      return Neighbours::eight;
    case 16:
      return Neighbours::sixteen_knight;
    case 24:
      return Neighbours::twenty_four;
    default:
      return Neighbours::thirty_two;
  }
}

/// A world whose rows are random and which is bounded by moves of weight 0.
class World {
 public:
  World(WalkShape shape, int width, int height, unsigned seed, double blocked = 0.2)
      : shape_(shape), width_(width), height_(height), random_(seed) {
    const Moves moves = moves_of(neighbours(shape.lanes));
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
INSTANTIATE_TEST_SUITE_P(Walk, EveryIsa, testing::ValuesIn(walk_isas()), by_isa);

TEST_P(EveryIsa, WalksAsTheScalarReferenceHoweverManyTogether) {
  for (const WalkShape shape : all_shapes()) {
    World world(shape, 100, 70, 11);
    const auto reference = world.walk(Isa::scalar, 20, 1, 1000000);
    EXPECT_EQ(world.walk(GetParam(), 20, 1, 1), reference) << name(shape);
    EXPECT_EQ(world.walk(GetParam(), 20, 7, 13), reference) << name(shape);
    EXPECT_EQ(world.walk(GetParam(), 20, kMaxSlots, 128), reference) << name(shape);
  }
}

TEST_P(EveryIsa, WalksInLockStepAsOneByOne) {
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
      // One by one, and in one group or two, even or not; in few rounds at a time or in many.
      constexpr std::array<std::pair<int, int>, 12> kCalls{{{1, 4},
                                                            {5, 128},
                                                            {6, 4},
                                                            {6, 10},
                                                            {8, 4},
                                                            {8, 128},
                                                            {9, 10},
                                                            {11, 4},
                                                            {11, 128},
                                                            {15, 10},
                                                            {kMaxSlots, 4},
                                                            {kMaxSlots, 128}}};
      for (const auto& [together, rounds] : kCalls) {
        EXPECT_EQ(world.walk(GetParam(), kAnts, together, rounds), reference)
            << name(shape) << ", " << what << ", " << together << " together, " << rounds;
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
