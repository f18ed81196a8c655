// What a report plays of a run on a bitmap, gathered while it goes.
#pragma once

#include <memory>
#include <vector>

#include "tools/bitmap/picture_recorder.h"
#include "tools/record/json_values.h"
#include "tools/report/key_frames.h"

namespace lasius::tool {

/// Keeps trail, tracks and best path of every iteration, or of a long run of every second, fourth,
/// ... one, on rasters of at most kMostPixels a side: at most kMostBytes, whatever map and run.
class RunFrames {
 public:
  static constexpr int kMostPixels = 400;
  static constexpr std::int64_t kReadAll = std::int64_t{1} << 17;  ///< as PictureRecorder::Limits
  static constexpr std::size_t kMostBytes = 48U << 20;
  static constexpr std::size_t kMostFrames = 400;
  static constexpr std::size_t kMostPathVertices = 2000;  ///< of a path that a frame keeps

  /// `grid` must outlive it.
  RunFrames(const Grid& grid, const Params& params);

  void observe(const GridProgress& progress);

  /// Null where there was nothing to observe; else
  ///   width, height, cells_a_pixel   of the rasters
  ///   reads_all                      whether the trail was read far from all tracks, too
  ///   iterations, arrived, ants      of each frame, iterations from 1
  ///   trail {name, least, most, logarithmic, frames}, tracks {the same}   see page/heat_map.js;
  ///                                  null: a search without
  ///   paths, path_of                 [[[x, y]...]...], and the number of each frame's path, or -1
  /// Frames are left out until they take at most kMostPackedBytes.
  Json json() const;

 private:
  using Path = std::vector<Point>;
  struct Frame {
    int iteration = 0, ants = 0, arrived = 0;
    std::vector<float> trail;
    std::vector<std::uint16_t> tracks;
    std::shared_ptr<const Path> path;  ///< shared with the frame before where it is the same
  };
  Frame frame() const;
  void keep_path(const GridProgress& progress);

  PictureRecorder rasters_;
  bool colony_, index_;
  KeyFrames<Frame> frames_;
  double best_ = 0;  ///< length of path_
  std::shared_ptr<const Path> path_;
};

}  // namespace lasius::tool
