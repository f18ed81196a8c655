// Maps of the MovingAI benchmarks (Sturtevant 2012): a header and one character a cell.
#pragma once

#include <ostream>

#include "core/map_files/byte_reader.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// True for what starts like a .map file.
LASIUS_EXPORT bool is_movingai(std::string_view head) noexcept;

/// Reads a map: '.', 'G' and 'S' (swamp) are free, '@', 'O', 'T' and 'W' (water) blocked.
/// @throws Error(file_broken, file_unsupported) with the line.
LASIUS_EXPORT Grid read_movingai(ByteReader& in);

/// Writes '.' for free and '@' for blocked cells.
void write_movingai(const Grid& grid, std::ostream& out);

}  // namespace lasius
