// Which free cells can reach each other, kept small and asked without map-sized work.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/grid/components_block.h"
#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// Connected components of the free cells, 4- or 8-connected.
///
/// The grid is cut into tiles of 256 x 256 cells, and four tiles are a block, four blocks a larger
/// one, up to the map. Of each only the components that reach beyond are stored: where they meet
/// its neighbours, and to which component of the next larger block they belong. Most cells of a
/// tile are of one component, and a bit for each 16 x 16 cells tells where others lie. A query of
/// cells there floods at most their two tiles, no farther than to their borders, and climbs from
/// there. An edit floods its tiles, then climbs as far as a block's outline changes.
class LASIUS_EXPORT Components {
 public:
  enum class Connectivity { four, eight };
  static constexpr int kTile = 256;

  Components(const Grid& grid, Connectivity connectivity);
  /// Labels `grid`; empty if stopped. A tile counts as 4096 words.
  [[nodiscard]] static std::optional<Components> make(const Grid& grid, Connectivity connectivity,
                                                      const StopCondition& stop);

  /// True when both cells are free and joined. `grid` must be the one of the constructor, as it was
  /// at the last update. Does not allocate.
  bool connected(const Grid& grid, Cell a, Cell b) const noexcept;

  /// Brings these components up to date with an edited grid of the same size, in place. `changed`,
  /// rectangles inside the grid, must cover all cells that differ; they may overlap or be empty.
  /// They become those of a new Components(edited), at the price of the tiles that the rectangles
  /// touch and of the blocks around them whose outlines change.
  ///
  /// False when stopped: the rectangles are kept, and but for another update, nothing may be asked
  /// until one returns true. That one may have more rectangles, or none; it does what was left.
  bool update(const Grid& edited, std::span<const Rectangle> changed,
              const StopCondition& stop = {});

  /// A copy brought up to date; `changed` are all cells that differ. Empty if stopped.
  [[nodiscard]] std::optional<Components> updated(const Grid& edited, std::span<const Cell> changed,
                                                  const StopCondition& stop) const;

  std::int64_t bytes() const noexcept;  ///< memory held; looks at every tile
  /// Number of components.
  std::int64_t count() const noexcept { return count_; }

  friend bool operator==(const Components&, const Components&) = default;

 private:
  struct Tile {
    std::vector<std::uint64_t> marks;  // see kFirstRun
    std::vector<Piece> up;             // pieces of the block above, per piece
    std::uint32_t inside = 0;          // components that do not touch the border
    MainComponent main;
    friend bool operator==(const Tile&, const Tile&) = default;
  };
  struct Block {
    Outline outline;
    std::vector<Piece> up;
    std::uint32_t closed = 0;  // components that join parts and reach none of the sides
    friend bool operator==(const Block&, const Block&) = default;
  };
  struct Membership;
  struct Work;

  Components() = default;
  int columns(std::size_t level) const noexcept;  // blocks in a row, on a level of blocks_
  void relabel(const Grid& grid, Work& work);
  void rejoin(const Grid& grid, std::size_t level, Work& work);
  std::ptrdiff_t part(std::size_t level, Cell at) const noexcept;
  const Block& block(std::size_t level, Cell tile) const noexcept;  // the one around a tile
  Membership membership(const Grid& grid, Cell c, Cell other) const noexcept;

  Connectivity connectivity_ = Connectivity::four;
  int tiles_x_ = 0;
  int tiles_y_ = 0;
  std::int64_t count_ = 0;
  std::vector<Tile> tiles_;
  std::vector<std::vector<Block>> blocks_;  // by level, of 2 x 2 tiles first; the last is the map
  std::vector<Rectangle> pending_;          // of updates that were stopped
};

/// By which cells are joined for paths under a rule.
constexpr Components::Connectivity connectivity_of(Corners corners) noexcept {
  return corners == Corners::allow ? Components::Connectivity::eight
                                   : Components::Connectivity::four;
}

}  // namespace lasius
