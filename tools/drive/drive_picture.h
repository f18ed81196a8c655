// The picture of a drive: its track over what was there.
#pragma once

#include <string>

#include "tools/drive/drive_answer.h"
#include "tools/drive/drive_recorder.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// What drives where, as pictures and pages are headed.
std::string drive_title(const DriveAnswer& answer, const RunOptions& run);

/// One panel: the world as it was at last, shaded by when the robot saw it; walls that the map has
/// not, by when they were learned; those that only the map has; the track, with a mark where a way
/// was planned; the tracks of moving obstacles, and where they were at last.
void write_drive_picture(const std::string& file, const RunOptions& run, const DriveAnswer& answer,
                         const DriveRecorder& recorder);

}  // namespace lasius::tool
