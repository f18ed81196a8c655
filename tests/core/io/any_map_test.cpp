#include <gtest/gtest.h>

#include <string>

#include "lasius/base/error.h"
#include "tests/core/base/refusal.h"
#include "tests/core/io/images.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

TEST_F(Io, ReadsEveryFormatByContent) {
  const Grid expected = drawn({"#.", ".."});
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
  const Error error = error_of([&] { write_any_map(Grid(2, 2), path("a.jpg")); });
  EXPECT_EQ(error.code(), ErrorCode::invalid_parameter);
  expect_says(error.remedy(), ".png");
}

TEST_F(Io, RefusesWhatIsNoMap) {
  const Error error = error_of([&] { return read_any_map(file("GIF89a")); });
  EXPECT_EQ(error.code(), ErrorCode::file_unsupported);
  expect_says(error, ".yaml");
  EXPECT_THROW((void)read_any_map(path("none.png")), Error);
  EXPECT_THROW((void)read_any_map(path(".")), Error);
  EXPECT_THROW((void)read_any_map(file("", "empty.yaml")), Error);
}

}  // namespace
}  // namespace lasius
