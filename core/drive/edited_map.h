// A map that its owner edits in place, and the cells of it that a robot's centre may be in.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/grid/grow_obstacles.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// The one bitmap is edited in place: a copy a version, or tiles shared between versions, would
/// cost every reader more than the edits (ARCHITECTURE.md).
class EditedMap {
 public:
  /// @throws Error(invalid_parameter) for a negative or not finite radius.
  EditedMap(Grid map, double radius);

  const Grid& map() const noexcept { return map_; }
  /// The cells that a disc of the radius may walk on (disc::growth); the same grid where that is 0.
  const Grid& passable() const noexcept { return grown_ ? *grown_ : map_; }
  const Growth& growth() const noexcept { return growth_; }

  /// Cells of passable() that changed, and a rectangle round them, at most 64 x 64 and what a cell
  /// in it reaches. Called when passable() has them already.
  using OnChange = std::function<void(const Rectangle&, std::span<const Cell>)>;
  /// Blocks or frees cells, those outside the map ignored; tells of what changed, part by part,
  /// first `edited` of cells of map(), if it is given.
  void set(std::span<const Cell> cells, bool blocked, const OnChange& changed,
           const OnChange& edited = {});
  void set(const Rectangle& part, bool blocked, const OnChange& changed,
           const OnChange& edited = {});

  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  void apply(bool blocked, const OnChange& changed, const OnChange& edited);
  void grow(const Rectangle& part, bool blocked, const OnChange& changed);

  Grid map_;
  Growth growth_;
  std::optional<Grid> grown_;
  std::vector<Cell> differing_, grown_cells_;
};

}  // namespace lasius
