// Mazes: a random spanning tree over a lattice of corridor squares, and a few loops.
#include <algorithm>
#include <cstdlib>
#include <vector>

#include "core/base/poller.h"
#include "core/generate/generate_kinds.h"

namespace lasius {
namespace {

constexpr int kLoopShare = 14;  // of 256 walls are opened beside the tree's

// Corridor and wall width: the walls of a tree take wall / (corridor + wall) of the area.
struct Widths {
  int corridor;
  int wall;
};

Widths widths_for(BlockedShare share, int side) {
  const int widest = std::max(12, side / 12);  // of few squares the outer ones, unwalled, are many
  Widths best{6, 0};
  std::int64_t best_miss = share;
  for (const int corridor : {6, 5, 7, 4, 8, 3, 9, 2, 10, 12, 14, 17, 20, 24}) {
    for (int wall = 1; wall <= 24 && corridor + wall <= widest; ++wall) {
      const std::int64_t miss =
          std::abs((std::int64_t{wall} << 32) / (corridor + wall) - std::int64_t{share});
      if (miss < best_miss) {
        best = {corridor, wall};
        best_miss = miss;
      }
    }
  }
  return best;
}

// One axis of the lattice; the last square takes what is left over.
struct Axis {
  int count, pitch, corridor, size;
  Axis(Widths widths, int cells)
      : count(std::max(1, (cells + widths.wall) / (widths.corridor + widths.wall))),
        pitch(widths.corridor + widths.wall),
        corridor(widths.corridor),
        size(cells) {}
  int start(int i) const noexcept { return i * pitch; }
  int end(int i) const noexcept { return i + 1 == count ? size : i * pitch + corridor; }
};

// Bits of a lattice square.
enum : std::uint8_t { kFrom = 3, kSeen = 4, kOpenRight = 8, kOpenDown = 16 };
constexpr int kStepX[4] = {1, 0, -1, 0};
constexpr int kStepY[4] = {0, 1, 0, -1};

class Maze {
 public:
  Maze(int columns, int rows)
      : columns_(columns), rows_(rows), squares_(static_cast<std::size_t>(columns) * rows) {}

  // Depth first; the way back is kept in the squares, so memory is a byte a square.
  void grow(MapDraws draws, Poller& poller) {
    int x = 0;
    int y = 0;
    at(x, y) |= kSeen;
    while (!poller.stop_after(4)) {
      int ways[4];
      int count = 0;
      for (int k = 0; k < 4; ++k) {
        const int nx = x + kStepX[k];
        const int ny = y + kStepY[k];
        if (nx < 0 || ny < 0 || nx >= columns_ || ny >= rows_) continue;
        if ((at(nx, ny) & kSeen) == 0) ways[count++] = k;
      }
      if (count == 0) {
        if (x == 0 && y == 0) return;
        const int back = (at(x, y) & kFrom) ^ 2;
        x += kStepX[back];
        y += kStepY[back];
        continue;
      }
      const int way = count == 1 ? ways[0] : ways[draws.below(count)];
      open(x, y, way);
      x += kStepX[way];
      y += kStepY[way];
      at(x, y) = static_cast<std::uint8_t>(at(x, y) | kSeen | way);
    }
  }

  void add_loops(MapDraws draws, Poller& poller) {
    for (int y = 0; y < rows_ && !poller.stop_after(columns_); ++y) {
      for (int x = 0; x < columns_; ++x) {
        if (x + 1 < columns_ && draws.chance(kLoopShare)) open(x, y, 0);
        if (y + 1 < rows_ && draws.chance(kLoopShare)) open(x, y, 1);
      }
    }
  }

  bool open_right(int x, int y) const { return (squares_[index(x, y)] & kOpenRight) != 0; }
  bool open_down(int x, int y) const { return (squares_[index(x, y)] & kOpenDown) != 0; }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * columns_ + x; }
  std::uint8_t& at(int x, int y) { return squares_[index(x, y)]; }
  void open(int x, int y, int way) {
    if (way == 2) --x;
    if (way == 3) --y;
    at(x, y) |= (way & 1) == 0 ? kOpenRight : kOpenDown;
  }

  int columns_;
  int rows_;
  std::vector<std::uint8_t> squares_;
};

}  // namespace

void make_maze(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller) {
  const Widths widths = widths_for(share, std::min(grid.width(), grid.height()));
  const Axis across(widths, grid.width());
  const Axis down(widths, grid.height());
  Maze maze(across.count, down.count);
  maze.grow(MapDraws(random, MapStream::maze), poller);
  maze.add_loops(MapDraws(random, MapStream::maze_loops), poller);

  grid.fill(true);
  const auto repeat = [&grid](int row, int end) {
    for (int y = row + 1; y < end; ++y) grid.set_row(y, grid.row(row));
  };
  for (int j = 0; j < down.count && !poller.stop_after(grid.width()); ++j) {
    const int row = down.start(j), wall = down.end(j);  // the wall below, which the last has not
    for (int i = 0; i < across.count; ++i) {
      const int x = across.start(i), width = across.end(i) - x;
      const bool joined = maze.open_right(i, j);
      grid.fill({x, row, joined ? across.start(i + 1) - x : width, 1}, false);
      if (maze.open_down(i, j)) grid.fill({x, wall, width, 1}, false);
    }
    repeat(row, wall);
    if (j + 1 < down.count) repeat(wall, down.start(j + 1));
  }
}

}  // namespace lasius
