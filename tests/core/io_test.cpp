#include "lasius/io.h"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "lasius/error.h"
#include "tests/core/map_files.h"

namespace lasius {
namespace {

using namespace std::string_literals;
using Bytes = std::vector<std::uint8_t>;

struct TestImage {
  int width, height;
  int depth, colour;
  std::vector<Bytes> rows;  // as PNG stores them
  bool interlaced = false;
  std::vector<png_color> palette = {};
  Bytes palette_alpha = {};
  int transparent_grey = -1;
};

void on_bytes(png_structp png, png_bytep bytes, size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

// Made by libpng itself; a mistake in a test image aborts the test program.
std::string png_of(const TestImage& image) {
  std::string content;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &content, on_bytes, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), image.depth, image.colour,
               image.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!image.palette.empty()) {
    png_set_PLTE(png, info, image.palette.data(), static_cast<int>(image.palette.size()));
  }
  if (!image.palette_alpha.empty()) {
    png_set_tRNS(png, info, image.palette_alpha.data(),
                 static_cast<int>(image.palette_alpha.size()), nullptr);
  }
  if (image.transparent_grey >= 0) {
    png_color_16 grey{};
    grey.gray = static_cast<png_uint_16>(image.transparent_grey);
    png_set_tRNS(png, info, nullptr, 0, &grey);
  }
  std::vector<png_bytep> rows;
  for (const Bytes& row : image.rows) rows.push_back(const_cast<png_bytep>(row.data()));
  png_set_rows(png, info, rows.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  return content;
}

class Io : public Files {
 protected:
  Grid read_image(const TestImage& image, const ReadOptions& options = {}) const {
    return read_any_map(file(png_of(image), "image.png"), options).grid;
  }
  /// A ROS map: the YAML's lines after those that every map has, and its image.
  Map read_ros(const std::string& lines, const std::string& image,
               const ReadOptions& options = {}) const {
    file(image, "image");
    return read_any_map(
        file("image: image\nresolution: 0.5\norigin: [1, 2, 0]\n" + lines, "map.yaml"), options);
  }
};

const std::string kTrinary = "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

TEST_F(Io, ReadsGreyOfEveryDepthAndInterlacing) {
  for (const int depth : {1, 2, 4, 8, 16}) {
    const int white = (1 << depth) - 1;
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 5}, {5, 3}, {8, 8}, {67, 13}}) {
      TestImage image{width, height, depth, PNG_COLOR_TYPE_GRAY, {}};
      Grid expected(width, height);
      unsigned state = 7;
      for (int y = 0; y < height; ++y) {
        Bytes row((static_cast<std::size_t>(width) * depth + 7) / 8);
        for (int x = 0; x < width; ++x) {
          state = state * 1664525 + 1013904223;
          const int level = static_cast<int>((state >> 8) % (white + 1U));
          expected.set_blocked({x, y}, 2 * (white - level) >= white);
          if (depth == 16) {
            row[2 * x] = static_cast<std::uint8_t>(level >> 8);
            row[2 * x + 1] = static_cast<std::uint8_t>(level);
          } else {
            const int bit = x * depth;
            row[bit / 8] |= static_cast<std::uint8_t>(level << (8 - depth - bit % 8));
          }
        }
        image.rows.push_back(row);
      }
      for (const bool interlaced : {false, true}) {
        image.interlaced = interlaced;
        EXPECT_EQ(read_image(image), expected)
            << depth << " bits, " << width << 'x' << height << (interlaced ? " interlaced" : "");
      }
    }
  }
}

TEST_F(Io, ReadsColoursByTheirLuma) {
  const Bytes rgb = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0, 128, 128, 128, 127, 127, 127};
  EXPECT_EQ(read_image({6, 1, 8, PNG_COLOR_TYPE_RGB, {rgb}}), grid_of({"#.#..#"}));
  const Bytes rgb16 = {0x7f, 0xff, 0x7f, 0xff, 0x7f, 0xff, 0x80, 0, 0x80, 0, 0x80, 0};
  EXPECT_EQ(read_image({2, 1, 16, PNG_COLOR_TYPE_RGB, {rgb16}}), grid_of({"#."}));
  for (const bool interlaced : {false, true}) {
    const TestImage image{3,
                          2,
                          4,
                          PNG_COLOR_TYPE_PALETTE,
                          {{0x01, 0x20}, {0x21, 0x00}},
                          interlaced,
                          {{255, 255, 255}, {0, 0, 200}, {0, 0, 0}},
                          {255, 255, 0}};
    EXPECT_EQ(read_image(image), grid_of({".#.", ".#."})) << "the third entry is transparent";
  }
}

