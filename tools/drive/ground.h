// What is there and what the robot knows of it, a code a pixel: of films and reports.
#pragma once

#include <cstdint>

#include "lasius/drive/drive.h"
#include "tools/draw/raster.h"
#include "tools/drive/drive_recorder.h"

namespace lasius::tool::tick_codes {

inline constexpr int kShades = 4;  ///< of walls that fill a pixel in part

/// Codes: first the two of free cells, then kShades for each kind of wall on both. Reports' pages
/// read them too (report/page/drive_page.js).
enum Code : std::uint8_t { kUnseen, kSeen, kWalls };
enum Wall : std::uint8_t { kKnown, kUnknown, kBelieved, kWallKinds };
inline constexpr std::uint8_t kCodes = kWalls + 2 * kWallKinds * kShades;  ///< how many there are

/// The map tick by tick: a tick costs what it changes.
class Ground {
 public:
  /// On at most columns x rows pixels.
  Ground(const Grid& map, int columns, int rows);

  /// The codes of a tick, not before the last one asked for, which `recorder` has observed.
  const Raster<std::uint8_t>& codes(const DriveTick& tick, const DriveRecorder& recorder);

 private:
  Span changed(const Grid& there, const Grid& known, const DriveRecorder& recorder,
               Span rows) const;

  Grid there_, known_;  // in the last tick
  std::int64_t tick_;   // its number
  Raster<std::uint8_t> codes_;
  bool begun_ = false;
};

}  // namespace lasius::tool::tick_codes
