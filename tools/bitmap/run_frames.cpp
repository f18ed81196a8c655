#include "tools/bitmap/run_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tools/report/packed.h"
#include "tools/report/report.h"

namespace lasius::tool {
namespace {

/// How many frames of so many pixels fit.
std::size_t frames_of(const Grid& grid) {
  const int side =
      (std::max(grid.width(), grid.height()) + RunFrames::kMostPixels - 1) / RunFrames::kMostPixels;
  const auto pixels = static_cast<std::size_t>(grid.width() / side + 1) *
                      static_cast<std::size_t>(grid.height() / side + 1);
  return std::clamp<std::size_t>(RunFrames::kMostBytes / (pixels * 6), 8, RunFrames::kMostFrames);
}

/// Codes of one byte, as page/heat_map.js reads them.
struct Scale {
  double least = 1, most = 1;
  bool logarithmic = true;

  /// 0 for what has no place on it.
  std::uint8_t code(double value) const {
    if (!(logarithmic ? value > 0 : value >= 0) || !std::isfinite(value)) return 0;
    const auto place = [&](double v) { return logarithmic ? std::log(v) : v; };
    const double span = place(most) - place(least);
    const double share = span > 0 ? (place(value) - place(least)) / span : 1;
    return static_cast<std::uint8_t>(1 + std::lround(254 * std::clamp(share, 0.0, 1.0)));
  }
  Json json(std::string_view name, const std::string& frames) const {
    return {{"name", name},
            {"least", least},
            {"most", most},
            {"logarithmic", logarithmic},
            {"frames", frames}};
  }
};

/// Over all values above 0: six decades below the most at most.
template <class Value, class Frames>
Scale scale_of(const Frames& frames, std::vector<Value> Frames::value_type::*values, bool linear) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const auto& frame : frames)
    for (const auto value : frame.*values)
      if (value > 0 && std::isfinite(static_cast<double>(value))) {
        least = std::min<double>(least, value);
        most = std::max<double>(most, value);
      }
  if (most <= 0) return {};
  return {linear ? 0 : std::max(least, 1e-6 * most), most, !linear};
}

template <class Value, class Frames>
std::string codes(const Frames& frames, std::vector<Value> Frames::value_type::*values,
                  const Scale& scale) {
  std::vector<std::vector<std::uint8_t>> coded;
  for (const auto& frame : frames) {
    auto& pixels = coded.emplace_back();
    for (const auto value : frame.*values) pixels.push_back(scale.code(value));
  }
  return packed_frames(coded);
}

}  // namespace

RunFrames::RunFrames(const Grid& grid, const Params& params)
    // Tracks of no iteration are kept there: frames hold their own.
    : rasters_(grid, {std::numeric_limits<int>::max()}, params,
               {.pixels = kMostPixels, .read_all = kReadAll}),
      colony_(find_algorithm(params.algorithm()).kind == Algorithm::Kind::colony),
      index_(params.update == Update::terminal_index),
      frames_(frames_of(grid)) {}

void RunFrames::observe(const GridProgress& progress) {
  rasters_.observe(progress);
  newest_.observe(progress);
  if (progress.lower_bound) {
    const std::chrono::duration<double, std::milli> since =
        std::chrono::steady_clock::now() - begin_;
    told_ms_.push_back(since.count());
    told_best_.push_back(progress.best_length);
    told_bound_.push_back(*progress.lower_bound);
  }
  if (!frames_.wants(progress.iteration)) return;
  if (colony_) rasters_.capture(progress);
  frames_.add(frame());
}

RunFrames::Frame RunFrames::frame() const {
  const auto& newest = rasters_.newest();
  Frame frame{newest_, newest.ants, newest.arrived, rasters_.pheromone().values.values, {}};
  for (const std::uint32_t ants : newest.now.values)
    frame.tracks.push_back(static_cast<std::uint16_t>(std::min<std::uint32_t>(ants, 65535)));
  return frame;
}

Json RunFrames::json() const {
  if (rasters_.newest().iterations == 0) return nullptr;
  KeyFrames<Frame> kept = frames_;
  // The end of the run, with a trail that is some captures old at most.
  if (kept.all().back().iteration != rasters_.newest().iterations) kept.add(frame());
  std::string trail, tracks;
  Scale trail_scale, track_scale;
  for (;;) {
    const auto& frames = kept.all();
    trail_scale = scale_of(frames, &Frame::trail, index_);
    track_scale = scale_of(frames, &Frame::tracks, false);
    if (colony_) trail = codes(frames, &Frame::trail, trail_scale);
    tracks = codes(frames, &Frame::tracks, track_scale);
    if (trail.size() + tracks.size() <= kMostPackedBytes || frames.size() <= 2) break;
    kept.thin();
  }
  const auto& size = rasters_.newest().now;
  Json json = {{"width", size.width},
               {"height", size.height},
               {"cells_a_pixel", rasters_.cells_a_pixel()},
               {"reads_all", rasters_.reads_all()}};
  for (const char* name : {"iterations", "arrived", "ants"}) json[name] = Json::array();
  for (const Frame& f : kept.all()) {
    json["arrived"].push_back(f.arrived);
    json["ants"].push_back(f.ants);
  }
  set_paths(json, kept.all());
  json["trail"] =
      colony_ ? trail_scale.json(index_ ? "terminal index" : "pheromone", trail) : Json(nullptr);
  json["proof"] = {{"ms", told_ms_}, {"best", told_best_}, {"bound", told_bound_}};
  const bool ants = rasters_.newest().ants > 0;
  json["tracks"] = ants ? track_scale.json("ants through a cell", tracks) : Json(nullptr);
  return json;
}

}  // namespace lasius::tool