TEST_F(Io, SeesTransparencyOnAWhitePage) {
  const Bytes grey_alpha = {0, 255, 0, 0, 0, 127, 0, 128, 255, 128};
  EXPECT_EQ(read_image({5, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {grey_alpha}}), grid_of({"#..#."}));
  const Bytes rgba16 = {0, 0, 0, 0, 0, 0, 0x7f, 0xff, 0, 0, 0, 0, 0, 0, 0x80, 0x00};
  EXPECT_EQ(read_image({2, 1, 16, PNG_COLOR_TYPE_RGB_ALPHA, {rgba16}}), grid_of({".#"}));
  TestImage keyed{3, 1, 8, PNG_COLOR_TYPE_GRAY, {{0, 9, 255}}};
  keyed.transparent_grey = 9;
  EXPECT_EQ(read_image(keyed), grid_of({"#.."})) << "grey 9 is transparent";
}

TEST_F(Io, FreeBelowHoldsForPng) {
  const TestImage image{4, 1, 8, PNG_COLOR_TYPE_GRAY, {{0, 50, 130, 255}}};
  EXPECT_EQ(read_image(image, {.free_below = 0.9}), grid_of({"#..."}));
  EXPECT_EQ(read_image(image, {.free_below = 0.3}), grid_of({"###."}));
  EXPECT_THROW(read_image(image, {.free_below = 0}), Error);
}

TEST_F(Io, ReadsEveryFormatByContent) {
  const Grid expected = grid_of({"#.", ".."});
  const std::string contents[] = {"type octile\nheight 2\nwidth 2\nmap\n@.\n..\n", "P1 2 2 1000",
                                  "P5 2 2 255\n\x01\xff\xff\xff",
                                  png_of({2, 2, 1, PNG_COLOR_TYPE_GRAY, {{0x40}, {0xc0}}})};
  for (const std::string& content : contents) {
    EXPECT_EQ(read_any_map(file(content, "map.yaml")).grid, expected);
    EXPECT_FALSE(read_any_map(file(content)).frame.has_value());
  }
}

TEST_F(Io, WritesWhatItReads) {
  for (const int width : {1, 7, 8, 64, 65, 131}) {
    Grid grid(width, 9);
    for (int i = 0; i < width * 9; i += 1 + i % 5) grid.set_blocked({i % width, i / width});
    for (const char* name : {"a.map", "a.pbm", "a.png"}) {
      write_any_map(grid, path(name));
      EXPECT_EQ(read_any_map(path(name)).grid, grid) << name << ", width " << width;
    }
  }
  EXPECT_EQ(files().size(), 3U) << "no temporary file is left";
  try {
    write_any_map(Grid(2, 2), path("a.jpg"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_parameter);
    EXPECT_NE(error.remedy().find(".png"), std::string::npos);
  }
}

TEST_F(Io, WritesPictures) {
  const Bytes rgb = {0, 0, 0, 255, 255, 255, 0, 255, 0, 0, 0, 255};
  write_png_rgb(path("a.png"), 2, 2, rgb);
  EXPECT_EQ(read_any_map(path("a.png")).grid, grid_of({"#.", ".#"}));
  EXPECT_THROW(write_png_rgb(path("a.png"), 3, 2, rgb), Error);
  EXPECT_THROW(write_png_rgb(path("a.png"), 0, 0, {}), Error);
  EXPECT_THROW(write_png_rgb(path("a.png"), -2, -2, rgb), Error);
  for (const char* name : {"none/a.png", "."}) {
    try {
      write_png_rgb(path(name), 2, 2, rgb);
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::output_failed) << name;
    }
  }
  EXPECT_THROW(write_png(Grid(300, 300), "/dev/full"), Error);
}

std::uint32_t crc_of(std::string_view bytes) {
  std::uint32_t crc = ~0U;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int i = 0; i < 8; ++i) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320U : crc >> 1;
  }
  return ~crc;
}

void put_number(std::string& content, std::size_t at, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i) {
    content[at + i] = static_cast<char>(number >> (24 - 8 * i) & 255);
  }
}

