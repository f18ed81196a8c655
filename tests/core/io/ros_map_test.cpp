#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "core/io/grey_image.h"
#include "lasius/base/error.h"
#include "tests/core/base/refusal.h"
#include "tests/core/io/images.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using namespace std::string_literals;

const std::string kTrinary = "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

class RosIo : public Io {
 protected:
  /// A ROS map: the YAML's lines after those that every map has, and its image.
  Map read_ros(const std::string& lines, const std::string& image,
               const ReadOptions& options = {}) const {
    file(image, "image");
    return read_any_map(
        file("image: image\nresolution: 0.5\norigin: [1, 2, 0]\n" + lines, "map.yaml"), options);
  }
};

TEST_F(RosIo, ReadsTrinaryRosMaps) {
  // p = 1, 0.6510, 0.6471 (unknown), 0.1961 (unknown), 0.1922, 0
  const auto pgm = "P2 6 1 255  0 89 90 205 206 255"s;
  const Map map = read_ros(kTrinary, pgm);
  EXPECT_EQ(map.grid, drawn({"####.."}));
  EXPECT_EQ(read_ros(kTrinary, pgm, {.unknown_is_free = true}).grid, drawn({"##...."}));
  EXPECT_EQ(read_ros(kTrinary + "mode: trinary\n", pgm).grid, map.grid);
  ASSERT_TRUE(map.frame.has_value());
  EXPECT_EQ(map.frame->resolution, 0.5);
  EXPECT_EQ(map.frame->origin_x, 1);
  EXPECT_EQ(map.frame->origin_y, 2);
  EXPECT_EQ(map.frame->yaw, 0);
}

TEST_F(RosIo, ReadsOccupancies) {
  constexpr int kUnknown = OccupancyImage::kUnknown;
  const struct {
    std::string lines, image;
    std::vector<std::uint16_t> percent;
  } cases[] = {{kTrinary, "P2 6 1 255  0 89 90 205 206 255", {100, 100, kUnknown, kUnknown, 0, 0}},
               {kTrinary + "mode: raw\n",
                "P2 6 1 255  0 49 50 100 101 255",
                {0, 49, 50, 100, kUnknown, kUnknown}},
               {"negate: 1\noccupied_thresh: 1\nfree_thresh: 0\nmode: scale\n",
                "P2 4 1 1000  0 4 506 1000",
                {0, 0, 51, 100}},
               {kTrinary,
                png_of({2, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {{0, 255, 255, 254}}}),
                {100, kUnknown}},
               {kTrinary, "P4 4 1\n\x50", {0, 100, 0, 100}}};
  for (const auto& c : cases) {
    file(c.image, "image");
    const OccupancyImage read = read_occupancy(
        file("image: image\nresolution: 0.5\norigin: [1, 2, 0]\n" + c.lines, "map.yaml"));
    EXPECT_EQ(read.levels, c.percent) << c.lines;
    EXPECT_EQ(read.height, 1);
    EXPECT_EQ(read.frame.origin_y, 2);
  }
}

TEST_F(RosIo, ReadsGreys) {
  const GreyImage deep = read_grey_image(file("P2 3 1 65535  0 40000 65535", "deep.pgm"));
  EXPECT_EQ(deep.levels, (std::vector<std::uint16_t>{0, 40000, 65535}));
  EXPECT_EQ(deep.white, 65535);
  const GreyImage few = read_grey_image(file("P2 2 2 5  0 5 3 1", "few.pgm"));
  EXPECT_EQ(few.levels, (std::vector<std::uint16_t>{0, 5, 3, 1}));
  EXPECT_EQ(few.white, 5);
}

/// As the blocked cells of Map::unknown, however they count.
TEST_F(RosIo, TellsUnknownCells) {
  const struct {
    const char* what;
    std::string lines, image;
    Grid unknown;
  } cases[] = {
      {"trinary", kTrinary, "P2 6 1 255  0 89 90 205 206 255", drawn({"..##.."})},
      {"binary", kTrinary, "P5 4 1 255\n\x00\x80\xff\x81"s, drawn({".#.#"})},
      {"raw", kTrinary + "mode: raw\n", "P2 6 1 255  0 49 50 100 101 255", drawn({"....##"})},
      {"raw bits", kTrinary + "mode: raw\n", "P4 4 1\n\x50", drawn({"#.#."})},
      {"scale", kTrinary + "mode: scale\n", "P2 3 1 255 0 128 255", drawn({"..."})},
      {"alpha", kTrinary, png_of({2, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {{255, 255, 255, 254}}}),
       drawn({".#"})},
  };
  for (const auto& c : cases)
    for (const bool free : {false, true}) {
      const Map map = read_ros(c.lines, c.image, {.unknown_is_free = free});
      ASSERT_TRUE(map.unknown.has_value()) << c.what;
      EXPECT_EQ(*map.unknown, c.unknown) << c.what;
      for (const Cell cell : cells_of(map.grid)) {
        if (map.unknown->blocked(cell)) {
          EXPECT_EQ(map.grid.free(cell), free) << c.what;
        }
      }
    }
  EXPECT_FALSE(read_any_map(path("image")).unknown.has_value());
}

