#include "lasius/grid/map_io.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/path/path.h"
#include "tests/core/base/made_files.h"
#include "tests/core/base/other_locale.h"
#include "tests/core/base/refusal.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using namespace std::string_literals;

// A map without any pattern; its width is no multiple of 8 or 64.
Grid scattered(int width, int height) {
  unsigned state = 12345;
  return grid_of(width, height, [&](int, int) {
    state = state * 1664525 + 1013904223;
    return (state >> 28) < 5;
  });
}

class MapIo : public Files {
 protected:
  Grid read(const std::string& content, const ReadOptions& options = {}) const {
    return read_map(file(content), options).grid;
  }
};

TEST_F(MapIo, ReadsMovingAi) {
  const Grid expected = drawn({"...##", "##..."});
  EXPECT_EQ(read("type octile\nheight 2\nwidth 5\nmap\n.GSOT\n@W...\n"), expected);
  EXPECT_EQ(read("type octile\r\nheight 2\r\nwidth 5\r\nmap\r\n.GSOT\r\n@W...\r\n"), expected)
      << "CR LF";
  EXPECT_EQ(read("type octile\rheight 2\rwidth 5\rmap\r.GSOT\r@W...\r"), expected) << "CR";
  EXPECT_EQ(read("type octile\nwidth 5\nheight 2\nmap\n.GSOT\n@W..."), expected)
      << "width first, last line without its end";
  EXPECT_EQ(read("\xef\xbb\xbftype octile\nwidth 5\nheight 2\nmap\n.GSOT\n@W..."), expected)
      << "a byte order mark";
  EXPECT_EQ(read("type  octile \nheight\t2\nwidth 5\nmap\n.GSOT\n@W...\n\n \r\n"), expected)
      << "blanks, empty lines at the end";
}

TEST_F(MapIo, ReadsAsciiPbmWithAnySpacing) {
  const Grid expected = drawn({"#.#", ".#."});
  EXPECT_EQ(read("P1\n3 2\n1 0 1\n0 1 0\n"), expected);
  EXPECT_EQ(read("P1 3 2 101010"), expected) << "no spaces between the bits";
  EXPECT_EQ(read("P1#a\n#b\n3#c\n2\t\v\f\r\n1#d 0\n01\n#e\n0 1 0 #f"), expected) << "comments";
  EXPECT_EQ(read("P1\r\n3 2\r\n101\r\n010\r\n"), expected) << "CR LF";
  EXPECT_EQ(read("P1\r# c\r3 2\r101\r010\r"), expected) << "CR";
}

TEST_F(MapIo, ReadsBinaryPbm) {
  EXPECT_EQ(read("P4\n10 2\n\xA5\x40\x00\xBF"s), drawn({"#.#..#.#.#", "........#."}))
      << "bits past the width are ignored";
  EXPECT_EQ(read("P4 8 1\n\x0A"), drawn({"....#.#."})) << "a pixel byte that is a line feed";
  EXPECT_EQ(read("P4\r\n8 1\r\n\x81"), drawn({"#......#"})) << "CR LF";
  EXPECT_EQ(read("P4\n8 2\r\n\x81"), drawn({"....#.#.", "#......#"})) << "LF is a pixel byte";
  EXPECT_EQ(read("P4\n# c\n8 1#d\n\x81\n"), drawn({"#......#"})) << "comments, LF at the end";
}

TEST_F(MapIo, ReadsPgm) {
  const Grid expected = drawn({"##..", "#..#"});
  EXPECT_EQ(read("P2\n4 2 255\n0 127 128 255 1 200 129 126\n"), expected);
  EXPECT_EQ(read("P2\n4 2\n# top\n10\n0 5 6 10 5\n#x\n7\n10 0"), expected);
  EXPECT_EQ(read("P2 4 2 65535 0 32767 32768 65535 1 40000 65535 0"), expected);
  EXPECT_EQ(read("P5\n4 2\n255\n\x00\x7f\x80\xff\x01\xc8\x81\x7e"s), expected);
  EXPECT_EQ(read("P5 4 2 65535\n\x00\x00\x7f\xff\x80\x00\xff\xff\x00\x01\xc8\x00\x81\x00\x7e\x00"s),
            expected);
  EXPECT_EQ(read("P5 1 2 256\n\x01\x00\x00\x80"s), drawn({".", "#"})) << "two bytes above 255";
}

