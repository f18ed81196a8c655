// What pictures need of a run, gathered while it goes.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "lasius/params/params.h"
#include "lasius/plan/planner.h"
#include "tools/draw/raster.h"

namespace lasius::tool {

/// Gathers the ants' tracks and the pheromone, on a raster of at most so many pixels a side: its
/// memory does not grow with the map.
class PictureRecorder {
 public:
  struct Limits {
    int pixels = 2048;  ///< a side of the rasters
    /// Up to so many cells the pheromone of every one is read, else only around the ants' tracks.
    std::int64_t read_all = std::int64_t{1} << 22;
  };

  /// Ants by pixel: those of one iteration, and of all up to it.
  struct Tracks {
    int iterations = 0;  ///< its number, from 1; 0: none yet
    int ants = 0, arrived = 0;
    double mean =
        std::numeric_limits<double>::quiet_NaN();  ///< tour of those that arrived; NaN if none
    Raster<std::uint32_t> now, so_far;
  };
  /// Largest pheromone, or least terminal index, under each pixel after `iterations` iterations;
  /// NaN where no cell is free, or was read, or the index is unknown: has its largest value.
  struct Pheromone {
    int iterations = 0;
    Raster<float> values;
  };

  /// `chosen`: after which iterations tracks are kept, rising; empty: 1, the critical time or 10,
  /// 50, and the last of `params`.
  PictureRecorder(const Grid& grid, std::vector<int> chosen, const Params& params,
                  const Limits& limits);
  PictureRecorder(const Grid& grid, std::vector<int> chosen, const Params& params)
      : PictureRecorder(grid, std::move(chosen), params, Limits{}) {}

  void observe(const GridProgress& progress);
  /// Reads the pheromone now; `observe` does so where that costs little. `observe` has seen it.
  void capture(const GridProgress& progress);

  /// The chosen iterations that the run reached; its last one where it ended before some.
  std::vector<Tracks> tracks() const;
  /// The last iteration that was observed.
  const Tracks& newest() const { return newest_; }
  /// Of a terminal-index run: the index.
  const Pheromone& pheromone() const { return pheromone_; }
  /// Both rasters: pixel (x, y) holds the cells (x, y) * cells_a_pixel() and up.
  int cells_a_pixel() const { return cells_a_pixel_; }
  /// Whether every cell's pheromone was read.
  bool reads_all() const { return reads_all_; }

 private:
  bool touched_near(int x, int y) const;

  const Grid& grid_;
  std::vector<int> chosen_;
  int last_;
  bool index_;  ///< it is a terminal index that the cells hold
  bool reads_all_;
  int cells_a_pixel_;
  int done_ = 0;
  Tracks newest_;
  std::vector<Tracks> kept_;
  Pheromone pheromone_;
  std::chrono::steady_clock::time_point next_capture_{};
};

}  // namespace lasius::tool
