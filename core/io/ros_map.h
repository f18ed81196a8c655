// The YAML file beside a ROS map image.
#pragma once

#include <string>

#include "core/map_files/byte_reader.h"
#include "core/map_files/pixel_rule.h"
#include "lasius/grid/map_io.h"

namespace lasius {

/// What a map_server YAML file says. Keys that it does not know are skipped, as map_server does.
struct RosMap {
  enum class Mode { trinary, scale, raw };

  std::string image;             ///< as written
  std::int64_t image_line = -1;  ///< where
  WorldFrame frame;
  Mode mode = Mode::trinary;
  bool negate = false;
  double occupied_thresh = 0;
  double free_thresh = 0;
};

/// @throws Error(file_broken) with the line.
RosMap read_ros_yaml(ByteReader& in);

/// Of a pixel, 0 to 1; lightness where `negate` is set.
double ros_darkness(const RosMap& ros, int level, int white);
/// Of a pixel, as its occupancy in mode raw: 0 to 255.
int ros_grey(int level, int white);

/// The cells' rule, as read_any_map states it.
PixelRule ros_rule(const RosMap& ros, const ReadOptions& options);

}  // namespace lasius
