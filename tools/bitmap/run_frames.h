// What a report plays of a run on a bitmap, gathered while it goes.
#pragma once

#include <chrono>
#include <vector>

#include "tools/bitmap/picture_recorder.h"
#include "tools/record/json_values.h"
#include "tools/report/key_frames.h"
#include "tools/report/path_frames.h"

namespace lasius::tool {

/// Keeps trail, tracks and best path of every iteration, or of a long run of every second, fourth,
/// ... one, on rasters of at most kMostPixels a side: at most kMostBytes, whatever map and run.
class RunFrames {
 public:
  static constexpr int kMostPixels = 400;
  static constexpr std::int64_t kReadAll = std::int64_t{1} << 17;  ///< as PictureRecorder::Limits
  static constexpr std::size_t kMostBytes = 48U << 20;
  static constexpr std::size_t kMostFrames = 400;

  /// `grid` must outlive it.
  RunFrames(const Grid& grid, const Params& params);

  void observe(const GridProgress& progress);

  /// Null where there was nothing to observe; else
  ///   width, height, cells_a_pixel   of the rasters
  ///   reads_all                      whether the trail was read far from all tracks, too
  ///   iterations, paths, path_of     see set_paths
  ///   arrived, ants                  of each frame
  ///   trail {name, least, most, logarithmic, frames}, tracks {the same}   see page/heat_map.js;
  ///                                  null: a search without
  ///   proof {ms, best, bound}        of a search that knows a bound, whenever it told of a path
  /// Frames are left out until they take at most kMostPackedBytes.
  Json json() const;

 private:
  struct Frame : PathFrame {
    int ants = 0, arrived = 0;
    std::vector<float> trail;
    std::vector<std::uint16_t> tracks;
  };
  Frame frame() const;

  PictureRecorder rasters_;
  bool colony_, index_;
  KeyFrames<Frame> frames_;
  PathFrame newest_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::vector<double> told_ms_, told_best_, told_bound_;
};

}  // namespace lasius::tool
