// PBM and PGM, ASCII and binary (P1, P2, P4, P5), as the netpbm manual defines them.
#pragma once

#include "core/map_files/byte_reader.h"
#include "core/map_files/pixel_rule.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// True for what starts like a PBM or PGM file.
LASIUS_EXPORT bool is_pnm(std::string_view head) noexcept;

/// Reads one image row by row; pixels of a PBM have level 0 (1, black) or 1 of white 1.
/// @throws Error(file_broken, file_unsupported) with the line (ASCII) or byte offset (binary).
LASIUS_EXPORT Map read_pnm(ByteReader& in, const PixelRule& rule);

/// Writes a binary PBM (P4), blocked = 1 = black.
void write_pbm(const Grid& grid, std::ostream& out);

}  // namespace lasius
