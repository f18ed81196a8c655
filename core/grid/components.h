// Which free cells can reach each other, kept small and asked without map-sized work.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "lasius/export.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/stop.h"

namespace lasius {

/// Connected components of the free cells, 4- or 8-connected.
///
/// The grid is cut into tiles of 256 x 256 cells. Of each tile only the components that touch its
/// border are stored: where they run along the border (two bits a run of free border cells) and 24
/// bits each, equal where components are joined through other tiles. At most 0.21 bit a cell plus
/// 16 bytes a tile, whatever the map. A query floods at most the two tiles of its cells, and no
/// farther than to their borders.
class LASIUS_EXPORT Components {
 public:
  enum class Connectivity { four, eight };
  static constexpr int kTile = 256;

  Components(const Grid& grid, Connectivity connectivity);
  /// The same, or empty if stopped. A tile counts as 4096 words.
  [[nodiscard]] static std::optional<Components> make(const Grid& grid, Connectivity connectivity,
                                                      const StopCondition& stop);

  /// True when both cells are free and joined. `grid` must be the one of the constructor. Does not
  /// allocate.
  bool connected(const Grid& grid, Cell a, Cell b) const noexcept;

  /// The components of an edited grid of the same size; `changed` must hold all cells that differ,
  /// and none outside the grid.
  /// Only tiles that hold one are flooded again. Tiles are joined anew, by their borders alone,
  /// unless no border component changed.
  Components updated(const Grid& edited, std::span<const Cell> changed) const;
  /// The same, or empty if stopped.
  [[nodiscard]] std::optional<Components> updated(const Grid& edited, std::span<const Cell> changed,
                                                  const StopCondition& stop) const;

  std::int64_t bytes() const noexcept;  ///< memory held
  /// Number of components; those inside one tile counted too.
  std::int64_t count() const noexcept { return count_; }

  friend bool operator==(const Components&, const Components&) = default;

 private:
  struct Tile {
    std::uint32_t first_id;    // index into ids_, in threes of bytes
    std::uint32_t first_mark;  // index into marks_
    std::uint32_t inside;      // components that do not touch the border
    std::uint32_t alike;       // border components all have the same id
    friend bool operator==(const Tile&, const Tile&) = default;
  };
  /// Where a cell belongs: an id, or only the tile it is shut in.
  struct Home;

  Components() = default;
  bool join(const Grid& grid, Poller& poller);
  Home home(const Grid& grid, Cell c, Cell other) const noexcept;
  std::uint32_t id(std::uint32_t index) const noexcept;

  Connectivity connectivity_ = Connectivity::four;
  int tiles_x_ = 0;
  int tiles_y_ = 0;
  std::int64_t count_ = 0;
  std::vector<Tile> tiles_;           // one past the end closes the last
  std::vector<std::uint8_t> ids_;     // per border component, in order along its tile's border
  std::vector<std::uint64_t> marks_;  // per tile: see BorderMarks
};

}  // namespace lasius
