#include "tools/bitmap/cost_layers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/base/number_text.h"
#include "core/base/output.h"
#include "core/io/grey_image.h"
#include "core/map_files/byte_reader.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

constexpr bool kBigHost = std::endian::native == std::endian::big;

/// Values row by row from the top.
struct LayerValues {
  int width = 0, height = 0;
  std::vector<double> values = {};
};

[[noreturn]] void refuse_layer(const std::string& file, const std::string& problem,
                               ErrorCode code = ErrorCode::file_broken) {
  throw Error(code, {.file = file}, problem,
              "give a PNG, a PGM, a PFM of one channel or a .npy of whole numbers, float32 or "
              "float64, of the map's size");
}

template <class Number>
Number number_at(std::string_view bytes, std::size_t i, bool swapped) {
  char digits[sizeof(Number)];
  std::memcpy(digits, bytes.data() + i * sizeof(Number), sizeof(Number));
  if (swapped) std::reverse(digits, digits + sizeof(Number));
  Number number;
  std::memcpy(&number, digits, sizeof(Number));
  return number;
}

template <class Number>
void read_values(const std::string& file, std::string_view bytes, bool big, LayerValues& to) {
  const std::size_t count = static_cast<std::size_t>(to.width) * to.height;
  if (bytes.size() != count * sizeof(Number))
    refuse_layer(file, "it has " + number_text(bytes.size()) + " bytes of values, " +
                           size_text(to.width, to.height) + " take " +
                           number_text(count * sizeof(Number)));
  const bool swapped = big != kBigHost;
  to.values.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    to.values.push_back(static_cast<double>(number_at<Number>(bytes, i, swapped)));
}

void set_size(const std::string& file, std::int64_t width, std::int64_t height, LayerValues& to) {
  if (width < 1 || height < 1 || width > Grid::kMaxSide || height > Grid::kMaxSide)
    refuse_layer(file, "its size is " + size_text(width, height));
  to.width = static_cast<int>(width);
  to.height = static_cast<int>(height);
}

/// Rows from the bottom, as the format has them.
LayerValues read_pfm(const std::string& file, const std::string& bytes) {
  std::istringstream head(bytes.substr(0, 200));
  std::string kind;
  std::int64_t width = 0, height = 0;
  double scale = 0;
  head >> kind >> width >> height >> scale;
  if (!head || scale == 0 || head.get() == std::char_traits<char>::eof())
    refuse_layer(file, "its head is no PFM's");
  LayerValues raster;
  set_size(file, width, height, raster);
  const auto begin = static_cast<std::size_t>(head.tellg());
  read_values<float>(file, std::string_view(bytes).substr(begin), scale > 0, raster);
  for (int y = 0; y < raster.height / 2; ++y) {
    const auto row = raster.values.begin() + std::ptrdiff_t{y} * raster.width;
    std::swap_ranges(row, row + raster.width,
                     raster.values.end() - (y + 1) * std::ptrdiff_t{raster.width});
  }
  return raster;
}

/// What stands behind 'KEY': in the head of a .npy.
std::string_view behind(std::string_view head, std::string_view key) {
  const auto at = head.find("'" + std::string(key) + "':");
  return at == head.npos ? std::string_view() : head.substr(at + key.size() + 3);
}

/// Column by column as row by row.
void transpose(LayerValues& raster) {
  std::vector<double> rows;
  rows.reserve(raster.values.size());
  for (int y = 0; y < raster.height; ++y)
    for (int x = 0; x < raster.width; ++x)
      rows.push_back(raster.values[static_cast<std::size_t>(x) * raster.height + y]);
  raster.values = std::move(rows);
}

LayerValues read_npy(const std::string& file, std::string_view bytes) {
  // Magic, version, length of the head in two bytes, or from version 2 on in four.
  const std::size_t before = bytes.size() > 6 && bytes[6] > 1 ? 12 : 10;
  if (bytes.size() < before || bytes[6] < 1 || bytes[6] > 3)
    refuse_layer(file, "it is no .npy of version 1 to 3");
  const std::size_t length = before == 10 ? number_at<std::uint16_t>(bytes.substr(8), 0, kBigHost)
                                          : number_at<std::uint32_t>(bytes.substr(8), 0, kBigHost);
  if (bytes.size() < before + length) refuse_layer(file, "it ends in its head");
  const std::string_view head = bytes.substr(before, length);
  const std::string_view values = bytes.substr(before + length);
  std::istringstream shape{std::string(behind(head, "shape"))};
  char open = 0, comma = 0, close = 0;
  std::int64_t width = 0, height = 0;
  shape >> open >> height >> comma >> width >> close;
  if (open != '(' || comma != ',' || close != ')')
    refuse_layer(file, "it is not of two dimensions");
  LayerValues raster;
  set_size(file, width, height, raster);
  const std::string_view type = behind(head, "descr").substr(0, 6);
  const bool big = type.starts_with(" '>");
  const auto read = [&]<class Number>(const char* ending, Number) {
    if (type.ends_with(ending)) read_values<Number>(file, values, big, raster);
  };
  read("f8'", double{});
  read("f4'", float{});
  read("b1'", std::uint8_t{});
  read("u1'", std::uint8_t{});
  read("u2'", std::uint16_t{});
  read("u4'", std::uint32_t{});
  read("i1'", std::int8_t{});
  read("i2'", std::int16_t{});
  read("i4'", std::int32_t{});
  read("i8'", std::int64_t{});
  if (raster.values.empty())
    refuse_layer(file, "its numbers are of another type", ErrorCode::file_unsupported);
  if (behind(head, "fortran_order").starts_with(" True")) transpose(raster);
  return raster;
}

