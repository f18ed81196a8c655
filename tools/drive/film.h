// The film of a drive, drawn while it goes.
#pragma once

#include <cstdint>
#include <iosfwd>

#include "lasius/drive/drive.h"
#include "tools/drive/drive_recorder.h"
#include "tools/drive/ground.h"
#include "tools/report/key_frames.h"

namespace lasius::tool {

/// Draws every tick, or of a long drive every second, fourth, ... one, and the arrival: at most
/// kMostFrames + 1 frames of at most kMostSide pixels a side. A colour says what is there and what
/// the robot knows: see docs/driving.md.
class Film {
 public:
  static constexpr int kMostFrames = 300;
  static constexpr int kMostSide = 500;

  Film(const Grid& map, Cell goal);

  /// `recorder` has observed the tick.
  void observe(const DriveTick& tick, const DriveRecorder& recorder);
  void write(std::ostream& out) const;

 private:
  using Frame = Raster<std::uint8_t>;
  Frame drawn(const DriveTick& tick, const DriveRecorder& recorder);
  Span pixels(int cell, int cells, int side) const;
  void draw_cells(Frame& frame, const DriveTick& tick, const DriveRecorder& recorder);
  void draw_line(Frame& frame, Point from, Point to, std::uint8_t colour) const;
  void draw_disc(Frame& frame, Point at, double radius, std::uint8_t colour) const;

  double scale_;  ///< pixels a cell
  int width_, height_;
  Cell goal_;
  tick_codes::Ground ground_;
  Frame track_;    ///< what it draws on every frame: where the robot was
  Point robot_{};  ///< in the tick before
  KeyFrames<Frame> frames_{kMostFrames};
};

}  // namespace lasius::tool
