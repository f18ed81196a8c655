#include "tools/bitmap/picture_recorder.h"

#include <algorithm>

namespace lasius::tool {
namespace {

constexpr int kMostPixels = 2048;
/// Up to so many cells the pheromone of every one is read, else only around the ants' tracks.
constexpr std::int64_t kReadAll = std::int64_t{1} << 22;

}  // namespace

PictureRecorder::PictureRecorder(const Grid& grid, std::vector<int> chosen, int last)
    : grid_(grid),
      chosen_(std::move(chosen)),
      last_(last),
      cells_a_pixel_((std::max(grid.width(), grid.height()) + kMostPixels - 1) / kMostPixels) {
  const auto pixels = [this](int cells) { return (cells + cells_a_pixel_ - 1) / cells_a_pixel_; };
  visits_ = Raster<std::uint32_t>(pixels(grid.width()), pixels(grid.height()));
}

void PictureRecorder::observe(const GridProgress& progress) {
  done_ = progress.iteration + 1;
  for (int ant = 0; ant < progress.ants(); ++ant)
    for (const Cell c : progress.walk(ant))
      ++visits_.at(c.x / cells_a_pixel_, c.y / cells_a_pixel_);
  if (std::find(chosen_.begin(), chosen_.end(), done_) != chosen_.end())
    kept_.push_back({done_, visits_});
  // A run may end before its last iteration: what is drawn then is at most some captures old.
  const auto now = std::chrono::steady_clock::now();
  if (done_ != last_ && now < next_capture_) return;
  capture(progress);
  const auto after = std::chrono::steady_clock::now();
  next_capture_ = after + 20 * (after - now);
}

void PictureRecorder::capture(const GridProgress& progress) {
  auto& values = pheromone_.values;
  if (values.width == 0) values = Raster<float>(visits_.width, visits_.height);
  pheromone_.iterations = done_;
  const bool all = static_cast<std::int64_t>(grid_.width()) * grid_.height() <= kReadAll;
  for (int y = 0; y < values.height; ++y) {
    const int bottom = std::min((y + 1) * cells_a_pixel_, grid_.height());
    for (int x = 0; x < values.width; ++x) {
      if (!all && !touched_near(x, y)) continue;
      const int right = std::min((x + 1) * cells_a_pixel_, grid_.width());
      double most = 0;
      for (int r = y * cells_a_pixel_; r < bottom; ++r)
        for (int c = x * cells_a_pixel_; c < right; ++c)
          if (grid_.free({c, r})) most = std::max(most, progress.pheromone({c, r}));
      values.at(x, y) = static_cast<float>(most);
    }
  }
}

bool PictureRecorder::touched_near(int x, int y) const {
  for (int j = std::max(0, y - 1); j <= std::min(visits_.height - 1, y + 1); ++j)
    for (int i = std::max(0, x - 1); i <= std::min(visits_.width - 1, x + 1); ++i)
      if (visits_.at(i, j) > 0) return true;
  return false;
}

std::vector<PictureRecorder::Tracks> PictureRecorder::tracks() const {
  auto tracks = kept_;
  const bool cut = done_ > 0 && !chosen_.empty() && chosen_.back() > done_;
  if (cut && (tracks.empty() || tracks.back().iterations != done_))
    tracks.push_back({done_, visits_});
  return tracks;
}

}  // namespace lasius::tool
