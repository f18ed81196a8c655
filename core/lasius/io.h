// Component lasius::io: PNG and ROS map_server YAML, and every other map format through one door;
// parameters and answers as JSON.
#pragma once

#include <string>

#include "lasius/grid/grid.h"
#include "lasius/grid/map_io.h"
#include "lasius/io/json.h"
#include "lasius/io_export.h"

namespace lasius {

/// Reads a map of any kind: .map, PBM, PGM, BMP and PNG, told apart by content, and ROS map_server
/// YAML, known by its name (.yaml, .yml, small or capital). PNG is read row by row, interlaced or
/// not.
///
/// PNG and BMP: colours count by their luma (Rec. 709 weights of the stored values, gamma is
/// ignored), what is transparent is seen on a white page, and the pixel then counts as in
/// ReadOptions::free_below.
///
/// ROS: the image (PNG, PGM, PBM or BMP; its path relative to the YAML file) by the rules of
/// map_server in nav2, with p = darkness, or lightness where `negate` is set:
/// - trinary: p >= occupied_thresh is blocked, p <= free_thresh is free; between them, and where
///   the image is not opaque, it is unknown.
/// - scale: as trinary, but between them s = (p - free_thresh) / (occupied_thresh - free_thresh)
///   is free where s < free_below.
/// - raw: the stored grey v in 0 .. 255 is the occupancy. Up to 100 it is free where
///   v / 100 < free_below, above it is unknown; `negate` and opacity do not count.
///
/// Unknown is blocked unless ReadOptions::unknown_is_free; either way Map::unknown tells which
/// cells are. `frame` holds resolution and origin. `mode` may be written in capitals; any whole
/// number but 0 negates.
/// @throws Error(file_missing, file_broken, file_unsupported), naming the file, the line of a text
///         format or the byte offset of a binary one, and the remedy; Error(invalid_parameter) for
///         free_below out of range.
LASIUS_IO_EXPORT Map read_any_map(const std::string& path, const ReadOptions& options = {});

/// Writes .map, .pbm or .png by the name's ending, whole or not at all; blocked cells of a PNG are
/// black, free ones white. @throws as write_map.
LASIUS_IO_EXPORT void write_any_map(const Grid& grid, const std::string& path);

/// Writes a PNG of 1 bit a pixel: blocked black, free white. @throws Error(output_failed)
LASIUS_IO_EXPORT void write_png(const Grid& grid, const std::string& path);

}  // namespace lasius
