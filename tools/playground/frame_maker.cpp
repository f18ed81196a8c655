#include "tools/playground/frame_maker.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lasius::playground {

FrameMaker::FrameMaker(const Grid& grid, const Params& params)
    : grid_(grid),
      index_(params.update == Update::terminal_index),
      cells_a_pixel_((std::max(grid.width(), grid.height()) + kMostPixels - 1) / kMostPixels),
      width_((grid.width() + cells_a_pixel_ - 1) / cells_a_pixel_),
      height_((grid.height() + cells_a_pixel_ - 1) / cells_a_pixel_),
      trail_(static_cast<std::size_t>(width_) * height_),
      tracks_(trail_.size()) {}

void FrameMaker::make(const GridProgress& progress) {
  std::ranges::fill(tracks_, std::uint8_t{0});
  for (int ant = 0; ant < progress.ants(); ++ant) {
    for (const Cell c : progress.walk(ant)) {
      const int pixel = c.y / cells_a_pixel_ * width_ + c.x / cells_a_pixel_;
      auto& ants = tracks_[static_cast<std::size_t>(pixel)];
      if (ants < std::numeric_limits<std::uint8_t>::max()) ++ants;
    }
  }
  read_trail(progress);
}

void FrameMaker::read_trail(const GridProgress& progress) {
  std::size_t pixel = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) trail_[pixel++] = value_at(progress, x, y);
}

float FrameMaker::value_at(const GridProgress& progress, int x, int y) const {
  const int right = std::min((x + 1) * cells_a_pixel_, grid_.width());
  const int bottom = std::min((y + 1) * cells_a_pixel_, grid_.height());
  double shown = std::numeric_limits<double>::quiet_NaN();
  for (int row = y * cells_a_pixel_; row < bottom; ++row) {
    for (int column = x * cells_a_pixel_; column < right; ++column) {
      if (grid_.blocked({column, row})) continue;
      const double held = progress.pheromone({column, row});
      shown = index_ ? std::fmin(shown, held) : std::fmax(shown, held);
    }
  }
  return static_cast<float>(shown);
}

}  // namespace lasius::playground
