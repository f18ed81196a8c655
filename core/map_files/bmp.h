// Uncompressed BMP: BITMAPCOREHEADER, BITMAPINFOHEADER and its successors.
#pragma once

#include <string_view>

#include "core/map_files/byte_reader.h"
#include "core/map_files/pixel_rule.h"

namespace lasius {

/// True for what starts like a BMP file.
LASIUS_EXPORT bool is_bmp(std::string_view head) noexcept;

/// Reads one image row by row, from the bottom or the top: 1, 4 or 8 bits a pixel with a palette,
/// 24 bits, or 32 bits, whose alpha counts where the header names it.
/// @throws Error(file_broken, file_unsupported) with the byte offset.
LASIUS_EXPORT Map read_bmp(ByteReader& in, const PixelRule& rule);

}  // namespace lasius
