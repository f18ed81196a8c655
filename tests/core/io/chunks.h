// PNG files put together by their chunks, so that chunks may lie.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>

namespace lasius {

inline const std::string kPngSignature = "\x89PNG\r\n\x1a\n";

/// Puts a number in the order of PNG over four bytes.
inline void put_number(std::string& content, std::size_t at, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i) {
    content[at + i] = static_cast<char>(number >> (24 - 8 * i) & 255);
  }
}

inline std::uint32_t crc_of(const std::string& bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// A whole chunk; `name` has four letters.
inline std::string chunk_of(const std::string& name, const std::string& bytes) {
  std::string length(4, '\0'), sum(4, '\0');
  put_number(length, 0, static_cast<std::uint32_t>(bytes.size()));
  put_number(sum, 0, crc_of(name + bytes));
  return length + name + bytes + sum;
}

/// The chunk IHDR.
inline std::string header_chunk(std::uint32_t width, std::uint32_t height, int depth, int colour) {
  std::string bytes(13, '\0');
  put_number(bytes, 0, width);
  put_number(bytes, 4, height);
  bytes[8] = static_cast<char>(depth);
  bytes[9] = static_cast<char>(colour);
  return chunk_of("IHDR", bytes);
}

inline std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  packed.resize(size);
  return packed;
}

}  // namespace lasius
