// The walk kernel: ants step from cell to cell, each drawing its moves from rows of weights.
//
// Several ants advance within one call, so that their chains of dependent loads overlap:
// interleaved, each in turn taking a step (walk_body.h), or in lock-step, one ant a SIMD lane
// (lockstep.h). An ant's walk depends on the weights and on its own random stream only: not on the
// other ants, the thread, the order of the calls or the instruction set.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "kernels/base/cpu.h"
#include "kernels/base/moves.h"
#include "kernels/base/packed_cell.h"

namespace lasius::kernels {

// Weight rows live in square tiles, row-major inside.
inline constexpr int kTileShift = 5;
inline constexpr int kTileSide = 1 << kTileShift;
inline constexpr int kTileCells = kTileSide * kTileSide;

/// Cells that one ant has entered, one bit each, kept in words of 64 columns that start every 32
/// columns and overlap: around every cell, 16 columns to either side lie in one word. Words of one
/// strip follow each other by row, so the memory touched follows the walk.
struct VisitedPlane {
  std::uint64_t* origin = nullptr;      ///< word of strip 0, row 0; padded all around
  std::int64_t rows = 0;                ///< words of a strip, padding included
  std::array<std::int64_t, 2> sides{};  ///< to the words of the strips on either side

  static std::int64_t rows_for(int height) noexcept { return height + 2 * kMaxReach; }
  static std::int64_t words_for(int width, int height) noexcept {
    return rows_for(height) * ((width + 31) / 32 + 2);
  }
  static VisitedPlane over(std::uint64_t* words, int height) noexcept {
    const std::int64_t rows = rows_for(height);
    return {words + rows + kMaxReach, rows, {-rows, rows}};
  }

  std::uint64_t* word(PackedCell c) const noexcept {
    return origin + static_cast<std::int64_t>((c & 0xffff) >> 5) * rows + packed_y(c);
  }
  static int bit(PackedCell c) noexcept { return static_cast<int>(c & 31) + 16; }

  void mark(PackedCell c) const noexcept { mark(word(c), bit(c)); }
  void mark(std::uint64_t* w, int b) const noexcept {
    w[0] |= std::uint64_t{1} << b;
    w[neighbour(b)] |= std::uint64_t{1} << (b ^ 32);
  }
  void clear(PackedCell c) const noexcept {
    std::uint64_t* w = word(c);
    const int b = bit(c);
    w[0] &= ~(std::uint64_t{1} << b);
    w[neighbour(b)] &= ~(std::uint64_t{1} << (b ^ 32));
  }

 private:
  /// From a cell's word to the other word that holds it, without a branch.
  std::int64_t neighbour(int bit) const noexcept { return sides[bit >> 5]; }
};

/// What a step may do, in the order of the wheel that chooses: go where the weight is largest (the
/// pseudo-random proportional rule of ACS), or draw by pheromone, by distance or by their product
/// (Fan et al. 2004, note 4).
enum Rule { kGreedyRule, kPheromoneRule, kDistanceRule, kCombinedRule, kRules };

/// What all ants of an iteration share. Read-only during a walk, but for new tiles.
struct WalkWorld {
  /// Rows of weights by tile, row-major `tiles_x` a row; null where no ant has been. Of a cell:
  /// with one rule, `lanes` floats; with a mixture of rules (WalkShape), `lanes` of pheromone, then
  /// `lanes` of distance. A weight of 0 is a move that does not exist, every other one is at least
  /// 2^-120. For Draw::discard rows hold one over the weight, at most 2^120, or 0.
  float* const* tiles = nullptr;
  int tiles_x = 0;
  /// Called for a null entry, from any thread: makes the tile, enters it in `tiles` (release) and
  /// returns its rows. May throw.
  float* (*make_tile)(void* context, int tile) = nullptr;
  void* context = nullptr;

  std::array<std::int32_t, kMaxMoves> delta{};      ///< PackedCell difference of a move
  std::array<std::int32_t, kMaxMoves> tile_step{};  ///< of a move's cell index in a tile, row-major
  std::array<std::int32_t, kMaxMoves> row_step{};   ///< rows that a move goes down
  std::uint64_t window = 0;  ///< more than 8 moves: their bits in 7 x 7 cells, row by row
  /// Factor on what the row holds (in a mixture, of pheromone), by previous move (kMaxMoves: none
  /// yet) and move; the larger, the likelier in either draw, and 0 closes a move.
  alignas(64) std::array<std::array<float, kMaxMoves>, kMaxMoves + 1> factor{};
  /// The wheel: rule r is chosen by random words from rule_start[r] to below the next rule's.
  std::array<std::uint64_t, kRules> rule_start{};
  /// Maps the rest of the word onto [0, 1]. As given here, every word draws by the product.
  std::array<float, kRules> rule_scale{0, 0, 0, 0x1p-32f};

  /// Enters the differences of move k.
  void set_move(int k, Offset to) noexcept {
    const int dx{to.dx}, dy{to.dy};
    delta[k] = dy * 65536 + dx;
    tile_step[k] = dy * kTileSide + dx;
    row_step[k] = dy;
    window |= std::uint64_t{1} << ((dy + kMaxReach) * 7 + dx + kMaxReach);
  }

