// What is there and what the robot knows of it, a code a pixel: of films and reports.
#pragma once

#include <cstdint>

#include "lasius/drive.h"
#include "tools/draw/raster.h"
#include "tools/drive/drive_recorder.h"

namespace lasius::tool::tick_codes {

inline constexpr int kShades = 4;  ///< of walls that fill a pixel in part

/// Codes: first the two of free cells, then kShades for each kind of wall on both. Reports' pages
/// read them too (report/page/drive_page.js).
enum Code : std::uint8_t { kUnseen, kSeen, kWalls };
enum Wall : std::uint8_t { kKnown, kUnknown, kBelieved, kWallKinds };
inline constexpr std::uint8_t kCodes = kWalls + 2 * kWallKinds * kShades;  ///< how many there are

/// The map on at most columns x rows pixels. `recorder` has observed the tick.
Raster<std::uint8_t> codes_of(const DriveTick& tick, const DriveRecorder& recorder, int columns,
                              int rows);

}  // namespace lasius::tool::tick_codes
