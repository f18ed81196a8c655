#include "tools/report/packed.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string_view>

namespace lasius::tool {
namespace {

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes) {
  auto size = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<std::uint8_t> result(size);
  if (compress2(result.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), 6) != Z_OK)
    throw std::runtime_error("zlib cannot pack a report's frames");
  result.resize(size);
  return result;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  static constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < here ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= here ? kLetters[word >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

}  // namespace

std::string packed(std::span<const std::uint8_t> bytes) { return base64(deflated(bytes)); }

std::string packed(std::span<const float> values) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4 * values.size());
  for (const float value : values)
    for (int shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<std::uint8_t>(std::bit_cast<std::uint32_t>(value) >> shift));
  return packed(std::span<const std::uint8_t>(bytes));
}

std::string packed_frames(const std::vector<std::vector<std::uint8_t>>& frames) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t k = 0; k < frames[i].size(); ++k)
      bytes.push_back(
          static_cast<std::uint8_t>(frames[i][k] - (i > 0 ? frames[i - 1][k] : std::uint8_t{0})));
  return packed(std::span<const std::uint8_t>(bytes));
}

}  // namespace lasius::tool
