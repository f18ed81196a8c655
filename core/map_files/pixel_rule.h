// Which pixels of an image are blocked cells.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "lasius/export.h"

namespace lasius {

// Exported for lasius::io only; not part of the public API.
struct PixelRule {
  /// Whether an opaque pixel is blocked; `level` in [0, white], 0 is black.
  std::function<bool(int level, int white)> blocked;

  /// What a pixel is that is not fully opaque.
  enum class Transparent {
    on_white,  ///< seen on a white page
    blocked,
    free,
    ignored,  ///< its colour counts as if it were opaque
  };
  Transparent transparent = Transparent::on_white;

  /// `blocked` for every level, 1 or 0.
  std::vector<std::uint8_t> table(int white) const {
    std::vector<std::uint8_t> result(static_cast<std::size_t>(white) + 1);
    for (int level = 0; level <= white; ++level) result[level] = blocked(level, white) ? 1 : 0;
    return result;
  }
};

/// Plain images: free where the darkness (white - level) / white lies below `free_below`.
/// @throws Error(invalid_parameter) unless 0 < free_below <= 1.
LASIUS_EXPORT PixelRule plain_rule(double free_below);

}  // namespace lasius