TEST_F(MapIo, FreeBelowSetsTheGreyThatIsFree) {
  const auto pgm = "P2 5 1 100  0 10 50 90 100"s;
  EXPECT_EQ(read(pgm, {.free_below = 0.9}), drawn({"##..."}));
  EXPECT_EQ(read(pgm, {.free_below = 1}), drawn({"#...."}));
  EXPECT_EQ(read(pgm, {.free_below = 0.001}), drawn({"####."}));
  EXPECT_EQ(read("P1 2 1 10", {.free_below = 0.001}), drawn({"#."}));
  for (const double value : {0.0, -1.0, 1.5, std::nan("")}) {
    EXPECT_THROW(read(pgm, {.free_below = value}), Error) << value;
  }
}

TEST_F(MapIo, WritesWhatItReads) {
  for (const int width : {1, 7, 8, 63, 64, 65, 200}) {
    const Grid grid = scattered(width, 17);
    for (const char* name : {"a.map", "a.pbm"}) {
      write_map(grid, path(name));
      EXPECT_EQ(read_map(path(name)).grid, grid) << name << ", width " << width;
      EXPECT_FALSE(read_map(path(name)).frame.has_value());
    }
  }
}

TEST_F(MapIo, WritesTheFormatsByTheLetter) {
  const Grid grid = drawn({"#..", ".##"});
  write_map(grid, path("a.map"));
  EXPECT_EQ(bytes_of(path("a.map")), "type octile\nheight 2\nwidth 3\nmap\n@..\n.@@\n");
  write_map(grid, path("a.pbm"));
  EXPECT_EQ(bytes_of(path("a.pbm")), "P4\n3 2\n\x80\x60");
  write_map(grid, path("A.PBM"));
  EXPECT_EQ(bytes_of(path("A.PBM")), bytes_of(path("a.pbm")));
}

TEST_F(MapIo, FilesDoNotDependOnTheLocale) {
  const Grid grid = scattered(1234, 2);
  const OtherLocale other;
  for (const char* name : {"a.map", "a.pbm"}) {
    write_map(grid, path(name));
    EXPECT_EQ(read_map(path(name)).grid, grid) << name;
  }
  EXPECT_EQ(path_fault(Grid(2000, 1), std::vector<Point>{{1.5, 0.5}, {1500.25, 0.5}, {1.5, 0.5}}),
            "vertex 1 (1500.25, 0.5) is not at multiples of 0.5");
}

struct Broken {
  const char* what;
  std::string content;
  ErrorCode code;
  std::int64_t line;    // -1: none is named
  std::int64_t offset;  // -1: none is named
  const char* says;
};

class BrokenMaps : public MapIo, public testing::WithParamInterface<Broken> {};

TEST_P(BrokenMaps, AreRefusedWithThePlace) {
  const Broken& broken = GetParam();
  const std::string name = file(broken.content);
  const Error error = error_of([&] { return read_map(name); });
  EXPECT_EQ(error.code(), broken.code) << error.what();
  EXPECT_EQ(error.place().file, name);
  EXPECT_EQ(error.place().line, broken.line) << error.what();
  EXPECT_EQ(error.place().offset, broken.offset) << error.what();
  expect_says(error, broken.says);
  EXPECT_FALSE(error.remedy().empty());
}

constexpr auto kBroken = ErrorCode::file_broken;
constexpr auto kUnsupported = ErrorCode::file_unsupported;
const std::string kHead = "type octile\nheight 2\nwidth 3\nmap\n";

