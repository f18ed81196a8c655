#include "lasius/grid/map_io.h"

#include <cmath>
#include <string_view>

#include "core/base/invalid_parameter.h"
#include "core/base/output.h"
#include "core/map_files/bmp.h"
#include "core/map_files/byte_reader.h"
#include "core/map_files/movingai.h"
#include "core/map_files/pixel_rule.h"
#include "core/map_files/pnm.h"
#include "lasius/base/error.h"

namespace lasius {

Point WorldFrame::to_cells(Point world, int height) const noexcept {
  const double dx = world.x - origin_x;
  const double dy = world.y - origin_y;
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return {(c * dx + s * dy) / resolution, height - (c * dy - s * dx) / resolution};
}

Point WorldFrame::to_world(Point cells, int height) const noexcept {
  const double u = cells.x * resolution;
  const double v = (height - cells.y) * resolution;
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return {origin_x + c * u - s * v, origin_y + s * u + c * v};
}

PixelRule plain_rule(double free_below) {
  require_parameter(free_below > 0 && free_below <= 1, "free_below", free_below,
                    "it must lie above 0 and be at most 1");
  return {[free_below](int level, int white) {
    return white - level >= free_below * white ? PixelRule::kBlocked : PixelRule::kFree;
  }};
}

Map read_map(const std::string& path, const ReadOptions& options) {
  const PixelRule rule = plain_rule(options.free_below);
  InputFile file(path);
  ByteReader& in = file.reader();
  const std::string_view head = in.ahead(8);
  if (is_movingai(head)) return {read_movingai(in), std::nullopt};
  if (is_pnm(head)) return read_pnm(in, rule);
  if (is_bmp(head)) return read_bmp(in, rule);
  in.fail_at_offset(0, "this is no MovingAI .map, PBM, PGM or BMP file",
                    "convert it, or read PNG and ROS YAML maps with lasius::io",
                    ErrorCode::file_unsupported);
}

void write_map(const Grid& grid, const std::string& path) {
  const auto write = [&]() -> void (*)(const Grid&, std::ostream&) {
    if (has_ending(path, ".pbm")) return write_pbm;
    if (has_ending(path, ".map") || is_stream(path)) return write_movingai;
    refuse("cannot tell the format of '" + path + "'", "end its name in .map or .pbm");
  }();
  write_file(path, [&](std::ostream& out) { write(grid, out); });
}

}  // namespace lasius
