// The walk, written once and compiled for each instruction set. The including file defines
//   LASIUS_TARGET  the function attribute of its instruction set (may be empty)
//   LASIUS_OPS     a struct with `roulette<lanes, mixture, factor>`, `race<lanes, factor>`,
//                  `bits_at` and `lockstep<lanes, mixture, factor, draw>`
// and gets the table of its kernels as `kTable` in an unnamed namespace. The ants are interleaved:
// each in turn takes one step, so that one waits for memory while the others go on. Where the
// instruction set has a lock-step walk, that one takes the steps it can first.

#include <Random123/philox.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>

#include "kernels/walk/race.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

/// Fills the slot's buffer with its next random numbers, block by block in the lanes of a vector;
/// for Draw::discard, with the times that they give. Not inlined: thirty walks would hold a copy
/// each.
template <Draw kDraw>
[[gnu::noinline]] LASIUS_TARGET void refill(const WalkWorld& world, WalkSlot& slot) noexcept {
  constexpr int kEach = numbers_of_block(kDraw), kBlocks = WalkSlot::kNumbers / kEach;
  const r123::Philox4x32::key_type key{
      {static_cast<std::uint32_t>(world.seed), static_cast<std::uint32_t>(world.seed >> 32)}};
  std::uint32_t words[4][kBlocks];
  for (int i = 0; i < kBlocks; ++i) {
    const auto block = slot.random_block + static_cast<std::uint32_t>(i);
    const r123::Philox4x32::ctr_type counter{{block, slot.ant, world.iteration, 0}};
    const auto drawn = philox4x32(counter, key);
    for (int w = 0; w < 4; ++w) words[w][i] = drawn.v[w];
  }
  for (int i = 0; i < kBlocks; ++i) {
    for (int n = 0; n < kEach; ++n) {
      slot.random[kEach * i + n] = n < 4 ? words[n][i] : kernels::turned(words[n - 4][i]);
    }
  }
  if constexpr (kDraw == Draw::discard) {
    for (std::uint32_t& n : slot.random) n = std::bit_cast<std::uint32_t>(minus_log2(n));
  }
  slot.random_block += kBlocks;
  slot.random_used = 0;
}

template <int kLanes, bool kMixture, bool kFactor, Draw kDraw>
struct Walk {
  static constexpr std::ptrdiff_t kRow = kMixture ? 2 * kLanes : kLanes;  // floats a cell
  static constexpr std::uint32_t kAll = ~std::uint32_t{0} >> (32 - kLanes);

  LASIUS_TARGET static int draw(const WalkWorld& world, const float* row, std::uint32_t open,
                                std::uint32_t previous, const std::uint32_t* random) noexcept {
    if constexpr (kDraw == Draw::discard) {
      alignas(32) float at_weight_one[kLanes];
      for (int k = 0; k < kLanes; ++k) at_weight_one[k] = minus_log2(random[k]);
      return LASIUS_OPS::race<kLanes, kFactor>(world, row, open, previous, at_weight_one);
    } else {
      return LASIUS_OPS::roulette<kLanes, kMixture, kFactor>(world, row, open, previous, *random);
    }
  }

  /// Bit k set where move k leads to a cell that the ant has not entered.
  LASIUS_TARGET [[gnu::always_inline]] static std::uint32_t open_moves(const WalkWorld& world,
                                                                       const std::uint64_t* word,
                                                                       PackedCell at) noexcept {
    const int bit = VisitedPlane::bit(at);
    if constexpr (kLanes > 8) {
      std::uint64_t window = 0;
      for (int dy = kMaxReach; dy >= -kMaxReach; --dy) {
        window = window << 7 | (word[dy] >> (bit - kMaxReach) & 127);
      }
      return ~LASIUS_OPS::bits_at(window, world.window) & kAll;
    }
    const auto up = static_cast<std::uint32_t>(word[-1] >> (bit - 1)) & 7;
    const auto here = static_cast<std::uint32_t>(word[0] >> (bit - 1)) & 7;
    const auto down = static_cast<std::uint32_t>(word[1] >> (bit - 1)) & 7;
    if constexpr (kLanes == 4) {
      return ~((up >> 1 & 1) | (here & 1) << 1 | (here & 4) | (down & 2) << 2) & kAll;
    } else {
      const std::uint32_t window = up | here << 3 | down << 6;  // less the middle one:
#if defined(LASIUS_AVX512)  // pext is quick on every CPU with AVX-512, not on the first with AVX2
      return ~_pext_u32(window, 0b111101111) & kAll;
#else
      return ~((window & 15) | (window >> 5 & 15) << 4) & kAll;
#endif
    }
  }

  /// Asks for the row of the ant's cell: by the ant's next step it is there.
  [[gnu::always_inline]] static void prefetch(const WalkSlot& slot) noexcept {
    for (std::ptrdiff_t k = 0; k < kRow; k += 16) __builtin_prefetch(slot.row + k);
  }

  /// Finds what belongs to the ant's cell.
  static void find(const WalkWorld& world, WalkSlot& slot) {
    const int x = packed_x(slot.at), y = packed_y(slot.at);
    const int tile = (y >> kTileShift) * world.tiles_x + (x >> kTileShift);
    const float* rows = __atomic_load_n(world.tiles + tile, __ATOMIC_ACQUIRE);
    if (rows == nullptr) [[unlikely]]
      rows = world.make_tile(world.context, tile);
    slot.row = rows + ((y % kTileSide) * kTileSide + x % kTileSide) * kRow;
    slot.word = slot.visited.word(slot.at);
    prefetch(slot);
  }

