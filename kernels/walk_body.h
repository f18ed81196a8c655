// The walk, written once and compiled for each instruction set. The including file defines
//   LASIUS_TARGET  the function attribute of its instruction set (may be empty)
//   LASIUS_OPS     a struct with `draw<lanes, mixture, factor>`, see walk_scalar.cpp
// and gets the table entries `walk_table` and `draw_table` in an unnamed namespace.

#include <Random123/philox.h>

#include <algorithm>
#include <array>
#include <cstring>

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

/// Bit k set where move k leads to a cell that the ant has not entered.
template <int kLanes>
[[gnu::always_inline]] inline std::uint32_t open_moves(const std::uint64_t* word,
                                                       int bit) noexcept {
  const auto up = static_cast<std::uint32_t>(word[-1] >> (bit - 1)) & 7;
  const auto here = static_cast<std::uint32_t>(word[0] >> (bit - 1)) & 7;
  const auto down = static_cast<std::uint32_t>(word[1] >> (bit - 1)) & 7;
  if constexpr (kLanes == 4) {
    return ~((up >> 1 & 1) | (here & 1) << 1 | (here & 4) | (down & 2) << 2) & 0xf;
  } else {
    return ~(up | (here & 1) << 3 | (here & 4) << 2 | down << 5) & 0xff;
  }
}

template <int kLanes, bool kMixture, bool kFactor>
struct Walk {
  static constexpr int kRow = kMixture ? 2 * kLanes : kLanes;

  LASIUS_TARGET static int draw(const WalkWorld& world, const float* row, std::uint32_t open,
                                std::uint32_t previous, std::uint32_t random) noexcept {
    return LASIUS_OPS::draw<kLanes, kMixture, kFactor>(world, row, open, previous, random);
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
    return true;
  }

  /// False when the ant's walk has ended.
  LASIUS_TARGET [[gnu::always_inline]] static bool step(const WalkWorld& world,
                                                        WalkSlot& slot) noexcept {
    const PackedCell at = slot.at;
    const int x = packed_x(at), y = packed_y(at);
    const int tile = (y >> kTileShift) * world.tiles_x + (x >> kTileShift);
    const float* rows = __atomic_load_n(world.tiles + tile, __ATOMIC_ACQUIRE);
    if (rows == nullptr) [[unlikely]]
      rows = world.make_tile(world.context, tile);
    const int cell = (y % kTileSide) * kTileSide + x % kTileSide;

    if (slot.random_used == WalkSlot::kRandomWords) refill(world, slot);
    const std::uint32_t random = slot.random[slot.random_used++];

    const std::uint32_t open = open_moves<kLanes>(slot.visited.word(at), VisitedPlane::bit(at));
    const int move = LASIUS_OPS::draw<kLanes, kMixture, kFactor>(world, rows + cell * kRow, open,
                                                                 slot.previous, random);
    if (move < 0) [[unlikely]]
      return take_back(world, slot);

    slot.at = at + static_cast<PackedCell>(world.delta[move]);
    slot.previous = static_cast<std::uint32_t>(move);
    slot.moves[slot.move_count++] = static_cast<std::uint8_t>(move);
    slot.visited.mark(slot.at);
    if (slot.at != world.goal) return true;
    slot.state = WalkState::arrived;
    return false;
  }

  LASIUS_TARGET static void walk(const WalkWorld& world, std::span<WalkSlot> slots,
                                 int rounds) noexcept {
    std::array<WalkSlot*, kMaxSlots> walking;
    int count = 0;
    for (WalkSlot& slot : slots) {
      if (slot.state == WalkState::walking) walking[count++] = &slot;
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

/// All shapes, at index 4 * (lanes == 8) + 2 * mixture + factor.
template <template <int, bool, bool> class Kernel>
constexpr auto all_shapes(auto pick) {
  return std::array{pick(Kernel<4, false, false>{}), pick(Kernel<4, false, true>{}),
                    pick(Kernel<4, true, false>{}),  pick(Kernel<4, true, true>{}),
                    pick(Kernel<8, false, false>{}), pick(Kernel<8, false, true>{}),
                    pick(Kernel<8, true, false>{}),  pick(Kernel<8, true, true>{})};
}
constexpr WalkTable kTable{all_shapes<Walk>([](auto k) -> WalkFn { return &decltype(k)::walk; }),
                           all_shapes<Walk>([](auto k) -> DrawFn { return &decltype(k)::draw; })};

}  // namespace
}  // namespace lasius::kernels