// A PNG whose header lies about its size.
std::string resized(std::string content, std::uint32_t width, std::uint32_t height) {
  put_number(content, 16, width);
  put_number(content, 20, height);
  put_number(content, 29, crc_of(std::string_view(content).substr(12, 17)));
  return content;
}

TEST_F(Io, RefusesEveryTruncatedPng) {
  for (const bool interlaced : {false, true}) {
    TestImage image{40, 30, 8, PNG_COLOR_TYPE_GRAY, {}, interlaced};
    for (int y = 0; y < 30; ++y) {
      Bytes row(40);
      for (int x = 0; x < 40; ++x) row[x] = static_cast<std::uint8_t>(x * x * 7 + y * y * 13);
      image.rows.push_back(row);
    }
    const std::string content = png_of(image);
    EXPECT_NO_THROW((void)read_any_map(file(content)));
    for (std::size_t size = 8; size < content.size(); ++size) {
      try {
        (void)read_any_map(file(content.substr(0, size)));
        FAIL() << size << " of " << content.size() << " bytes were read";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::file_broken) << error.what();
        EXPECT_GE(error.place().offset, 0) << error.what();
        EXPECT_LE(error.place().offset, static_cast<std::int64_t>(size)) << error.what();
      }
    }
  }
}

TEST_F(Io, ReadsOrRefusesEveryDamagedPng) {
  const std::string content =
      png_of({9, 5, 8, PNG_COLOR_TYPE_GRAY_ALPHA, std::vector<Bytes>(5, Bytes(18, 0x5a))});
  int refused = 0;
  for (std::size_t i = 0; i < content.size(); ++i) {
    std::string damaged = content;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    try {
      (void)read_any_map(file(damaged));
    } catch (const Error& error) {
      EXPECT_FALSE(error.remedy().empty());
      ++refused;
    }
  }
  EXPECT_GT(refused, static_cast<int>(content.size()) * 9 / 10);
}

TEST_F(Io, RefusesPngOfAbsurdSize) {
  const std::string content = png_of({2, 2, 8, PNG_COLOR_TYPE_GRAY, {{1, 2}, {3, 4}}});
  struct Case {
    std::uint32_t width, height;
    ErrorCode code;
  };
  for (const Case& c : {Case{32769, 1, ErrorCode::file_unsupported},
                        {1, 2000000000, ErrorCode::file_unsupported},
                        {32768, 32768, ErrorCode::file_broken},
                        {0, 3, ErrorCode::file_broken},
                        {0x80000001U, 3, ErrorCode::file_broken}}) {
    try {
      (void)read_any_map(file(resized(content, c.width, c.height)));
      FAIL() << c.width << 'x' << c.height;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), c.code) << error.what();
    }
  }
}

