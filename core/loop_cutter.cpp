#include "loop_cutter.h"

#include <algorithm>
#include <array>
#include <bit>

#include "move_rule.h"

namespace lasius {
namespace {

constexpr std::int32_t kNone = -1;

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
  for (int i = 0; i < 8; ++i) {
    if (kMoves[i].dx == dx && kMoves[i].dy == dy) return i;
  }
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

constexpr std::uint32_t key_of(Cell c) noexcept {
  return static_cast<std::uint32_t>(c.x >> 3) | static_cast<std::uint32_t>(c.y >> 3) << 16;
}
constexpr int bit_of(Cell c) noexcept { return (c.y & 7) * 8 + (c.x & 7); }

}  // namespace

// The slot that holds a tile of this key, or the free one where it belongs.
std::size_t LoopCutter::slot_of(std::uint32_t key) const noexcept {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = (key * std::uint64_t{0x9e3779b97f4a7c15}) >> 32 & mask;
  while (slots_[slot] != kNone && tiles_[slots_[slot]].key != key) slot = (slot + 1) & mask;
  return slot;
}

std::int32_t LoopCutter::tile_of(std::uint32_t key) {
  const std::int32_t known = slots_[slot_of(key)];
  if (known != kNone) return known;
  Tile& tile = tiles_.emplace_back();
  tile.key = key;
  std::fill(std::begin(tile.around), std::end(tile.around), kNone);
  if (2 * tiles_.size() > slots_.size()) {
    slots_.assign(2 * slots_.size(), kNone);
    for (std::size_t i = 0; i + 1 < tiles_.size(); ++i) {
      slots_[slot_of(tiles_[i].key)] = static_cast<std::int32_t>(i);
    }
  }
  return slots_[slot_of(key)] = static_cast<std::int32_t>(tiles_.size()) - 1;
}

/// The cells as tiles that know the tiles around them. False when told to stop.
bool LoopCutter::collect(std::span<const Cell> walk, std::span<const kernels::PackedCell> further,
                         int moves, const StopCondition& stop) {
  const std::size_t cells = walk.size() + further.size();
  slots_.assign(std::bit_ceil(cells / 8 + 16), kNone);
  // Room now: to copy millions while it grows would take long between two polls.
  tiles_.clear();
  tiles_.reserve(slots_.size() / 2 + 1);
  queue_.clear();
  queue_.reserve(cells);
  std::uint32_t key = ~key_of(walk[0]);
  std::int32_t tile = kNone;
  Poller poller(stop, Poller::kSteps);
  const auto add = [&](Cell c) {
    if (key_of(c) != key) {
      key = key_of(c);
      tile = tile_of(key);
    }
    tiles_[tile].unseen |= std::uint64_t{1} << bit_of(c);
    return !poller.stop_after(1);
  };
  for (const Cell c : walk) {
    if (!add(c)) return false;
  }
  for (const kernels::PackedCell c : further) {
    if (!add({kernels::packed_x(c), kernels::packed_y(c)})) return false;
  }
  for (Tile& t : tiles_) {
    for (int i = 0; i < moves; ++i) {
      const int x = static_cast<int>(t.key & 0xffff) + kMoves[i].dx;
      const int y = static_cast<int>(t.key >> 16) + kMoves[i].dy;
      if (x >= 0 && y >= 0) t.around[i] = slots_[slot_of(key_of({8 * x, 8 * y}))];
    }
    if (poller.stop_after(moves)) return false;
  }
  return true;
}

Cell LoopCutter::cell_of(Entry e) const noexcept {
  const std::uint32_t key = tiles_[e.tile].key;
  return {static_cast<int>(key & 0xffff) * 8 + (e.bit & 7),
          static_cast<int>(key >> 16) * 8 + (e.bit >> 3)};
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
  const auto entry = [this](Cell c) { return Entry{slots_[slot_of(key_of(c))], bit_of(c)}; };
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
      for (int plane = 0; plane < 3; ++plane) {
        if ((i >> plane & 1) != 0) tile.moves[plane] |= bit;
      }
      queue_.push_back({to, step.bit});
    }
  }
  way_.assign(1, walk.front());
  Entry at = start;
  for (Cell c = walk.front(); c != walk.back(); way_.push_back(c)) {
    const Tile& tile = tiles_[at.tile];
    int move = 0;
    for (int plane = 0; plane < 3; ++plane) {
      move |= static_cast<int>(tile.moves[plane] >> at.bit & 1) << plane;
    }
    // Against the move that reached it.
    c = {c.x - kMoves[move].dx, c.y - kMoves[move].dy};
    const Step back = kSteps[at.bit][move < 4 ? move ^ 1 : 11 - move];
    at = {back.tile == kNone ? at.tile : tile.around[back.tile], back.bit};
  }
  return way_;
}

}  // namespace lasius
