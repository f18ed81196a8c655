// The YAML file of a ROS map, and the pixel rule that it makes.
#include <cmath>

#include "core/io/ros_map.h"
#include "tests/fuzz/reading.h"

namespace lasius::fuzz {

void check(const std::string& bytes) {
  const auto ros = read_bytes(bytes, true, [](ByteReader& in) { return read_ros_yaml(in); });
  if (!ros) return;
  require(ros->frame.resolution > 0 && std::isfinite(ros->frame.yaw) && !ros->image.empty());
  for (const bool unknown_is_free : {false, true}) {
    const PixelRule rule = ros_rule(*ros, {.unknown_is_free = unknown_is_free});
    require(rule.table(1).size() == 2 && rule.table(65535).size() == 65536);
  }
}

}  // namespace lasius::fuzz
