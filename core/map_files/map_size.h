// The checks that a map's header passes before memory is taken for it.
#pragma once

#include <cstdint>

#include "core/map_files/byte_reader.h"

namespace lasius {

/// Where in the file the size stands: a line or an offset.
struct SizePlace {
  std::int64_t line = -1;
  std::int64_t offset = -1;
};

/// @throws Error(file_broken) for a side below 1, Error(file_unsupported) for one above
///         Grid::kMaxSide.
LASIUS_EXPORT void check_map_size(const ByteReader& in, SizePlace place, std::int64_t width,
                                  std::int64_t height);

/// Refuses a map that needs at least `needed` more bytes than follow. Of a stream of unknown size
/// only that much is looked at that the reader holds at a time. @throws Error(file_broken)
LASIUS_EXPORT void check_bytes_left(ByteReader& in, SizePlace place, std::int64_t width,
                                    std::int64_t height, std::int64_t needed);

}  // namespace lasius
