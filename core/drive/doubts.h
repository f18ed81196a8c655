// Walls that a robot was told of, and that may have gone since.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// Keeps what was a wall before any was learned, and while no way is known the walls that are seen.
class Doubts {
 public:
  /// `after`: steps without a way before walls are doubted; 0: they never are.
  explicit Doubts(int after) : after_(after) {}

  /// Cells that are walls, `map` not told yet; what lies outside is ignored.
  void saw_walls(const Grid& map, std::span<const Cell> cells);
  void saw_walls(const Grid& map, const Rectangle& part);

  /// One more step without a way. The walls of `map` to forget, where it is time: those that were
  /// learned, and not seen since the first of these steps.
  std::vector<Cell> wait(const Grid& map);
  void end_wait() noexcept { waited_ = 0; }

  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  void learn(const Grid& map);

  int after_;                  // 0: never
  int waited_ = 0;             // steps
  std::optional<Grid> given_;  // the map before the first wall was learned
  std::optional<Grid> seen_;   // walls, since the first of the steps
};

}  // namespace lasius
