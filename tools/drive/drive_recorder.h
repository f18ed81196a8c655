// What pictures need of a drive, gathered while it goes.
#pragma once

#include <cstdint>
#include <vector>

#include "lasius/drive/drive.h"
#include "tools/draw/raster.h"

namespace lasius::tool {

/// Gathers when the robot saw what, on rasters of at most 2048 pixels a side: its memory does not
/// grow with the map.
class DriveRecorder {
 public:
  static constexpr std::int32_t kNever = -1;
  using Ticks = Raster<std::int32_t>;

  DriveRecorder(const Grid& map, double sense);

  void observe(const DriveTick& tick);

  /// By pixel: when a free cell under it was in sight first.
  const Ticks& seen() const { return seen_; }
  int cells_a_pixel() const { return cells_a_pixel_; }  ///< of both rasters, along a side
  /// By pixel: when a cell under it was last learned to be other than it was known.
  const Ticks& learned() const { return learned_; }
  /// Both: the latest tick under some cells.
  std::int32_t latest(const Ticks& ticks, Span columns, Span rows) const;
  /// Where moving obstacles were at last.
  const std::vector<Rectangle>& obstacles() const { return obstacles_; }

 private:
  void look(const Grid& world, Cell robot, std::int32_t tick);

  double sense_;
  int cells_a_pixel_;
  Ticks seen_, learned_;
  std::vector<Rectangle> obstacles_;
};

}  // namespace lasius::tool