const Broken kBrokenMaps[] = {
    {"empty", "", kBroken, -1, 0, "is empty"},
    {"text", "hello\n", kUnsupported, -1, 0, "no MovingAI .map, PBM, PGM or BMP"},
    {"colour", "P6 1 1 255\nabc", kUnsupported, -1, 0, "no MovingAI .map, PBM, PGM or BMP"},
    {"png", "\x89PNG\r\n\x1a\n", kUnsupported, -1, 0, "lasius::io"},
    {"other_type", "type hex\nheight 1\nwidth 1\nmap\n.\n", kUnsupported, 1, -1, "'hex'"},
    {"header_ends", "type octile\nheight 2\n", kBroken, 3, -1, "ends early"},
    {"no_width", "type octile\nheight 2\nmap\n...\n", kBroken, 3, -1, "width is missing"},
    {"no_height", "type octile\nwidth 2\nmap\n...\n", kBroken, 3, -1, "height is missing"},
    {"twice", "type octile\nwidth 2\nwidth 2\nmap\n..\n", kBroken, 3, -1, "'width 2'"},
    {"strange_key", "type octile\ndepth 2\n", kBroken, 2, -1, "'depth 2'"},
    {"no_number", "type octile\nheight two\n", kBroken, 2, -1, "'two'"},
    {"half_number", "type octile\nheight 2x\n", kBroken, 2, -1, "'2x'"},
    {"zero", "type octile\nheight 0\nwidth 3\nmap\n", kBroken, 2, -1, "3 x 0"},
    {"negative", "type octile\nheight -2\nwidth 3\nmap\n", kBroken, 2, -1, "3 x -2"},
    {"too_large", "type octile\nheight 1\nwidth 32769\nmap\n", kUnsupported, 3, -1, "32769"},
    {"absurd", "type octile\nheight 99999999999999\n", kUnsupported, 2, -1, "at most 32768"},
    {"far_too_short", "type octile\nheight 32768\nwidth 32768\nmap\n..\n", kBroken, 3, -1,
     "only 3 follow"},
    {"long_header_line", "type octile" + std::string(1000, ' ') + "\n", kBroken, 1, -1, ""},
    {"truncated", kHead + "...\n\n\n\n", kBroken, 6, -1, "after 0 of 3 characters"},
    {"rows_missing", kHead + "...\n", kBroken, 3, -1, "only 4 follow"},
    {"short_row", kHead + "..\n....\n", kBroken, 5, -1, "after 2 of 3 characters"},
    {"long_row", kHead + "...\n....\n", kBroken, 6, -1, "goes on after the width"},
    {"unknown", kHead + "...\n.x.\n", kBroken, 6, -1, "'x' in column 1"},
    {"control", kHead + "...\n.\x01.\n", kBroken, 6, -1, "code 1"},
    {"null", kHead + "..\0\n...\n"s, kBroken, 5, -1, "code 0"},
    {"more_rows", kHead + "...\n...\n...\n", kBroken, 7, -1, "more rows"},

    {"p1_no_size", "P1\n", kBroken, 2, -1, "before its width"},
    {"p1_words", "P1\nthree 2\n", kBroken, 2, -1, "width is not a number"},
    {"p1_negative", "P1\n-3 2\n", kBroken, 2, -1, "width is not a number"},
    {"p1_glued", "P1\n3x2\n", kBroken, 2, -1, "width is not a number"},
    {"p1_zero", "P1\n0 2\n", kBroken, 2, -1, "0 x 2"},
    {"p1_short", "P1\n2 2\n0 1\n0\n", kBroken, 5, -1, "ends in row 1 of 2"},
    {"p1_bad_bit", "P1\n2 2\n01\n02\n", kBroken, 4, -1, "neither 0 nor 1"},
    {"p1_more", "P1\n2 1\n01\n0\n", kBroken, 4, -1, "goes on"},
    {"p1_large", "P1\n2 40000\n", kUnsupported, 2, -1, "2 x 40000"},
    {"p2_maxval_0", "P2\n1 1\n0\n0\n", kBroken, 3, -1, "maxval is 0"},
    {"p2_maxval_high", "P2\n1 1\n65536\n0\n", kBroken, 3, -1, "maxval is 65536"},
    {"p2_above", "P2\n2 1\n10\n1\n11\n", kBroken, 5, -1, "grey level 11"},
    {"p2_short", "P2\n2 2\n9\n1 2 3    ", kBroken, 4, -1, "ends in row 1 of 2"},
    {"p2_sign", "P2\n2 1\n9\n1 -2\n", kBroken, 4, -1, "a grey level is not a number"},
    {"p2_more", "P2\n2 1\n9\n1 2 3\n", kBroken, 4, -1, "goes on"},
    {"p2_huge_number", "P2\n1 1\n9\n99999999999999999999\n", kBroken, 4, -1, "above maxval"},
    {"p4_no_raster", "P4\n8 1", kBroken, -1, 6, "before its pixels"},
    {"p4_short", "P4\n8 3\nab", kBroken, -1, 3, "only 2 follow"},
    {"p4_more", "P4\n8 1\nab", kBroken, -1, 8, "goes on"},
    {"p5_short", "P5\n2 2\n255\nabc", kBroken, -1, 3, "only 3 follow"},
    {"p5_above", "P5\n2 1\n10\n\x05\x0b", kBroken, -1, 11, "grey level 11"},
    {"p5_above_16_bit", "P5\n2 1\n300\n\x01\x00\x01\x2d"s, kBroken, -1, 13, "grey level 301"},
    {"p5_more", "P5\n1 1\n255\naP5\n1 1\n255\na", kBroken, -1, 12, "one image a file"},
    {"p5_large", "P5\n99999999999 1\n255\n", kUnsupported, -1, 3, "99999999999 x 1"},
    {"p5_far_too_short", "P5\n32768 32768\n65535\nab", kBroken, -1, 3, "only 2 follow"},
};

