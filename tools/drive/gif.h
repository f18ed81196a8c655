// Films as GIF, through giflib.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <vector>

#include "tools/draw/raster.h"

namespace lasius::tool {

/// @throws UsageError where the program was built without giflib.
void check_films();

/// Writes frames of one size, pixels as numbers of colours, at most 256, to be shown over and over.
/// A frame holds the part that differs from the one before. The last one stays for two seconds.
void write_gif(std::ostream& out, std::span<const Colour> colours,
               const std::vector<Raster<std::uint8_t>>& frames, int hundredths_a_frame);

}  // namespace lasius::tool
