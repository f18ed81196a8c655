// Grey levels of an image and occupancies of a ROS map, as layers of costs have them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lasius/grid/map_io.h"
#include "lasius/io.h"

namespace lasius {

// Exported for the program only; not part of the public API.
struct GreyImage {
  int width = 0, height = 0;
  int white = 255;                    ///< the largest level that a pixel could have
  std::vector<std::uint16_t> levels;  ///< row by row from the top; 0 is black
};

/// Reads PNG, PGM, PBM or BMP; colours by their luma, on a white page where they are transparent.
/// @throws as read_any_map.
LASIUS_IO_EXPORT GreyImage read_grey_image(const std::string& path);

/// The occupancy grid that map_server makes of a ROS map.
struct OccupancyImage : GreyImage {
  static constexpr int kUnknown = 127;  ///< the level of an unknown cell; others have 0 to 100
  WorldFrame frame;
  std::string image;  ///< the file of the pixels
};

/// Reads a ROS map by the rules of map_server in nav2, its `mode` as written: dark is dear, or
/// light where `negate` is set; in mode scale, between the thresholds, the nearest whole percent.
/// @throws as read_any_map.
LASIUS_IO_EXPORT OccupancyImage read_occupancy(const std::string& yaml);

}  // namespace lasius