  PackedCell start = 0;
  PackedCell goal = 0;
  bool backtrack = true;
  std::uint64_t seed = 0;
  std::uint32_t iteration = 0;
};

enum class WalkState : std::uint32_t {
  idle,  ///< no ant in the slot
  walking,
  arrived,
  lost  ///< every move on is closed, and it could not step back
};

/// How one move is drawn from a row.
enum class Draw {
  roulette,  ///< with probability proportional to its weight
  /// Discard moves one by one, each with probability proportional to its weight, until one is left
  /// (Li, Wang & Ma, section 2.3). Drawn as an exponential race: move k gets a random time of
  /// density weight * exp(-weight * t), and the longest stays, which is the same distribution. The
  /// row holds the mean of that time, one over the weight: no division is left to do.
  discard,
};

/// Random numbers that a Philox block gives, see WalkSlot.
constexpr int numbers_of_block(Draw draw) noexcept { return draw == Draw::discard ? 8 : 4; }

/// One ant under way. Block b of ant a in iteration q is Philox4x32-10 with key = seed and counter
/// (b, a, q, 0). A roulette takes one of its four words a step. Draw::discard takes a number for
/// each move of the row, eight of a block: the four words, then these rotated by 16 bits. (What
/// two of them share stands behind the sixteenth binary place.)
struct WalkSlot {
  static constexpr int kNumbers = 64;
  static constexpr int kMovesBeyond = 3;  ///< that a kernel may write behind a tour

  PackedCell at = 0;
  std::uint32_t previous = kMaxMoves;  ///< with factors, the last move; kMaxMoves at the start
  WalkState state = WalkState::idle;
  std::uint32_t ant = 0;
  /// The tour so far. Room for every step of the call, and for kMovesBeyond more.
  std::uint8_t* moves = nullptr;
  std::int64_t move_count = 0;
  PackedCell* dead = nullptr;  ///< cells entered and left again, room for every step of the call
  std::int64_t dead_count = 0;

  const float* row = nullptr;  ///< of the cell it is at; the kernel's own, as is `word`
  VisitedPlane visited;
  std::uint64_t* word = nullptr;  ///< of `visited` around that cell
  std::uint32_t random_used = kNumbers;
  std::uint32_t random_block = 0;  ///< the next one
  /// Numbers to come; for Draw::discard the random times they give at weight 1, as floats' bits.
  alignas(64) std::array<std::uint32_t, kNumbers> random;

  /// Puts a new ant at its start. Random numbers left of the ant before are dropped.
  void send(PackedCell start, std::uint32_t number) noexcept {
    at = start;
    previous = kMaxMoves;
    state = WalkState::walking;
    ant = number;
    move_count = dead_count = 0;
    random_used = kNumbers;
    random_block = 0;
  }

  /// Random numbers used: one a step (Draw::discard: one a move of the row), steps back
  /// included.
  std::int64_t numbers_used(Draw draw) const noexcept {
    return std::int64_t{random_block} * numbers_of_block(draw) -
           (kNumbers - std::int64_t{random_used});
  }
};

inline constexpr int kMaxSlots = 16;  ///< slots of one call

/// Advances each slot that is walking by at most `rounds` steps; the slots' planes are of one
/// height. A step moves the ant, or takes back its last move when every move on is closed (lost if
/// it may not, or stands at the start). Throws only what `make_tile` throws; what the slots hold is
/// undefined then.
using WalkFn = void (*)(const WalkWorld& world, std::span<WalkSlot> slots, int rounds);

/// What a walk kernel is compiled for.
struct WalkShape {
  int lanes = 8;         ///< moves: 4, 8, 16, 24 or 32
  bool mixture = false;  ///< rows hold weights of two rules; roulette only
  bool factor = false;   ///< WalkWorld::factor is not all ones
  Draw draw = Draw::roulette;

  constexpr int index() const noexcept {
    const int wide = lanes == 4 ? 0 : lanes / 8;
    return (wide * 2 + factor) * 3 + (draw == Draw::discard ? 2 : mixture ? 1 : 0);
  }
};
inline constexpr int kWalkShapes = 30;

/// Draws from one row as the kernel does: for tests, which ask for a given row and numbers.
///   row     as in WalkWorld::tiles, aligned to 16 bytes (4 lanes) or 32 bytes
///   open    bit k set where move k is not tabu
///   random  random numbers, uniform: one (roulette), or `lanes` (discard)
/// Returns the move, -1 if there is none.
using DrawFn = int (*)(const WalkWorld& world, const float* row, std::uint32_t open,
                       std::uint32_t previous, const std::uint32_t* random) noexcept;

/// The kernels of one instruction set, by WalkShape::index().
struct WalkTable {
  std::array<WalkFn, kWalkShapes> walk;
  std::array<DrawFn, kWalkShapes> draw;
};
/// On a set without kernels of its own, the table of the next lesser one.
const WalkTable& walk_table(Isa isa) noexcept;

}  // namespace lasius::kernels
