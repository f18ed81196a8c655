// Grey levels of an image, as layers of costs have them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lasius/io.h"

namespace lasius {

// Exported for the program only; not part of the public API.
struct GreyImage {
  int width = 0, height = 0;
  int white = 255;                    ///< the largest level that a pixel could have
  std::vector<std::uint16_t> levels;  ///< row by row from the top; 0 is black
};

/// Reads PNG, PGM, PBM or BMP; colours by their luma, on a white page where they are transparent.
/// @throws as read_any_map.
LASIUS_IO_EXPORT GreyImage read_grey_image(const std::string& path);

}  // namespace lasius
