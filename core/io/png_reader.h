// Reading PNG row by row.
#pragma once

#include <string_view>

#include "core/map_files/byte_reader.h"
#include "core/map_files/pixel_rule.h"

namespace lasius {

/// True for what starts with the PNG signature.
bool is_png(std::string_view head) noexcept;

/// Reads one image, one row at a time; interlaced ones pass by pass into the grid itself.
/// @throws Error(file_broken, file_unsupported) with the byte offset.
Map read_png(ByteReader& in, const PixelRule& rule);

}  // namespace lasius
