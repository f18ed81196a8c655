#include "core/map_files/map_size.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "lasius/grid/grid.h"

namespace lasius {

void check_map_size(const ByteReader& in, SizePlace place, std::int64_t width,
                    std::int64_t height) {
  const Error::Place where{in.name(), place.line, place.offset};
  if (std::min(width, height) < 1)
    throw Error(ErrorCode::file_broken, where, "the size is " + size_text(width, height),
                "width and height must be at least 1");
  if (std::max(width, height) > Grid::kMaxSide)
    throw Error(
        ErrorCode::file_unsupported, where, "the size is " + size_text(width, height),
        "at most " + size_text(Grid::kMaxSide, Grid::kMaxSide) + " is read: cut or scale the map");
}

void check_bytes_left(ByteReader& in, SizePlace place, std::int64_t width, std::int64_t height,
                      std::int64_t needed) {
  const std::int64_t left = in.find_left();
  if (left < 0 || left >= needed) return;
  throw Error(ErrorCode::file_broken, Error::Place{in.name(), place.line, place.offset},
              size_text(width, height) + " cells need at least " + std::to_string(needed) +
                  " more bytes, but only " + std::to_string(left) + " follow",
              "correct the size, or get the whole file");
}

}  // namespace lasius
