#include "core/smooth/loop_cutter.h"

#include <array>
#include <bit>

#include "core/base/poller.h"
#include "core/grid/move_rule.h"

namespace lasius {
namespace {

constexpr std::int32_t kNone = CellSet::kNone;

struct Move {
  int dx;
  int dy;
};
constexpr std::array<Move, 8> kMoves{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};

// Where a move leads from a cell of a tile.
struct Step {
  std::uint8_t bit;  // cell in the tile it leads to
  std::int8_t tile;  // kNone: the same; else the move that leads to that tile
};

constexpr int move_index(int dx, int dy) {
  for (int i = 0; i < 8; ++i)
    if (kMoves[i].dx == dx && kMoves[i].dy == dy) return i;
  return kNone;
}

constexpr auto kSteps = [] {
  std::array<std::array<Step, 8>, 64> steps{};
  for (int bit = 0; bit < 64; ++bit) {
    for (int i = 0; i < 8; ++i) {
      const int x = (bit & 7) + kMoves[i].dx;
      const int y = (bit >> 3) + kMoves[i].dy;
      const int tile = move_index((x >> 3), (y >> 3));
      steps[bit][i] = {static_cast<std::uint8_t>((y & 7) * 8 + (x & 7)),
                       static_cast<std::int8_t>(tile)};
    }
  }
  return steps;
}();

}  // namespace

/// The cells as tiles that know the tiles around them. False when told to stop.
bool LoopCutter::collect(std::span<const Cell> walk, std::span<const kernels::PackedCell> further,
                         int moves, const StopCondition& stop) {
  const std::size_t cells = walk.size() + further.size();
  entered_.reset(cells);
  queue_.clear();
  queue_.reserve(cells);
  Poller poller(stop, Poller::kSteps);
  for (const Cell c : walk) {
    entered_.add(c);
    if (poller.stop_after(1)) return false;
  }
  for (const kernels::PackedCell c : further) {
    entered_.add({kernels::packed_x(c), kernels::packed_y(c)});
    if (poller.stop_after(1)) return false;
  }
  tiles_.clear();
  tiles_.reserve(std::bit_ceil(entered_.tiles().size()));
  for (const CellSet::Tile& from : entered_.tiles()) {
    Tile& tile = tiles_.emplace_back();
    tile.unseen = from.cells;
    const Cell corner = from.cell(0);
    for (int i = 0; i < moves; ++i) {
      const Cell to{corner.x + 8 * kMoves[i].dx, corner.y + 8 * kMoves[i].dy};
      tile.around[i] = entered_.find(CellSet::key_of(to));
    }
    if (poller.stop_after(moves)) return false;
  }
  return true;
}

bool LoopCutter::allowed(const Grid& grid, Corners corners, Entry e, int move) const noexcept {
  if (move < 4) return true;
  const Cell c = cell_of(e);
  const auto [dx, dy] = kMoves[move];
  return diagonal_allowed(grid, corners, {c.x + dx, c.y}, {c.x, c.y + dy});
}

std::span<const Cell> LoopCutter::cut(const Grid& grid, std::span<const Cell> walk, bool diagonal,
                                      Corners corners, const StopCondition& stop,
                                      std::span<const kernels::PackedCell> further) {
  const int moves = diagonal ? 8 : 4;
  if (!collect(walk, further, moves, stop)) return {};
  // Breadth first from the walk's end, so that the moves lead on from its start.
  const auto entry = [this](Cell c) {
    return Entry{entered_.find(CellSet::key_of(c)), CellSet::bit_of(c)};
  };
  const Entry start = entry(walk.front());
  const Entry end = entry(walk.back());
  Poller poller(stop, Poller::kSteps);
  queue_.push_back(end);
  tiles_[end.tile].unseen &= ~(std::uint64_t{1} << end.bit);
  const std::uint64_t start_bit = std::uint64_t{1} << start.bit;
  for (std::size_t head = 0; (tiles_[start.tile].unseen & start_bit) != 0; ++head) {
    if (poller.stop_after(1)) return {};
    const Entry e = queue_[head];
    for (int i = 0; i < moves; ++i) {
      const Step step = kSteps[e.bit][i];
      const std::int32_t to = step.tile == kNone ? e.tile : tiles_[e.tile].around[step.tile];
      if (to == kNone) continue;
      Tile& tile = tiles_[to];
      const std::uint64_t bit = std::uint64_t{1} << step.bit;
      if ((tile.unseen & bit) == 0 || !allowed(grid, corners, e, i)) continue;
      tile.unseen ^= bit;
      for (int plane = 0; plane < 3; ++plane)
        if ((i >> plane & 1) != 0) tile.moves[plane] |= bit;
      queue_.push_back({to, step.bit});
    }
  }
  way_.assign(1, walk.front());
  Entry at = start;
  for (Cell c = walk.front(); c != walk.back(); way_.push_back(c)) {
    const Tile& tile = tiles_[at.tile];
    int move = 0;
    for (int plane = 0; plane < 3; ++plane)
      move |= static_cast<int>(tile.moves[plane] >> at.bit & 1) << plane;
    // Against the move that reached it.
    c = {c.x - kMoves[move].dx, c.y - kMoves[move].dy};
    const Step back = kSteps[at.bit][move < 4 ? move ^ 1 : 11 - move];
    at = {back.tile == kNone ? at.tile : tile.around[back.tile], back.bit};
  }
  return way_;
}

}  // namespace lasius
