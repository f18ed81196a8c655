// Shared by the fuzz targets: bytes as a file, and what a reader may do with them.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

#include "core/map_files/byte_reader.h"
#include "lasius/base/error.h"

namespace lasius::fuzz {

/// Of each target: tries one input.
void check(const std::string& bytes);

/// Ends the fuzzer where `holds` is false.
inline void require(bool holds) {
  if (!holds) std::abort();
}

/// Ends the fuzzer unless the error names the file, no offset past its `size` bytes, and a remedy.
inline void require_named(const Error& error, std::size_t size) {
  require(error.place().file == "fuzz" && !error.problem().empty() && !error.remedy().empty());
  require(error.place().offset <= static_cast<std::int64_t>(size));
}

/// What `read(ByteReader&)` returns, or nothing where it refuses the bytes as it should: with an
/// Error that names the file, a line or offset within it, and a remedy.
template <typename Read>
auto read_bytes(const std::string& bytes, bool size_known, Read read)
    -> std::optional<decltype(read(std::declval<ByteReader&>()))> {
  std::istringstream stream(bytes);
  ByteReader in(stream, "fuzz", size_known ? static_cast<std::int64_t>(bytes.size()) : -1);
  try {
    return read(in);
  } catch (const Error& error) {
    require_named(error, bytes.size());
    require((error.place().line >= 0) != (error.place().offset >= 0));
    return std::nullopt;
  }
}

}  // namespace lasius::fuzz
