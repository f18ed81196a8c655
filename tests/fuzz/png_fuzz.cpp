// PNG. The chunks' checksums are put right first: otherwise nearly all inputs end at the first one.
#include <zlib.h>

#include "core/io/png_reader.h"
#include "tests/fuzz/reading.h"

namespace lasius::fuzz {
namespace {

constexpr std::size_t kSignature = 8;

std::size_t number_at(const std::string& bytes, std::size_t at) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return number;
}

void mend_checksums(std::string& bytes) {
  for (std::size_t at = kSignature; at + 12 <= bytes.size();) {
    const std::size_t length = number_at(bytes, at);
    if (length > bytes.size() - at - 12) return;
    const auto* type = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
    const uLong crc = crc32(0, type, static_cast<uInt>(length + 4));
    for (std::size_t i = 0; i < 4; ++i) {
      bytes[at + 8 + length + i] = static_cast<char>(crc >> (24 - 8 * i) & 255);
    }
    at += 12 + length;
  }
}

}  // namespace

void check(const std::string& given) {
  if (!is_png(given)) return;
  std::string bytes = given;
  mend_checksums(bytes);
  PixelRule rule = plain_rule(0.5);
  const auto read = [&](ByteReader& in) { return read_png(in, rule); };
  const auto grid = read_bytes(bytes, true, read);
  rule.transparent = PixelRule::Transparent::unknown;
  const auto strict = read_bytes(bytes, true, read);
  require(grid.has_value() == strict.has_value());
}

}  // namespace lasius::fuzz
