#include "tools/report/packed.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string_view>

namespace lasius::tool {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes from_base64(std::string_view text) {
  static constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  Bytes bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(kLetters.find(letter));
    if ((count += 6) >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (count -= 8)));
  }
  return bytes;
}

Bytes unpacked(std::string_view text, std::size_t size) {
  EXPECT_EQ(text.size() % 4, 0U);
  const Bytes packed = from_base64(text);
  Bytes bytes(size + 1);
  auto length = static_cast<uLongf>(bytes.size());
  EXPECT_EQ(uncompress(bytes.data(), &length, packed.data(), static_cast<uLong>(packed.size())),
            Z_OK);
  bytes.resize(length);
  return bytes;
}

TEST(Packed, BytesOfEveryLengthComeBack) {
  for (std::size_t size = 0; size < 50; ++size) {
    Bytes bytes;
    for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(37 * i * i));
    EXPECT_EQ(unpacked(packed(std::span<const std::uint8_t>(bytes)), size), bytes) << size;
  }
}

TEST(Packed, WhatRepeatsTakesLittleRoom) {
  const Bytes bytes(1'000'000, 7);
  EXPECT_LT(packed(std::span<const std::uint8_t>(bytes)).size(), 2000U);
}

TEST(Packed, NumbersAreFourBytesTheLowOneFirst) {
  const std::vector<float> values{1.0F, -2.5F};
  EXPECT_EQ(unpacked(packed(values), 8), (Bytes{0, 0, 0x80, 0x3f, 0, 0, 0x20, 0xc0}));
}

TEST(Packed, FramesAreDifferences) {
  EXPECT_EQ(unpacked(packed_frames({{1, 200, 3}, {1, 100, 4}, {0, 100, 4}}), 9),
            (Bytes{1, 200, 3, 0, 156, 1, 255, 0, 0}));
  EXPECT_TRUE(unpacked(packed_frames({}), 0).empty());
}

}  // namespace
}  // namespace lasius::tool
