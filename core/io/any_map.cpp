#include <filesystem>
#include <string_view>

#include "core/base/file_kind.h"
#include "core/base/output.h"
#include "core/io/grey_image.h"
#include "core/io/png_reader.h"
#include "core/io/ros_map.h"
#include "core/map_files/bmp.h"
#include "core/map_files/byte_reader.h"
#include "core/map_files/movingai.h"
#include "core/map_files/pixel_rule.h"
#include "core/map_files/pnm.h"
#include "lasius/error.h"
#include "lasius/io.h"

namespace lasius {
namespace {

constexpr std::size_t kHead = 8;

bool is_yaml_name(const std::string& path) {
  return has_ending(path, ".yaml") || has_ending(path, ".yml");
}

Map read_image(ByteReader& in, const PixelRule& rule) {
  const std::string_view head = in.ahead(kHead);
  if (is_png(head)) return read_png(in, rule);
  if (is_pnm(head)) return read_pnm(in, rule);
  if (is_bmp(head)) return read_bmp(in, rule);
  in.fail_at_offset(0, "this is no PNG, PGM, PBM or BMP image", "convert it",
                    ErrorCode::file_unsupported);
}

/// Puts two bits of each pixel's level in their place.
void add_bits(const Map& map, int shift, GreyImage& image) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int bits = map.grid.blocked({x, y}) + 2 * map.unknown->blocked({x, y});
      image.levels[static_cast<std::size_t>(y) * image.width + x] |=
          static_cast<std::uint16_t>(bits << shift);
    }
  }
}

Map read_ros_map(ByteReader& in, const ReadOptions& options) {
  const RosMap ros = read_ros_yaml(in);
  const auto image = std::filesystem::path(in.name()).parent_path() / ros.image;
  try {
    InputFile file(image.string());
    Map map = read_image(file.reader(), ros_rule(ros, options));
    map.frame = ros.frame;
    map.image = image.string();
    return map;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::file_missing) throw;
    in.fail_at_line(ros.image_line, "its image " + image.string() + " " + error.problem(),
                    "correct 'image', which is relative to the YAML file", ErrorCode::file_missing);
  }
}

}  // namespace

Map read_any_map(const std::string& path, const ReadOptions& options) {
  const PixelRule rule = plain_rule(options.free_below);
  InputFile file(path);
  ByteReader& in = file.reader();
  const std::string_view head = in.ahead(kHead);
  if (is_movingai(head)) return {read_movingai(in), std::nullopt};
  if (is_png(head) || is_pnm(head) || is_bmp(head)) return read_image(in, rule);
  constexpr const char* kMaps =
      "give a MovingAI .map, a PBM, PGM, PNG or BMP image, or a ROS map's .yaml";
  refuse_other_kinds(in.ahead(ByteReader::kBuffer), path, {FileKind::ros_map, FileKind::image},
                     kMaps);
  if (is_yaml_name(path)) return read_ros_map(in, options);
  in.fail_at_offset(0, "this is no map that is read", kMaps, ErrorCode::file_unsupported);
}

// Readers tell two bits of each pixel. So an image is read once for each two bits of its levels,
// and none of them has to know of grey.
GreyImage read_grey_image(const std::string& path) {
  GreyImage image;
  PixelRule rule{.kind = {}, .unknown = PixelRule::kUnknown};
  for (int shift = 0; shift == 0 || image.white >> shift > 0; shift += 2) {
    rule.kind = [&](int level, int white) {
      image.white = white;
      return level >> shift & 3;
    };
    InputFile file(path);
    const Map map = read_image(file.reader(), rule);
    image.width = map.grid.width();
    image.height = map.grid.height();
    image.levels.resize(static_cast<std::size_t>(image.width) * image.height);
    add_bits(map, shift, image);
  }
  return image;
}

void write_any_map(const Grid& grid, const std::string& path) {
  if (has_ending(path, ".png")) return write_png(grid, path);
  try {
    write_map(grid, path);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_parameter) throw;
    throw Error(error.code(), error.problem(), "end its name in .map, .pbm or .png");
  }
}

}  // namespace lasius
