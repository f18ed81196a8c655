#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lasius/base/error.h"
#include "tests/core/base/refusal.h"
#include "tests/core/io/chunks.h"
#include "tests/core/io/images.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

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
  EXPECT_EQ(read_image({6, 1, 8, PNG_COLOR_TYPE_RGB, {rgb}}), drawn({"#.#..#"}));
  const Bytes rgb16 = {0x7f, 0xff, 0x7f, 0xff, 0x7f, 0xff, 0x80, 0, 0x80, 0, 0x80, 0};
  EXPECT_EQ(read_image({2, 1, 16, PNG_COLOR_TYPE_RGB, {rgb16}}), drawn({"#."}));
  for (const bool interlaced : {false, true}) {
    const TestImage image{3,
                          2,
                          4,
                          PNG_COLOR_TYPE_PALETTE,
                          {{0x01, 0x20}, {0x21, 0x00}},
                          interlaced,
                          {{255, 255, 255}, {0, 0, 200}, {0, 0, 0}},
                          {255, 255, 0}};
    EXPECT_EQ(read_image(image), drawn({".#.", ".#."})) << "the third entry is transparent";
  }
}

TEST_F(Io, RefusesColoursBeyondThePalette) {
  TestImage image{3, 1, 2, PNG_COLOR_TYPE_PALETTE, {{0b00011000}}};
  image.palette = {{255, 255, 255}, {0, 0, 0}};
  for (const bool interlaced : {false, true}) {
    image.interlaced = interlaced;
    image.rows = {{0b00010000}};
    EXPECT_EQ(read_image(image), drawn({".#."}));
    image.rows = {{0b00011000}};
    const Error error = error_of([&] { return read_image(image); }, "colour 2 of 2");
    EXPECT_EQ(error.code(), ErrorCode::file_broken);
    expect_says(error.problem(), "colour 2 of a palette that has 2");
    // Behind the pixels, and behind their checksum where this was the last row; IEND follows.
    const auto size = static_cast<std::int64_t>(png_of(image).size());
    EXPECT_EQ(error.place().offset, size - 12 - (interlaced ? 4 : 0));
  }
}

TEST_F(Io, SeesTransparencyOnAWhitePage) {
  const Bytes grey_alpha = {0, 255, 0, 0, 0, 127, 0, 128, 255, 128};
  EXPECT_EQ(read_image({5, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {grey_alpha}}), drawn({"#..#."}));
  const Bytes rgba16 = {0, 0, 0, 0, 0, 0, 0x7f, 0xff, 0, 0, 0, 0, 0, 0, 0x80, 0x00};
  EXPECT_EQ(read_image({2, 1, 16, PNG_COLOR_TYPE_RGB_ALPHA, {rgba16}}), drawn({".#"}));
  TestImage keyed{3, 1, 8, PNG_COLOR_TYPE_GRAY, {{0, 9, 255}}};
  keyed.transparent_grey = 9;
  EXPECT_EQ(read_image(keyed), drawn({"#.."})) << "grey 9 is transparent";
}

TEST_F(Io, FreeBelowHoldsForPng) {
  const TestImage image{4, 1, 8, PNG_COLOR_TYPE_GRAY, {{0, 50, 130, 255}}};
  EXPECT_EQ(read_image(image, {.free_below = 0.9}), drawn({"#..."}));
  EXPECT_EQ(read_image(image, {.free_below = 0.3}), drawn({"###."}));
  EXPECT_THROW(read_image(image, {.free_below = 0}), Error);
}

TEST_F(Io, APictureThatCannotBeWrittenIsAnError) {
  for (const std::string& name : {path("none/a.png"), path("."), std::string("/dev/full")}) {
    const Error error = error_of([&] { write_png(Grid(300, 300), name); }, name);
    EXPECT_EQ(error.code(), ErrorCode::output_failed) << name;
  }
}

// A PNG whose header lies about its size.
std::string resized(std::string content, std::uint32_t width, std::uint32_t height) {
  put_number(content, 16, width);
  put_number(content, 20, height);
  put_number(content, 29, crc_of(content.substr(12, 17)));
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
      const Error error = error_of([&] { return read_any_map(file(content.substr(0, size))); },
                                   std::to_string(size) + " bytes");
      EXPECT_EQ(error.code(), ErrorCode::file_broken) << error.what();
      // At its end, or at the size where that says already that more must follow.
      const bool by_size = error.problem().find("cells need at least") != std::string::npos;
      ASSERT_EQ(error.place().offset, by_size ? 16 : static_cast<std::int64_t>(size));
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
    const std::string other = resized(content, c.width, c.height);
    const Error error = error_of([&] { return read_any_map(file(other)); });
    EXPECT_EQ(error.code(), c.code) << error.what();
    // libpng itself refuses what is no size, once it has read the header and its checksum.
    const bool is_size = c.width - 1 < 0x7fffffffU;
    EXPECT_EQ(error.place().offset, is_size ? 16 : 33) << error.what();
  }
}

TEST_F(Io, SkipsWhatPixelsDoNotNeed) {
  const std::string content = png_of({2, 1, 8, PNG_COLOR_TYPE_GRAY, {{0, 255}}});
  constexpr std::size_t kHeader = 33;
  for (const std::string& chunk : {chunk_of("gAMA", "x"), chunk_of("tEXt", "no keyword"),
                                   chunk_of("iCCP", "none"), chunk_of("whAt", "is this?")}) {
    for (const std::size_t at : {kHeader, content.size() - 12}) {
      std::string more = content;
      EXPECT_EQ(read_any_map(file(more.insert(at, chunk))).grid, drawn({"#."})) << chunk;
    }
  }
}

}  // namespace
}  // namespace lasius
