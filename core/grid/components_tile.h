// One tile of a grid: its border, and the components inside it.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/grid/components.h"
#include "core/grid/components_block.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// A tile's place and size; at the right and bottom of the map tiles may be smaller.
struct TileBox {
  static constexpr int kSide = Components::kTile;
  static constexpr int kWords = kSide / 64;

  int x;
  int y;
  int width;
  int height;

  static TileBox at(const Grid& grid, int tile_x, int tile_y) noexcept;

  /// Free cells of a row, 0 <= y < height.
  std::array<std::uint64_t, kWords> free_row(const Grid& grid, int row) const noexcept;

  /// Border cells are numbered clockwise from the top left one.
  int border_length() const noexcept;
  /// The number of the border cell (column, row) of this tile.
  int border_position(int column, int row) const noexcept;
};

/// Free border cells, one bit a number.
using Border = std::array<std::uint64_t, 16>;
Border border_of(const Grid& grid, const TileBox& box) noexcept;

/// How components run along a tile's border, two bits a run of free border cells, in order: bit 0,
/// its component has no run before it; bit 1, none after it. Components do not cross in the plane,
/// so a run that is not its component's first belongs to the innermost component still open.
constexpr unsigned kFirstRun = 1;
constexpr unsigned kLastRun = 2;

/// Calls visit(first, last, component) for each run of free border cells, in order, components
/// numbered by their first run, until it returns false.
template <typename Visit>
void for_each_run(const Border& border, const std::uint64_t* marks, const Visit& visit) {
  std::array<std::uint16_t, 512> open;
  int depth = 0;
  std::uint16_t components = 0;
  int at = 0;
  const auto next = [&border](int from, bool wanted) noexcept {
    for (int word = from >> 6; word < 16; ++word, from = word * 64) {
      const std::uint64_t bits = (wanted ? border[word] : ~border[word]) >> (from & 63);
      if (bits != 0) return from + std::countr_zero(bits);
    }
    return 1024;
  };
  for (int run = 0; (at = next(at, true)) < 1024; ++run) {
    const int end = next(at, false);
    const auto mark = static_cast<unsigned>(marks[run / 32] >> (run % 32 * 2)) & 3;
    if ((mark & kFirstRun) != 0) open[depth++] = components++;
    const int component = open[depth - 1];
    if ((mark & kLastRun) != 0) --depth;
    if (!visit(at, end - 1, component)) return;
    at = end;
  }
}

/// The outline of a tile with these marks; its facing neighbours' cells are read, too.
void outline_tile(const Grid& grid, const TileBox& box, std::span<const std::uint64_t> marks,
                  bool eight, Outline& outline);

/// Labels the components of one tile, run by run with union-find. Reused from tile to tile.
class TileLabels {
 public:
  TileLabels();
  void label(const Grid& grid, const TileBox& box, bool eight);

  int inside_components() const noexcept { return components_ - border_components_; }
  std::span<const std::uint64_t> marks() const noexcept { return marks_; }
  const MainComponent& main() const noexcept { return main_; }

 private:
  struct Run {
    std::uint8_t lo;
    std::uint8_t hi;
  };
  int find(int run) noexcept;
  void add_row(const Grid& grid, const TileBox& box, int row);
  void unite_row(int row, int reach) noexcept;
  void find_main(int rows) noexcept;
  void mark_border(const TileBox& box);

  std::unique_ptr<Run[]> runs_;
  std::unique_ptr<std::uint16_t[]> parents_;            // smaller or equal, per run
  std::unique_ptr<std::uint16_t[]> cells_;              // in some rows, by a component's first run
  std::array<std::int32_t, TileBox::kSide + 1> first_;  // run of each row
  std::unique_ptr<std::uint8_t[]> marked_;              // scratch, per run
  std::vector<std::uint64_t> marks_;
  MainComponent main_;
  int main_run_ = 0;  // the first of it
  int run_count_ = 0;
  int components_ = 0;
  int border_components_ = 0;
};

/// What a flood from a cell met first: its tile's border, another cell, or nothing.
struct FloodEnd {
  enum class Met { nothing, border, other } met;
  int position;  ///< on the border
};
/// Floods a tile from a free cell of it until it meets the border or `other`.
FloodEnd flood(const Grid& grid, const TileBox& box, bool eight, Cell from, Cell other) noexcept;

}  // namespace lasius
