// What a report plays of a drive, gathered while it goes.
#pragma once

#include <vector>

#include "lasius/drive/drive.h"
#include "tools/drive/drive_recorder.h"
#include "tools/drive/ground.h"
#include "tools/record/json_values.h"
#include "tools/report/key_frames.h"

namespace lasius::tool {

/// Keeps every tick, or of a long drive every second, fourth, ... one, and the arrival, on rasters
/// of at most kMostPixels a side.
class DriveFrames {
 public:
  static constexpr int kMostPixels = 400;
  static constexpr std::size_t kMostFrames = 300;
  static constexpr std::size_t kMostClearances = 4096;
  static constexpr std::size_t kMostWayVertices = 500;  ///< of a way that a frame keeps

  /// `radius` is the robot's, in cells.
  DriveFrames(const Grid& map, double radius);

  /// `recorder` has observed the tick.
  void observe(const DriveTick& tick, const DriveRecorder& recorder);

  /// Null for a drive that never began; else
  ///   width, height, codes   of the rasters, and what is on them: see tools/drive/ground.h
  ///   ticks, robots          of each frame
  ///   obstacles              [[x, y, width, height]...] of each frame
  ///   ways, way_lengths      all ways one after another [x, y...], packed; vertices of each
  ///   clearances             {step, values, last, most}: from the robot, as large as it is, to
  ///                          what was blocked then, in cells, every `step` ticks and at the last
  ///                          one; more counts as `most`
  /// Frames are left out until they take at most kMostPackedBytes.
  Json json() const;

 private:
  struct Frame {
    std::int64_t tick;
    Cell robot;
    std::vector<Rectangle> obstacles;
    std::vector<float> way;
    std::vector<std::uint8_t> codes;
  };

  int width_, height_;
  tick_codes::Ground ground_;
  double radius_;
  KeyFrames<Frame> frames_{kMostFrames};
  KeyFrames<double> clearances_{kMostClearances};
  double last_clearance_ = 0;
};

}  // namespace lasius::tool