/// What nav2's map_server takes.
TEST_F(RosIo, TakesWhatMapServerTakes) {
  const auto pgm = "P2 6 1 255  0 89 90 205 206 255"s;
  for (const char* mode : {"trinary", "scale", "raw"}) {
    const Grid expected = read_ros(kTrinary + "mode: " + mode + "\n", pgm).grid;
    std::string capital = mode, large = mode;
    capital[0] = static_cast<char>(capital[0] - 32);
    for (char& c : large) c = static_cast<char>(c - 32);
    for (const std::string& written : {capital, large, "\"" + large + "\""})
      EXPECT_EQ(read_ros(kTrinary + "mode: " + written + "\n", pgm).grid, expected) << written;
  }
  const auto thresholds = "occupied_thresh: 0.5\nfree_thresh: 0.5\n"s;
  for (const char* negate : {"1", "2", "-1", "True", "yes"})
    EXPECT_EQ(read_ros("negate: "s + negate + "\n" + thresholds, "P2 4 1 4  0 1 3 4").grid,
              drawn({"..##"}))
        << negate;
  EXPECT_EQ(read_ros("negate: 0\n" + thresholds, "P2 3 1 4  1 2 3").grid, drawn({"##."}));
}

TEST_F(RosIo, ThresholdsOfRosMapsAreInclusive) {
  const auto lines = "negate: 0\noccupied_thresh: 0.75\nfree_thresh: 0.25\n"s;
  EXPECT_EQ(read_ros(lines, "P2 4 1 4  1 2 3 4").grid, drawn({"##.."}));
  EXPECT_EQ(read_ros(lines, "P2 4 1 4  1 2 3 4", {.unknown_is_free = true}).grid, drawn({"#..."}));
}

TEST_F(RosIo, NegatesRosMaps) {
  const auto lines = "negate: 1\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"s;
  EXPECT_EQ(read_ros(lines, "P2 3 1 255  0 255 128").grid, drawn({".##"}));
  EXPECT_EQ(read_ros("negate: true\noccupied_thresh: 0.65\nfree_thresh: 0.196\n", "P1 2 1 10").grid,
            drawn({".#"}));
}

TEST_F(RosIo, ReadsScaledAndRawRosMaps) {
  // p = 1, 0.75, 0.625, 0.5, 0.375, 0.25, 0; scaled 1, 1, 0.75, 0.5, 0.25, 0, 0
  const auto scale = "negate: 0\noccupied_thresh: 0.75\nfree_thresh: 0.25\nmode: scale\n"s;
  const auto pgm = "P2 7 1 8  0 2 3 4 5 6 8"s;
  EXPECT_EQ(read_ros(scale, pgm).grid, drawn({"####..."}));
  EXPECT_EQ(read_ros(scale, pgm, {.free_below = 0.6}).grid, drawn({"###...."}));
  const std::string raw = kTrinary + "mode: raw\n";
  const auto greys = "P2 6 1 255  0 49 50 100 101 255"s;
  EXPECT_EQ(read_ros(raw, greys).grid, drawn({"..####"}));
  EXPECT_EQ(read_ros(raw, greys, {.unknown_is_free = true}).grid, drawn({"..##.."}));
  EXPECT_EQ(read_ros(raw, "P2 3 1 65535  0 12593 65535").grid, drawn({"..#"}))
      << "16 bits are taken to 8";
}

TEST_F(RosIo, TransparentPixelsOfRosMapsAreUnknown) {
  const std::string png =
      png_of({3, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {{255, 255, 255, 254, 0, 255}}});
  EXPECT_EQ(read_ros(kTrinary, png).grid, drawn({".##"}));
  EXPECT_EQ(read_ros(kTrinary, png, {.unknown_is_free = true}).grid, drawn({"..#"}));
  EXPECT_EQ(read_ros(kTrinary + "mode: raw\n", png).grid, drawn({"##."}));
}

