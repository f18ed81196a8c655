// Maps on disk: MovingAI .map, PBM, PGM, BMP here; PNG and ROS YAML in the component lasius::io.
#pragma once

#include <optional>
#include <string>

#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// Pose of a map in the world, as ROS map_server gives it: the lower left corner of the lower left
/// cell lies at (origin_x, origin_y), the map turned by `yaw` about it; world y points up.
struct LASIUS_EXPORT WorldFrame {
  double resolution = 1;  ///< metres per cell, > 0
  double origin_x = 0;    ///< metres
  double origin_y = 0;    ///< metres
  double yaw = 0;         ///< radians

  /// Metres to continuous cell coordinates of a map `height` cells high, and back. A cell holds its
  /// left and its lower edge: the one of a point (x, y) is {floor(x), ceil(y) - 1}.
  Point to_cells(Point world, int height) const noexcept;
  /// The other way round.
  Point to_world(Point cells, int height) const noexcept;
};

/// A map as read from a file.
struct Map {
  Grid grid;                        ///< row 0 at the top
  std::optional<WorldFrame> frame;  ///< only where the file gives one
  std::string image = {};           ///< of a ROS map the file of its image, else empty
  /// Of a ROS map the unknown cells, as the blocked ones of a grid of the same size.
  std::optional<Grid> unknown = {};
};

/// How grey values and unknown cells become free or blocked: dark is blocked.
struct ReadOptions {
  bool unknown_is_free = false;  ///< ROS maps: unknown cells count as free
  /// PGM, PNG and BMP: a pixel of darkness (white - grey) / white below this is free, in (0, 1]. At
  /// the default 0.5 the greys 128 .. 255 of 255 are free. Black pixels (1) of a PBM are blocked.
  double free_below = 0.5;
};

/// Reads .map, .pbm, .pgm or uncompressed .bmp (1, 4, 8, 24 or 32 bits a pixel), told apart by
/// content; row by row, without a buffer of the whole file. A .map's '.', 'G' and 'S' are free,
/// '@', 'O', 'T' and 'W' blocked; colours of a .bmp count by their luma, as in io.h. A UTF-8 byte
/// order mark is stepped over. The map is returned whole or not at all.
/// @throws Error(file_missing, file_broken, file_unsupported), naming the file, the line of a text
///         format or the byte offset of a binary one, and the remedy; Error(invalid_parameter) for
///         free_below out of range.
LASIUS_EXPORT Map read_map(const std::string& path, const ReadOptions& options = {});

/// Writes .map or .pbm by the name's ending, whole or not at all; to a device or pipe, as
/// /dev/stdout, of another ending a .map. A file that is replaced passes on its permissions.
/// @throws Error(output_failed), or Error(invalid_parameter) for another ending.
LASIUS_EXPORT void write_map(const Grid& grid, const std::string& path);

}  // namespace lasius
