// What the page draws of one iteration.
#pragma once

#include <cstdint>
#include <vector>

#include "lasius/grid.h"
#include "lasius/params.h"
#include "lasius/progress.h"

namespace lasius::playground {

/// Rasters of a run as it goes, on at most kMostPixels a side: pixel (x, y) holds the cells
/// (x, y) * cells_a_pixel() and up.
class FrameMaker {
 public:
  static constexpr int kMostPixels = 512;

  FrameMaker(const Grid& grid, const Params& params);

  /// Reads pheromone and walks. Holds until the next call.
  void make(const GridProgress& progress);

  int width() const noexcept { return width_; }    ///< in pixels
  int height() const noexcept { return height_; }  ///< likewise
  int cells_a_pixel() const noexcept { return cells_a_pixel_; }
  /// By pixel the largest pheromone, or least terminal index; NaN where no cell is free.
  const std::vector<float>& trail() const noexcept { return trail_; }
  /// By pixel the ants of the iteration that entered it, a cell at a time; 255 stands for more.
  const std::vector<std::uint8_t>& tracks() const noexcept { return tracks_; }

 private:
  void read_trail(const GridProgress& progress);
  float value_at(const GridProgress& progress, int x, int y) const;

  const Grid& grid_;
  bool index_;  ///< it is a terminal index that the cells hold
  int cells_a_pixel_;
  int width_, height_;
  std::vector<float> trail_;
  std::vector<std::uint8_t> tracks_;
};

}  // namespace lasius::playground