INSTANTIATE_TEST_SUITE_P(MapIo, BrokenMaps, testing::ValuesIn(kBrokenMaps),
                         [](const auto& test) { return std::string(test.param.what); });

TEST_F(MapIo, RefusesMissingFilesAndFolders) {
  const Error missing = error_of([&] { return read_map(path("none.map")); });
  EXPECT_EQ(missing.code(), ErrorCode::file_missing);
  EXPECT_EQ(missing.place().file, path("none.map"));
  const Error folder = error_of([&] { return read_map(path(".")); });
  EXPECT_EQ(folder.code(), ErrorCode::file_broken);
  expect_says(folder, "is a folder");
}

TEST_F(MapIo, OutputMayHaveTheLongestName) {
  const std::string name = path(std::string(251, 'a') + ".map");  // 255 bytes, Linux's most
  write_map(Grid(3, 3), name);
  EXPECT_EQ(read_map(name).grid, Grid(3, 3));
}

TEST_F(MapIo, RefusesOutputItCannotWrite) {
  const Grid grid(3, 3);
  fs::create_directory(path("folder.map"));
  for (const char* name : {"no_folder/a.map", "folder.map"}) {
    const Error error = error_of([&] { write_map(grid, path(name)); }, name);
    EXPECT_EQ(error.code(), ErrorCode::output_failed) << name;
    EXPECT_EQ(error.place().file, path(name));
    EXPECT_FALSE(error.remedy().empty());
  }
  EXPECT_THROW(write_map(grid, path("a.bmp")), Error);
  EXPECT_EQ(files(), std::vector<std::string>{"folder.map"}) << "no temporary file is left";
}

TEST(WorldFrame, TurnsAndShiftsAboutTheLowerLeftCorner) {
  const WorldFrame straight{0.5, -10, 20, 0};
  EXPECT_EQ(straight.to_world({0, 8}, 8), (Point{-10, 20}));
  EXPECT_EQ(straight.to_world({4, 6}, 8), (Point{-8, 21}));
  EXPECT_EQ(straight.to_cells({-8, 21}, 8), (Point{4, 6}));
  // A quarter turn: the map's right is the world's up.
  const WorldFrame turned{0.5, -10, 20, std::numbers::pi / 2};
  const Point world = turned.to_world({4, 6}, 8);
  EXPECT_NEAR(world.x, -11, 1e-12);
  EXPECT_NEAR(world.y, 22, 1e-12);
  const WorldFrame any{0.05, 3, -7, 0.7};
  const Point back = any.to_cells(any.to_world({12.5, 3.25}, 40), 40);
  EXPECT_NEAR(back.x, 12.5, 1e-9);
  EXPECT_NEAR(back.y, 3.25, 1e-9);
}

TEST(SharedMaps, AreAllRead) {
  const fs::path folder = fs::path(LASIUS_SHARED_DIR) / "data";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".map" && entry.path().extension() != ".pgm") continue;
    const Grid grid = read_map(entry.path().string()).grid;
    EXPECT_GT(grid.count_free(), 0) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 20);
}

}  // namespace
}  // namespace lasius