TEST_F(Io, RefusesWhatIsNoMap) {
  try {
    (void)read_any_map(file("GIF89a"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::file_unsupported);
    EXPECT_NE(std::string(error.what()).find(".yaml"), std::string::npos);
  }
  EXPECT_THROW((void)read_any_map(path("none.png")), Error);
  EXPECT_THROW((void)read_any_map(path(".")), Error);
  EXPECT_THROW((void)read_any_map(file("", "empty.yaml")), Error);
}

TEST_F(Io, ReadsTrinaryRosMaps) {
  // p = 1, 0.6510, 0.6471 (unknown), 0.1961 (unknown), 0.1922, 0
  const auto pgm = "P2 6 1 255  0 89 90 205 206 255"s;
  const Map map = read_ros(kTrinary, pgm);
  EXPECT_EQ(map.grid, grid_of({"####.."}));
  EXPECT_EQ(read_ros(kTrinary, pgm, {.unknown_is_free = true}).grid, grid_of({"##...."}));
  EXPECT_EQ(read_ros(kTrinary + "mode: trinary\n", pgm).grid, map.grid);
  ASSERT_TRUE(map.frame.has_value());
  EXPECT_EQ(map.frame->resolution, 0.5);
  EXPECT_EQ(map.frame->origin_x, 1);
  EXPECT_EQ(map.frame->origin_y, 2);
  EXPECT_EQ(map.frame->yaw, 0);
}

TEST_F(Io, ThresholdsOfRosMapsAreInclusive) {
  const auto lines = "negate: 0\noccupied_thresh: 0.75\nfree_thresh: 0.25\n"s;
  EXPECT_EQ(read_ros(lines, "P2 4 1 4  1 2 3 4").grid, grid_of({"##.."}));
  EXPECT_EQ(read_ros(lines, "P2 4 1 4  1 2 3 4", {.unknown_is_free = true}).grid,
            grid_of({"#..."}));
}

TEST_F(Io, NegatesRosMaps) {
  const auto lines = "negate: 1\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"s;
  EXPECT_EQ(read_ros(lines, "P2 3 1 255  0 255 128").grid, grid_of({".##"}));
  EXPECT_EQ(read_ros("negate: true\noccupied_thresh: 0.65\nfree_thresh: 0.196\n", "P1 2 1 10").grid,
            grid_of({".#"}));
}

TEST_F(Io, ReadsScaledAndRawRosMaps) {
  // p = 1, 0.75, 0.625, 0.5, 0.375, 0.25, 0; scaled 1, 1, 0.75, 0.5, 0.25, 0, 0
  const auto scale = "negate: 0\noccupied_thresh: 0.75\nfree_thresh: 0.25\nmode: scale\n"s;
  const auto pgm = "P2 7 1 8  0 2 3 4 5 6 8"s;
  EXPECT_EQ(read_ros(scale, pgm).grid, grid_of({"####..."}));
  EXPECT_EQ(read_ros(scale, pgm, {.free_below = 0.6}).grid, grid_of({"###...."}));
  const std::string raw = kTrinary + "mode: raw\n";
  const auto greys = "P2 6 1 255  0 49 50 100 101 255"s;
  EXPECT_EQ(read_ros(raw, greys).grid, grid_of({"..####"}));
  EXPECT_EQ(read_ros(raw, greys, {.unknown_is_free = true}).grid, grid_of({"..##.."}));
  EXPECT_EQ(read_ros(raw, "P2 3 1 65535  0 12593 65535").grid, grid_of({"..#"}))
      << "16 bits are taken to 8";
}

TEST_F(Io, TransparentPixelsOfRosMapsAreUnknown) {
  const std::string png =
      png_of({3, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {{255, 255, 255, 254, 0, 255}}});
  EXPECT_EQ(read_ros(kTrinary, png).grid, grid_of({".##"}));
  EXPECT_EQ(read_ros(kTrinary, png, {.unknown_is_free = true}).grid, grid_of({"..#"}));
  EXPECT_EQ(read_ros(kTrinary + "mode: raw\n", png).grid, grid_of({"##."}));
}

TEST_F(Io, FindsTheImageBesideTheYaml) {
  fs::create_directories(path("maps/images"));
  file("P1 2 1 01", "maps/images/a.pbm");
  const std::string yaml =
      file("image: images/a.pbm\nresolution: 0.05\norigin: [0, 0, 1.5]\n" + kTrinary, "maps/a.yml");
  EXPECT_EQ(read_any_map(yaml).grid, grid_of({".#"}));
  EXPECT_EQ(read_any_map(yaml).frame->yaw, 1.5);
  const std::string absolute = file(
      "image: " + path("maps/images/a.pbm") + "\nresolution: 0.05\norigin: [0, 0, 0]\n" + kTrinary,
      "b.yaml");
  EXPECT_EQ(read_any_map(absolute).grid, grid_of({".#"}));
}

struct BrokenRos {
  const char* what;
  std::string content;
  ErrorCode code;
  std::int64_t line;
  const char* says;
};

class BrokenRosMaps : public Io, public testing::WithParamInterface<BrokenRos> {};

TEST_P(BrokenRosMaps, AreRefusedWithTheLine) {
  const BrokenRos& broken = GetParam();
  file("P1 1 1 0", "image");
  const std::string name = file(broken.content, "map.yaml");
  try {
    (void)read_any_map(name);
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), broken.code) << error.what();
    EXPECT_EQ(error.place().file, name);
    EXPECT_EQ(error.place().line, broken.line) << error.what();
    EXPECT_NE(std::string(error.what()).find(broken.says), std::string::npos) << error.what();
    EXPECT_FALSE(error.remedy().empty());
  }
}

constexpr auto kBroken = ErrorCode::file_broken;
const std::string kTop = "image: image\nresolution: 0.5\norigin: [1, 2, 0]\n";

