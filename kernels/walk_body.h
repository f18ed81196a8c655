// The walk, written once and compiled for each instruction set. The including file defines
//   LASIUS_TARGET  the function attribute of its instruction set (may be empty)
//   LASIUS_OPS     a struct with `roulette<lanes, mixture, factor>` and `bits_at`
// and gets the table of its kernels as `kTable` in an unnamed namespace.

#include <Random123/philox.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "kernels/race.h"
#include "kernels/walk.h"

namespace lasius::kernels {
namespace {

/// Fills the slot's buffer with its next random words.
[[gnu::always_inline]] inline void refill(const WalkWorld& world, WalkSlot& slot) noexcept {
  const r123::Philox4x32::key_type key{
      {static_cast<std::uint32_t>(world.seed), static_cast<std::uint32_t>(world.seed >> 32)}};
  for (int i = 0; i < WalkSlot::kRandomWords; i += 4) {
    const r123::Philox4x32::ctr_type counter{{slot.random_block++, slot.ant, world.iteration, 0}};
    const auto words = philox4x32(counter, key);
    std::memcpy(slot.random.data() + i, words.v, sizeof words.v);
  }
  slot.random_used = 0;
}

template <int kLanes, bool kMixture, bool kFactor, Draw kDraw>
struct Walk {
  static constexpr std::ptrdiff_t kRow = kMixture ? 2 * kLanes : kLanes;  // floats a cell
  static constexpr std::uint32_t kAll = ~std::uint32_t{0} >> (32 - kLanes);

  LASIUS_TARGET static int draw(const WalkWorld& world, const float* row, std::uint32_t open,
                                std::uint32_t previous, const std::uint32_t* random) noexcept {
    if constexpr (kDraw == Draw::discard) {
      const float* factor = kFactor ? world.factor[previous].data() : nullptr;
      return last_of_race<kLanes, kFactor>(row, factor, open, random);
    } else {
      return LASIUS_OPS::roulette<kLanes, kMixture, kFactor>(world, row, open, previous, *random);
    }
  }

  /// Bit k set where move k leads to a cell that the ant has not entered.
  LASIUS_TARGET [[gnu::always_inline]] static std::uint32_t open_moves(const WalkWorld& world,
                                                                       const VisitedPlane& visited,
                                                                       PackedCell at) noexcept {
    const std::uint64_t* word = visited.word(at);
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
      return ~(up | (here & 1) << 3 | (here & 4) << 2 | down << 5) & kAll;
    }
  }

  /// Finds the row of the ant's cell, and asks for it: by the ant's next turn it has arrived.
  [[gnu::always_inline]] static void find_row(const WalkWorld& world, WalkSlot& slot) noexcept {
    const int x = packed_x(slot.at), y = packed_y(slot.at);
    const int tile = (y >> kTileShift) * world.tiles_x + (x >> kTileShift);
    const float* rows = __atomic_load_n(world.tiles + tile, __ATOMIC_ACQUIRE);
    if (rows == nullptr) [[unlikely]]
      rows = world.make_tile(world.context, tile);
    slot.row = rows + ((y % kTileSide) * kTileSide + x % kTileSide) * kRow;
    for (std::ptrdiff_t k = 0; k < kRow; k += 16) __builtin_prefetch(slot.row + k);
  }

  /// False when the ant is lost.
  [[gnu::always_inline]] static bool take_back(const WalkWorld& world, WalkSlot& slot) noexcept {
    if (!world.backtrack || slot.move_count == 0) {
      slot.state = WalkState::lost;
      return false;
    }
    slot.dead[slot.dead_count++] = slot.at;
    --slot.move_count;
    slot.at -= static_cast<PackedCell>(world.delta[slot.moves[slot.move_count]]);
    slot.previous = slot.move_count > 0 ? slot.moves[slot.move_count - 1] : kMaxMoves;
    find_row(world, slot);
    return true;
  }

  /// False when the ant's walk has ended.
  LASIUS_TARGET [[gnu::always_inline]] static bool step(const WalkWorld& world,
                                                        WalkSlot& slot) noexcept {
    const PackedCell at = slot.at;
    const float* row = slot.row;
    const std::uint32_t open = open_moves(world, slot.visited, at);
    int move;
    if constexpr (kDraw == Draw::discard) {
      std::array<std::uint32_t, kLanes> words;
      for (std::uint32_t k = 0; k < kLanes; k += 4) {  // the buffer holds fours
        if (slot.random_used == WalkSlot::kRandomWords) refill(world, slot);
        std::memcpy(words.data() + k, slot.random.data() + slot.random_used, 16);
        slot.random_used += 4;
      }
      move = draw(world, row, open, slot.previous, words.data());
    } else {
      if (slot.random_used == WalkSlot::kRandomWords) refill(world, slot);
      const std::uint32_t random = slot.random[slot.random_used++];
      move =
          LASIUS_OPS::roulette<kLanes, kMixture, kFactor>(world, row, open, slot.previous, random);
    }
    if (move < 0) [[unlikely]]
      return take_back(world, slot);

    slot.at = at + static_cast<PackedCell>(world.delta[move]);
    slot.previous = static_cast<std::uint32_t>(move);
    slot.moves[slot.move_count++] = static_cast<std::uint8_t>(move);
    slot.visited.mark(slot.at);
    find_row(world, slot);
    if (slot.at != world.goal) return true;
    slot.state = WalkState::arrived;
    return false;
  }

  LASIUS_TARGET static void walk(const WalkWorld& world, std::span<WalkSlot> slots,
                                 int rounds) noexcept {
    std::array<WalkSlot*, kMaxSlots> walking;
    int count = 0;
    for (WalkSlot& slot : slots) {
      if (slot.state != WalkState::walking) continue;
      find_row(world, slot);
      walking[count++] = &slot;
    }
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
