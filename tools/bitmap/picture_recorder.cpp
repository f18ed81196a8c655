#include "tools/bitmap/picture_recorder.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace lasius::tool {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

std::vector<int> usual(const Params& params) {
  std::vector<int> chosen{1, params.critical_time > 0 ? params.critical_time : 10, 50,
                          params.iterations};
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::erase_if(chosen, [&](int i) { return i > params.iterations; });
  return chosen;
}

}  // namespace

PictureRecorder::PictureRecorder(const Grid& grid, std::vector<int> chosen, const Params& params,
                                 const Limits& limits)
    : grid_(grid),
      chosen_(chosen.empty() ? usual(params) : std::move(chosen)),
      last_(params.iterations),
      index_(params.update == Update::terminal_index),
      reads_all_(static_cast<std::int64_t>(grid.width()) * grid.height() <= limits.read_all),
      cells_a_pixel_((std::max(grid.width(), grid.height()) + limits.pixels - 1) / limits.pixels) {
  const auto pixels = [this](int cells) { return (cells + cells_a_pixel_ - 1) / cells_a_pixel_; };
  newest_.now = newest_.so_far = Raster<std::uint32_t>(pixels(grid.width()), pixels(grid.height()));
}

void PictureRecorder::observe(const GridProgress& progress) {
  done_ = progress.iteration + 1;
  newest_.iterations = done_;
  newest_.ants = progress.ants();
  newest_.arrived = progress.arrived;
  newest_.mean = progress.mean_length;
  std::ranges::fill(newest_.now.values, 0U);
  for (int ant = 0; ant < progress.ants(); ++ant)
    for (const Cell c : progress.walk(ant))
      for (auto* ants : {&newest_.now, &newest_.so_far})
        ++ants->at(c.x / cells_a_pixel_, c.y / cells_a_pixel_);
  if (std::ranges::find(chosen_, done_) != chosen_.end()) kept_.push_back(newest_);
  // A run may end before its last iteration: what is drawn then is at most some captures old.
  const auto now = std::chrono::steady_clock::now();
  if (done_ != last_ && now < next_capture_) return;
  capture(progress);
  const auto after = std::chrono::steady_clock::now();
  next_capture_ = after + 20 * (after - now);
}

void PictureRecorder::capture(const GridProgress& progress) {
  auto& values = pheromone_.values;
  if (values.width == 0) values = Raster<float>(newest_.now.width, newest_.now.height, kNone);
  pheromone_.iterations = done_;
  for (int y = 0; y < values.height; ++y) {
    const int bottom = std::min((y + 1) * cells_a_pixel_, grid_.height());
    for (int x = 0; x < values.width; ++x) {
      if (!reads_all_ && !touched_near(x, y)) continue;
      const int right = std::min((x + 1) * cells_a_pixel_, grid_.width());
      double shown = kNone;
      for (int r = y * cells_a_pixel_; r < bottom; ++r)
        for (int c = x * cells_a_pixel_; c < right; ++c)
          if (grid_.free({c, r})) {
            const double held = progress.pheromone({c, r});
            shown = index_ ? std::fmin(shown, held) : std::fmax(shown, held);
          }
      values.at(x, y) = static_cast<float>(shown);
    }
  }
  if (!index_) return;
  const float unknown = chosen(values, 1, {0, values.width}, {0, values.height}, std::greater<>());
  std::replace(values.values.begin(), values.values.end(), unknown, kNone);
}

bool PictureRecorder::touched_near(int x, int y) const {
  for (int j = std::max(0, y - 1); j <= std::min(newest_.now.height - 1, y + 1); ++j)
    for (int i = std::max(0, x - 1); i <= std::min(newest_.now.width - 1, x + 1); ++i)
      if (newest_.so_far.at(i, j) > 0) return true;
  return false;
}

std::vector<PictureRecorder::Tracks> PictureRecorder::tracks() const {
  auto tracks = kept_;
  const bool cut = done_ > 0 && !chosen_.empty() && chosen_.back() > done_;
  if (cut && (tracks.empty() || tracks.back().iterations != done_)) tracks.push_back(newest_);
  return tracks;
}

}  // namespace lasius::tool
