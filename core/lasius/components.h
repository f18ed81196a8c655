// Which free cells can reach each other, kept small and asked without map-sized work.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lasius/export.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"

namespace lasius {

/// Connected components of the free cells, 4- or 8-connected.
///
/// The grid is cut into tiles of 256 x 256 cells. Inside a tile, components that touch its border
/// are numbered in the order of their first cell along the border; only those are stored, as ids
/// that are equal where the components are joined through other tiles. A query floods at most the
/// two tiles of its cells. Worst case 0.25 bit a cell and a few words a tile.
class LASIUS_EXPORT Components {
 public:
  enum class Connectivity { four, eight };
  static constexpr int kTile = 256;

  Components(const Grid& grid, Connectivity connectivity);

  /// True when both cells are free and joined. `grid` must be the one of the constructor.
  bool connected(const Grid& grid, Cell a, Cell b) const;

  /// The components of an edited grid: only tiles that hold a changed cell are flooded again.
  Components updated(const Grid& edited, std::span<const Cell> changed) const;

  std::int64_t bytes() const noexcept;  ///< memory held
  /// Number of components; those inside one tile counted too.
  std::int64_t count() const noexcept { return count_; }

 private:
  Components() = default;
  Connectivity connectivity_ = Connectivity::four;
  int tiles_x_ = 0;
  int tiles_y_ = 0;
  std::int64_t count_ = 0;
  std::vector<std::uint32_t>
      first_;                       // per tile, index of its first entry in ids_; one past the end
  std::vector<std::uint32_t> ids_;  // per border component of a tile, in order: joined id
};

}  // namespace lasius