[[noreturn]] void refuse_size(const std::string& file, int width, int height, const Grid& grid) {
  refuse_layer(file, "it has " + size_text(width, height) + " values, the map " +
                         size_text(grid.width(), grid.height()) + " cells");
}

/// White is 1.
LayerValues read_grey(const std::string& file) {
  const GreyImage image = read_grey_image(file);
  LayerValues raster{.width = image.width, .height = image.height};
  raster.values.reserve(image.levels.size());
  for (const int level : image.levels)
    raster.values.push_back(static_cast<double>(level) / image.white);
  return raster;
}

/// A ROS map's occupancy over 100, as the map's cells have it by their centres; blocks those of
/// 100, 0 where unknown and outside of it.
LayerValues read_ros_layer(const std::string& file, const std::optional<WorldFrame>& frame,
                           Grid& grid, std::string& image, bool& meets) {
  const OccupancyImage layer = read_occupancy(file);
  image = layer.image;
  if (!frame && (layer.width != grid.width() || layer.height != grid.height()))
    refuse_size(file, layer.width, layer.height, grid);
  LayerValues raster{.width = grid.width(), .height = grid.height()};
  raster.values.assign(static_cast<std::size_t>(raster.width) * raster.height, 0);
  for (int y = 0; y < raster.height; ++y) {
    for (int x = 0; x < raster.width; ++x) {
      Point place{x + 0.5, y + 0.5};
      if (frame) place = layer.frame.to_cells(frame->to_world(place, raster.height), layer.height);
      if (!(place.x >= 0 && place.x < layer.width && place.y > 0 && place.y <= layer.height))
        continue;
      meets = true;
      const auto column = static_cast<std::size_t>(place.x);
      const auto row = static_cast<std::size_t>(std::ceil(place.y) - 1);
      const int percent = layer.levels[row * layer.width + column];
      if (percent == 100) grid.set_blocked({x, y});
      if (percent != OccupancyImage::kUnknown)
        raster.values[static_cast<std::size_t>(y) * raster.width + x] = percent / 100.0;
    }
  }
  return raster;
}

LayerValues read_layer(const std::string& file, const Grid& grid) {
  constexpr std::int64_t kHead = 1 << 16;  // bytes, at most
  const std::int64_t most = kHead + std::int64_t{8} * grid.width() * grid.height();
  char magic[6] = {};
  std::ifstream(file, std::ios::binary).read(magic, sizeof magic);
  const std::string_view kind(magic, sizeof magic);
  if (kind == "\x93NUMPY") return read_npy(file, read_text(file, most));
  if (kind.starts_with("Pf")) return read_pfm(file, read_text(file, most));
  return read_grey(file);
}

}  // namespace

LoadedCosts load_costs(Grid& grid, const std::optional<WorldFrame>& frame, const CostLayers& asked,
                       bool metres, double radius) {
  LoadedCosts costs{.asked = asked, .field = CostField(grid.width(), grid.height())};
  for (const auto& [file, factor] : asked.layers) {
    std::uint64_t hash = file_hash(file);
    LayerValues raster;
    if (has_ending(file, ".yaml") || has_ending(file, ".yml")) {
      std::string& image = costs.images.emplace_back();
      bool meets = false;
      raster = read_ros_layer(file, frame, grid, image, meets);
      if (!meets)
        costs.notes.push_back("--cost " + file +
                              " has no effect: by its frame it lies outside of the map");
      hash = file_hash(image, hash);
    } else {
      raster = read_layer(file, grid);
    }
    if (raster.width != grid.width() || raster.height != grid.height())
      refuse_size(file, raster.width, raster.height, grid);
    const auto bad = std::ranges::find_if(
        raster.values, [](double value) { return !std::isfinite(value) || value < 0; });
    if (bad != raster.values.end()) {
      const auto i = static_cast<int>(bad - raster.values.begin());
      refuse_layer(file, "it holds " + number_text(*bad) + " in cell " +
                             pair_text(i % raster.width, i / raster.width));
    }
    costs.field.add(raster.values, factor);
    costs.hashes.push_back(hash);
  }
  inflate(costs, grid, frame, metres, radius);
  return costs;
}

double cells_in(double length, double resolution) {
  const double cells = length / resolution, whole = std::round(cells);
  return std::abs(cells - whole) <= 1e-12 * cells ? whole : cells;
}

void inflate(LoadedCosts& costs, const Grid& grid, const std::optional<WorldFrame>& frame,
             bool metres, double radius) {
  if (!costs.asked.inflation) return;
  const auto [reach, scaling, weight] = *costs.asked.inflation;
  const double cell = metres ? frame->resolution : 1;
  costs.inflation = {.radius = cells_in(reach, cell),
                     .scaling = scaling * cell,
                     .weight = weight,
                     .inscribed = std::max(1.0, radius)};
  costs.field.add(grid, *costs.inflation);
  if (costs.inflation->radius >= 1) return;  // from centre to centre
  costs.notes.push_back("--inflation has no effect: its radius of " +
                        number_text(costs.inflation->radius) + " cells reaches no other cell" +
                        (frame && !metres && frame->resolution != 1
                             ? "; with --frame world its radius is in metres"
                             : ""));
}

}  // namespace lasius::tool