const BrokenRos kBrokenRosMaps[] = {
    {"no_yaml", "image: [\n", kBroken, 2, "broken YAML"},
    {"tab", "image: image\n\tresolution: 1\n", kBroken, 2, "broken YAML"},
    {"scalar", "hello\n", kBroken, 1, "no list of keys"},
    {"sequence", "- image\n", kBroken, 1, "no list of keys"},
    {"binary", "\x01\x02\x03\xff\xfe", kBroken, 1, ""},
    {"no_image", "resolution: 0.5\norigin: [1, 2, 0]\n" + kTrinary, kBroken, 1,
     "'image' is missing"},
    {"empty_image", "image:\nresolution: 0.5\norigin: [1, 2, 0]\n" + kTrinary, kBroken, 1,
     "'image'"},
    {"image_list", "image: [a]\nresolution: 0.5\n", kBroken, 1, "'image'"},
    {"missing_image", "resolution: 1\nimage: none.pgm\norigin: [0, 0, 0]\n" + kTrinary,
     ErrorCode::file_missing, 2, "none.pgm cannot be opened"},
    {"no_resolution", "image: image\norigin: [1, 2, 0]\n", kBroken, 1, "'resolution' is missing"},
    {"resolution_0", "image: image\nresolution: 0\n", kBroken, 2, "not above 0"},
    {"resolution_text", "image: image\nresolution: fine\n", kBroken, 2, "no finite number"},
    {"resolution_inf", "image: image\nresolution: .inf\n", kBroken, 2, "no finite number"},
    {"no_origin", "image: image\nresolution: 1\n" + kTrinary, kBroken, 1, "'origin' is missing"},
    {"origin_2", "image: image\nresolution: 1\norigin: [1, 2]\n", kBroken, 3, "x, y and yaw"},
    {"origin_text", "image: image\nresolution: 1\norigin: [1, 2, x]\n", kBroken, 3,
     "finite number"},
    {"origin_nan", "image: image\nresolution: 1\norigin: [1, .nan, 0]\n", kBroken, 3,
     "finite number"},
    {"no_negate", kTop + "occupied_thresh: 0.65\nfree_thresh: 0.2\n", kBroken, 1, "'negate'"},
    {"negate_text", kTop + "negate: perhaps\n", kBroken, 4, "neither 0 nor 1"},
    {"no_occupied", kTop + "negate: 0\nfree_thresh: 0.2\n", kBroken, 1, "'occupied_thresh'"},
    {"no_free", kTop + "negate: 0\noccupied_thresh: 0.2\n", kBroken, 1, "'free_thresh'"},
    {"thresholds", kTop + "negate: 0\noccupied_thresh: 0.2\nfree_thresh: 0.65\n", kBroken, 6,
     "out of order"},
    {"threshold_range", kTop + "negate: 0\noccupied_thresh: 65\nfree_thresh: 20\n", kBroken, 6,
     "out of order"},
    {"mode", kTop + "mode: ternary\n", kBroken, 4, "'mode' is 'ternary'"},
    {"large", "a: " + std::string(70000, 'x'), kBroken, 1, "larger than"},
    {"deep", std::string(20000, '['), kBroken, 1, ""},
};

INSTANTIATE_TEST_SUITE_P(Io, BrokenRosMaps, testing::ValuesIn(kBrokenRosMaps),
                         [](const auto& test) { return std::string(test.param.what); });

TEST_F(Io, RefusesRosImagesOfOtherFormats) {
  const std::string name = file("type octile\nheight 1\nwidth 1\nmap\n.\n", "image");
  try {
    (void)read_any_map(file(kTop + kTrinary, "map.yaml"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::file_unsupported);
    EXPECT_EQ(error.place().file, name);
  }
}

TEST(SharedRosMaps, HaveTheBitsOfTheirMovingAiTwins) {
  const fs::path folder = fs::path(LASIUS_SHARED_DIR) / "data" / "movingai";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  for (const char* name : {"turtlebot3_world", "willow-2010-02-18-0.10"}) {
    const Map ros = read_any_map((folder / (name + ".yaml"s)).string());
    const Grid twin = read_any_map((folder / (name + ".map"s)).string()).grid;
    EXPECT_EQ(ros.grid, twin) << name;
    EXPECT_TRUE(ros.frame.has_value());
  }
}

}  // namespace
}  // namespace lasius
