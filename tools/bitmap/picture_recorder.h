// What pictures need of a run, gathered while it goes.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "lasius/planner.h"
#include "tools/draw/raster.h"

namespace lasius::tool {

/// Gathers the ants' tracks and the pheromone, on a raster of at most 2048 pixels a side: its
/// memory does not grow with the map.
class PictureRecorder {
 public:
  /// Ant visits by pixel, all iterations up to and with number `iterations`.
  struct Tracks {
    int iterations;
    Raster<std::uint32_t> visits;
  };
  /// Largest pheromone under each pixel after `iterations` iterations.
  struct Pheromone {
    int iterations = 0;
    Raster<float> values;
  };

  /// `chosen`: after which iterations tracks are kept, rising; `last`: the run's last iteration.
  PictureRecorder(const Grid& grid, std::vector<int> chosen, int last);

  void observe(const GridProgress& progress);

  /// The chosen iterations that the run reached; its last one where it ended before some.
  std::vector<Tracks> tracks() const;
  const Pheromone& pheromone() const { return pheromone_; }
  /// Both rasters: pixel (x, y) holds the cells (x, y) * cells_a_pixel() and up.
  int cells_a_pixel() const { return cells_a_pixel_; }

 private:
  void capture(const GridProgress& progress);
  bool touched_near(int x, int y) const;

  const Grid& grid_;
  std::vector<int> chosen_;
  int last_;
  int cells_a_pixel_;
  int done_ = 0;
  Raster<std::uint32_t> visits_;
  std::vector<Tracks> kept_;
  Pheromone pheromone_;
  std::chrono::steady_clock::time_point next_capture_{};
};

}  // namespace lasius::tool
