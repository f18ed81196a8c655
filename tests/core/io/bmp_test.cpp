#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lasius/base/error.h"
#include "tests/core/base/refusal.h"
#include "tests/core/io/images.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using namespace std::string_literals;

std::string number(std::int64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 255);
  return text;
}

struct Bmp {
  int bits = 24;
  int header = 40;
  bool top_down = false;
  int compression = 0;
  std::vector<std::string> palette = {};  ///< blue, green, red of each
  int gap = 0;                            ///< bytes before the pixels
  int width = 5, height = 2;
};

/// Rows of pixels, from the top, as numbers of `bits` bits.
std::string bmp_of(const Bmp& bmp, const std::vector<std::vector<std::uint32_t>>& rows) {
  const bool core = bmp.header == 12;
  std::string info = number(bmp.header, 4);
  info += core ? number(bmp.width, 2) + number(bmp.height, 2)
               : number(bmp.width, 4) + number(bmp.top_down ? -bmp.height : bmp.height, 4);
  info += number(1, 2) + number(bmp.bits, 2);
  if (!core) {
    info += number(bmp.compression, 4) + std::string(12, '\0');
    info += number(static_cast<std::int64_t>(bmp.palette.size()), 4) + number(0, 4);
  }
  if (bmp.compression == 3)
    info += number(0xff0000, 4) + number(0xff00, 4) + number(0xff, 4) + number(0xff000000, 4);
  info.resize(std::max<std::size_t>(info.size(), bmp.header), '\0');
  if (bmp.header == 40 && bmp.compression == 3) info.resize(52);
  for (const std::string& colour : bmp.palette) info += core ? colour : colour + "\0"s;
  info += std::string(bmp.gap, 'g');
  std::string pixels;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[bmp.top_down ? i : rows.size() - 1 - i];
    std::string bytes;
    int filled = 0;  // bits of the last byte
    for (const std::uint32_t pixel : row) {
      if (bmp.bits >= 8) {
        bytes += number(pixel, bmp.bits / 8);
        continue;
      }
      if (filled % 8 == 0) bytes += '\0';
      filled += bmp.bits;
      bytes.back() = static_cast<char>(bytes.back() | pixel << (8 - (filled - 1) % 8 - 1));
    }
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    pixels += bytes;
  }
  const auto offset = static_cast<std::int64_t>(14 + info.size());
  return "BM" + number(offset + static_cast<std::int64_t>(pixels.size()), 4) + number(0, 4) +
         number(offset, 4) + info + pixels;
}

const std::string kBlack = "\0\0\0"s, kWhite = "\xff\xff\xff";
const std::vector<std::vector<std::uint32_t>> kIndices{{0, 1, 1, 0, 1}, {1, 1, 0, 0, 1}};

TEST_F(Io, ReadsBmpOfEveryDepth) {
  const Grid expected = drawn({"#..#.", "..##."});
  std::vector<std::vector<std::uint32_t>> colours = kIndices;
  for (auto& row : colours)
    for (auto& pixel : row) pixel = pixel == 0 ? 0x101010 : 0xf0f0f0;
  for (const bool top_down : {false, true}) {
    for (const int bits : {1, 4, 8})
      EXPECT_EQ(read_any_map(
                    file(bmp_of(
                        {.bits = bits, .top_down = top_down, .palette = {kBlack, kWhite}, .gap = 7},
                        kIndices)))
                    .grid,
                expected)
          << bits;
    for (const int bits : {24, 32})
      for (const int header : {40, 52, 56, 108, 124})
        EXPECT_EQ(
            read_map(file(bmp_of({.bits = bits, .header = header, .top_down = top_down}, colours)))
                .grid,
            expected)
            << bits << ", header of " << header;
  }
  EXPECT_EQ(
      read_map(file(bmp_of({.bits = 1, .header = 12, .palette = {kWhite, kBlack}}, kIndices))).grid,
      drawn({".##.#", "##..#"}));
  // Red, green, blue by their luma: 54, 182 and 18 of 255.
  EXPECT_EQ(read_map(file(bmp_of({.width = 3, .height = 1}, {{0xff0000, 0xff00, 0xff}}))).grid,
            drawn({"#.#"}));
}

TEST_F(Io, AlphaOfABmpCountsWhereTheHeaderNamesIt) {
  const std::vector<std::vector<std::uint32_t>> row{{0x00000000, 0xff000000, 0xffffffff}};
  const Bmp named{.bits = 32, .header = 108, .compression = 3, .width = 3, .height = 1};
  Bmp plain = named;
  plain.compression = 0;
  Bmp masks = named;
  masks.header = 40;
  EXPECT_EQ(read_map(file(bmp_of(named, row))).grid, drawn({".#."})) << "seen on a white page";
  EXPECT_EQ(read_map(file(bmp_of(plain, row))).grid, drawn({"##."}));
  EXPECT_EQ(read_map(file(bmp_of(masks, row))).grid, drawn({"##."}));
  file(bmp_of(named, row), "map.bmp");
  const Map ros = read_any_map(
      file("image: map.bmp\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
           "free_thresh: 0.196\n",
           "map.yaml"));
  EXPECT_EQ(ros.grid, drawn({"##."}));
  EXPECT_EQ(ros.unknown, drawn({"#.."}));
}

TEST_F(Io, RefusesBrokenBmp) {
  const std::vector<std::string> whole{
      bmp_of({.bits = 8, .palette = {kBlack, kWhite}}, kIndices), bmp_of({.bits = 24}, kIndices),
      bmp_of({.bits = 1, .header = 12, .palette = {kBlack, kWhite}}, kIndices)};
  for (const std::string& bytes : whole)
    for (std::size_t size = 3; size < bytes.size() - 3;
         ++size) {  // of padding three may be missing
      const Error error = error_of([&] { return read_map(file(bytes.substr(0, size))); });
      EXPECT_EQ(error.code(), ErrorCode::file_broken) << size << ": " << error.what();
      EXPECT_LE(error.place().offset, static_cast<std::int64_t>(size));
    }
  const auto refused = [&](std::size_t at, const std::string& bytes, ErrorCode code,
                           const char* says) {
    std::string content = whole[0];
    content.replace(at, bytes.size(), bytes);
    const Error error = error_of([&] { return read_map(file(content)); });
    EXPECT_EQ(error.code(), code) << error.what();
    expect_says(error, says);
    EXPECT_FALSE(error.remedy().empty());
  };
  constexpr auto kBroken = ErrorCode::file_broken, kUnsupported = ErrorCode::file_unsupported;
  refused(10, number(20, 4), kBroken, "before its header ends");
  refused(10, number(1 << 30, 4), kBroken, "more bytes");
  refused(14, number(41, 4), kUnsupported, "header of 41 bytes");
  refused(18, number(0, 4), kBroken, "size is 0 x 2");
  refused(18, number(-5, 4), kBroken, "size is -5 x 2");
  refused(18, number(40000, 4), kUnsupported, "at most 32768");
  refused(22, number(INT32_MIN, 4), kUnsupported, "5 x 2147483648");
  refused(22, number(30000, 4), kBroken, "more bytes");
  refused(28, number(16, 2), kUnsupported, "16 bits");
  refused(30, number(1, 4), kUnsupported, "compression 1");
  refused(46, number(300, 4), kBroken, "palette of 300");
  refused(46, number(1, 4), kBroken, "colour 1 of a palette that has 1");
}

}  // namespace
}  // namespace lasius