TEST_F(RosIo, FindsTheImageBesideTheYaml) {
  fs::create_directories(path("maps/images"));
  file("P1 2 1 01", "maps/images/a.pbm");
  const std::string yaml =
      file("image: images/a.pbm\nresolution: 0.05\norigin: [0, 0, 1.5]\n" + kTrinary, "maps/a.yml");
  EXPECT_EQ(read_any_map(yaml).grid, drawn({".#"}));
  EXPECT_EQ(read_any_map(yaml).frame->yaw, 1.5);
  EXPECT_EQ(read_any_map(yaml).image, path("maps/images/a.pbm"));
  EXPECT_EQ(read_any_map(path("maps/images/a.pbm")).image, "");
  const std::string absolute = file(
      "image: " + path("maps/images/a.pbm") + "\nresolution: 0.05\norigin: [0, 0, 0]\n" + kTrinary,
      "b.yaml");
  EXPECT_EQ(read_any_map(absolute).grid, drawn({".#"}));
}

struct BrokenRos {
  const char* what;
  std::string content;
  ErrorCode code;
  std::int64_t line;
  const char* says;
};

class BrokenRosMaps : public RosIo, public testing::WithParamInterface<BrokenRos> {};

TEST_P(BrokenRosMaps, AreRefusedWithTheLine) {
  const BrokenRos& broken = GetParam();
  file("P1 1 1 0", "image");
  const std::string name = file(broken.content, "map.yaml");
  const Error error = error_of([&] { return read_any_map(name); });
  EXPECT_EQ(error.code(), broken.code) << error.what();
  EXPECT_EQ(error.place().file, name);
  EXPECT_EQ(error.place().line, broken.line) << error.what();
  expect_says(error, broken.says);
  EXPECT_FALSE(error.remedy().empty());
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
    {"resolution_1e308", "image: image\nresolution: 1e308\n", kBroken, 2, "above 1e299"},
    {"resolution_text", "image: image\nresolution: fine\n", kBroken, 2, "no finite number"},
    {"resolution_inf", "image: image\nresolution: .inf\n", kBroken, 2, "no finite number"},
    {"no_origin", "image: image\nresolution: 1\n" + kTrinary, kBroken, 1, "'origin' is missing"},
    {"origin_2", "image: image\nresolution: 1\norigin: [1, 2]\n", kBroken, 3, "x, y and yaw"},
    {"origin_text", "image: image\nresolution: 1\norigin: [1, 2, x]\n", kBroken, 3,
     "finite number"},
    {"origin_nan", "image: image\nresolution: 1\norigin: [1, .nan, 0]\n", kBroken, 3,
     "finite number"},
    {"another_document", kTop + kTrinary + "---\nnegate: 1\n", kBroken, 1,
     "something follows the document"},
    {"twice", kTop + "negate: 0\nresolution: 0.1\n" + kTrinary, kBroken, 5,
     "'resolution' is given again"},
    {"no_negate", kTop + "occupied_thresh: 0.65\nfree_thresh: 0.2\n", kBroken, 1, "'negate'"},
    {"negate_text", kTop + "negate: perhaps\n", kBroken, 4, "neither 0 nor 1"},
    {"image_with_a_zero_byte", "image: \"image\\0.pgm\"\n" + kTrinary, kBroken, 1, "a zero byte"},
    {"lines_of_cr", "image: image\rresolution: 0\r", kBroken, 2, "not above 0"},
    {"lines_of_cr_in_yaml", "image: image\rresolution: [\r", kBroken, 3, "broken YAML"},
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

INSTANTIATE_TEST_SUITE_P(RosIo, BrokenRosMaps, testing::ValuesIn(kBrokenRosMaps),
                         [](const auto& test) { return std::string(test.param.what); });

TEST_F(RosIo, RefusesRosImagesOfOtherFormats) {
  const std::string name = file("type octile\nheight 1\nwidth 1\nmap\n.\n", "image");
  const Error error = error_of([&] { return read_any_map(file(kTop + kTrinary, "map.yaml")); });
  EXPECT_EQ(error.code(), ErrorCode::file_unsupported);
  EXPECT_EQ(error.place().file, name);
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
