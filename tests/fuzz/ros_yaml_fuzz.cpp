// The YAML file of a ROS map, and the pixel rule that it makes.
#include <cmath>

#include "core/io/ros_map.h"
#include "tests/fuzz/reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lasius;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto ros = fuzz::read_bytes(bytes, true, [](ByteReader& in) { return read_ros_yaml(in); });
  if (!ros) return 0;
  fuzz::require(ros->frame.resolution > 0 && std::isfinite(ros->frame.yaw) && !ros->image.empty());
  for (const bool unknown_is_free : {false, true}) {
    const PixelRule rule = ros_rule(*ros, {.unknown_is_free = unknown_is_free});
    fuzz::require(rule.table(1).size() == 2 && rule.table(65535).size() == 65536);
  }
  return 0;
}
