#include <cmath>
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
#include "lasius/base/error.h"
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

/// Numbers of an image's pixels in place of a map.
void read_numbers(const std::string& path, PixelRule rule, GreyImage& to) {
  rule.numbers = &to.levels;
  InputFile file(path);
  const Map map = read_image(file.reader(), rule);
  to.width = map.grid.width();
  to.height = map.grid.height();
}

/// What `read` makes of the file of a ROS map's image.
template <class Read>
auto of_ros_image(ByteReader& in, const RosMap& ros, const Read& read) {
  const auto image = std::filesystem::path(in.name()).parent_path() / ros.image;
  try {
    return read(image.string());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::file_missing) throw;
    in.fail_at_line(ros.image_line, "its image " + image.string() + " " + error.problem(),
                    "correct 'image', which is relative to the YAML file", ErrorCode::file_missing);
  }
}

Map read_ros_map(ByteReader& in, const ReadOptions& options) {
  const RosMap ros = read_ros_yaml(in);
  return of_ros_image(in, ros, [&](const std::string& image) {
    InputFile file(image);
    Map map = read_image(file.reader(), ros_rule(ros, options));
    map.frame = ros.frame;
    map.image = image;
    return map;
  });
}

/// Percent, or OccupancyImage::kUnknown.
int occupancy(const RosMap& ros, int level, int white) {
  if (ros.mode == RosMap::Mode::raw) {
    const int grey = ros_grey(level, white);
    return grey > 100 ? OccupancyImage::kUnknown : grey;
  }
  const double p = ros_darkness(ros, level, white);
  if (p >= ros.occupied_thresh) return 100;
  if (p <= ros.free_thresh) return 0;
  if (ros.mode == RosMap::Mode::trinary) return OccupancyImage::kUnknown;
  return static_cast<int>(
      std::rint(100 * (p - ros.free_thresh) / (ros.occupied_thresh - ros.free_thresh)));
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

GreyImage read_grey_image(const std::string& path) {
  GreyImage image;
  const auto level_of = [&](int level, int white) {
    image.white = white;
    return level;
  };
  read_numbers(path, {.kind = level_of}, image);
  return image;
}

OccupancyImage read_occupancy(const std::string& yaml) {
  InputFile file(yaml);
  const RosMap ros = read_ros_yaml(file.reader());
  OccupancyImage made;
  made.frame = ros.frame;
  const bool raw = ros.mode == RosMap::Mode::raw;
  of_ros_image(file.reader(), ros, [&](const std::string& image) {
    made.image = image;
    const auto percent = [&](int level, int white) { return occupancy(ros, level, white); };
    using Transparent = PixelRule::Transparent;
    read_numbers(image,
                 {.kind = percent,
                  .unknown = OccupancyImage::kUnknown,
                  .transparent = raw ? Transparent::ignored : Transparent::unknown},
                 made);
    return 0;
  });
  return made;
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