  /// Moves the ant along a move (kSign 1) or back over it (-1). Inside a tile, what belongs to its
  /// cell is found by adding.
  template <int kSign>
  [[gnu::always_inline]] static void go(const WalkWorld& world, WalkSlot& slot, int move) {
    constexpr PackedCell kOtherTile = ~pack(kTileSide - 1, kTileSide - 1);
    const PackedCell from = slot.at;
    slot.at = from + static_cast<PackedCell>(kSign * world.delta[move]);
    if (((from ^ slot.at) & kOtherTile) == 0) [[likely]] {
      slot.row += std::ptrdiff_t{kSign} * world.tile_step[move] * kRow;
      slot.word += std::ptrdiff_t{kSign} * world.row_step[move];
      prefetch(slot);
    } else {
      find(world, slot);
    }
  }

  /// False when the ant is lost.
  [[gnu::always_inline]] static bool take_back(const WalkWorld& world, WalkSlot& slot) {
    if (!world.backtrack || slot.move_count == 0) {
      slot.state = WalkState::lost;
      return false;
    }
    slot.dead[slot.dead_count++] = slot.at;
    --slot.move_count;
    go<-1>(world, slot, slot.moves[slot.move_count]);
    if constexpr (kFactor) {
      slot.previous = slot.move_count > 0 ? slot.moves[slot.move_count - 1] : kMaxMoves;
    }
    return true;
  }

  /// False when the ant's walk has ended.
  LASIUS_TARGET [[gnu::always_inline]] static bool step(const WalkWorld& world, WalkSlot& slot) {
    const float* row = slot.row;
    const std::uint32_t open = open_moves(world, slot.word, slot.at);
    int move;
    if constexpr (kDraw == Draw::discard) {
      // As many numbers as the buffer always holds together.
      constexpr std::uint32_t kRun = std::gcd(kLanes, WalkSlot::kNumbers);
      alignas(32) float at_weight_one[kLanes];
      for (std::uint32_t k = 0; k < kLanes; k += kRun) {
        if (slot.random_used == WalkSlot::kNumbers) refill<kDraw>(world, slot);
        std::memcpy(at_weight_one + k, slot.random.data() + slot.random_used, kRun * sizeof(float));
        slot.random_used += kRun;
      }
      move = LASIUS_OPS::race<kLanes, kFactor>(world, row, open, slot.previous, at_weight_one);
    } else {
      if (slot.random_used == WalkSlot::kNumbers) refill<kDraw>(world, slot);
      const std::uint32_t random = slot.random[slot.random_used++];
      move =
          LASIUS_OPS::roulette<kLanes, kMixture, kFactor>(world, row, open, slot.previous, random);
    }
    if (move < 0) [[unlikely]]
      return take_back(world, slot);

    go<1>(world, slot, move);
    if constexpr (kFactor) slot.previous = static_cast<std::uint32_t>(move);
    slot.moves[slot.move_count++] = static_cast<std::uint8_t>(move);
    slot.visited.mark(slot.word, VisitedPlane::bit(slot.at));
    if (slot.at != world.goal) return true;
    slot.state = WalkState::arrived;
    return false;
  }

  LASIUS_TARGET static void walk(const WalkWorld& world, std::span<WalkSlot> slots, int rounds) {
    std::array<WalkSlot*, kMaxSlots> walking;
    int count = 0;
    for (WalkSlot& slot : slots) {
      if (slot.state != WalkState::walking) continue;
      find(world, slot);
      walking[count++] = &slot;
    }
    rounds -= LASIUS_OPS::template lockstep<kLanes, kMixture, kFactor, kDraw>(
        world, {walking.data(), static_cast<std::size_t>(count)}, rounds);
    const auto ended = [](const WalkSlot* slot) { return slot->state != WalkState::walking; };
    count = static_cast<int>(std::remove_if(walking.begin(), walking.begin() + count, ended) -
                             walking.begin());
    for (; rounds > 0 && count > 0; --rounds) {
      for (int i = 0; i < count;) {
        if (step(world, *walking[i])) {
          ++i;
        } else {
          walking[i] = walking[--count];
        }
      }
    }
  }
};

/// Enters the six kernels of a lane count.
template <int kLanes>
constexpr void enter(WalkTable& table) {
  const auto set =
      [&]<bool kMixture, bool kFactor, Draw kDraw>(Walk<kLanes, kMixture, kFactor, kDraw>) {
        const int i = WalkShape{kLanes, kMixture, kFactor, kDraw}.index();
        table.walk[i] = &Walk<kLanes, kMixture, kFactor, kDraw>::walk;
        table.draw[i] = &Walk<kLanes, kMixture, kFactor, kDraw>::draw;
      };
  set(Walk<kLanes, false, false, Draw::roulette>{});
  set(Walk<kLanes, true, false, Draw::roulette>{});
  set(Walk<kLanes, false, true, Draw::roulette>{});
  set(Walk<kLanes, true, true, Draw::roulette>{});
  set(Walk<kLanes, false, false, Draw::discard>{});
  set(Walk<kLanes, false, true, Draw::discard>{});
}

constexpr WalkTable kTable = [] {
  WalkTable table{};
  enter<4>(table);
  enter<8>(table);
  enter<16>(table);
  enter<24>(table);
  enter<32>(table);
  return table;
}();

}  // namespace
}  // namespace lasius::kernels
