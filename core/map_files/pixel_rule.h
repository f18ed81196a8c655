// What the pixels of an image are as cells, and the map that they make.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "lasius/export.h"
#include "lasius/grid/map_io.h"

namespace lasius {

// Exported for lasius::io only; not part of the public API.
struct PixelRule {
  /// Bits of what a pixel is; none: known to be free.
  enum Kind : std::uint8_t { kFree = 0, kBlocked = 1, kUnknown = 2 };

  /// What an opaque pixel is; `level` in [0, white], 0 is black.
  std::function<int(int level, int white)> kind;
  /// What an unknown pixel is, kUnknown with kBlocked or without; kFree: none is unknown.
  int unknown = kFree;

  /// What a pixel is that is not fully opaque.
  enum class Transparent {
    on_white,  ///< seen on a white page
    unknown,
    ignored,  ///< its colour counts as if it were opaque
  };
  Transparent transparent = Transparent::on_white;

  /// Gets the pixels, numbers of 16 bits row by row from the top; null: kinds, which make the map.
  std::vector<std::uint16_t>* numbers = nullptr;

  /// `kind` of every level.
  std::vector<std::uint16_t> table(int white) const {
    std::vector<std::uint16_t> result(static_cast<std::size_t>(white) + 1);
    for (int level = 0; level <= white; ++level)
      result[level] = static_cast<std::uint16_t>(kind(level, white));
    return result;
  }

  /// What a pixel of this alpha is, 0: transparent; `kinds`: a table.
  int kind_of(const std::vector<std::uint16_t>& kinds, std::int64_t level,
              std::int64_t alpha) const noexcept {
    const auto white = static_cast<std::int64_t>(kinds.size()) - 1;
    if (alpha < white) {
      if (transparent == Transparent::unknown) return unknown;
      if (transparent == Transparent::on_white)
        level = (level * alpha + white * (white - alpha) + white / 2) / white;
    }
    return kinds[static_cast<std::size_t>(level)];
  }

  /// What pixels make: a free map, without unknown cells yet.
  Map map(int width, int height) const {
    Map made{Grid(width, height), std::nullopt};
    if (unknown != kFree) made.unknown.emplace(width, height);
    if (numbers != nullptr) numbers->resize(static_cast<std::size_t>(width) * height);
    return made;
  }
};

/// Grey of a colour, as light as it (Rec. 709).
constexpr std::int64_t luma(std::int64_t red, std::int64_t green, std::int64_t blue) noexcept {
  return (2126 * red + 7152 * green + 722 * blue + 5000) / 10000;
}

/// One row of a map, pixel by pixel.
class PixelRow {
 public:
  PixelRow(const Grid& grid, const PixelRule& rule)
      : blocked(grid.words()), unknown(grid.words()), numbers_(rule.numbers) {
    if (numbers_ != nullptr) row_.resize(grid.width());
  }
  void add(int x, int kind) noexcept {
    if (numbers_ != nullptr) {
      row_[x] = static_cast<std::uint16_t>(kind);
      return;
    }
    const auto bits = static_cast<std::uint64_t>(kind);
    blocked[x >> 6] |= (bits & PixelRule::kBlocked) << (x & 63);
    unknown[x >> 6] |= bits >> 1 << (x & 63);
  }
  /// Puts it into the map, or among the numbers, and begins the next one.
  void end(int y, Map& map) {
    if (numbers_ != nullptr) {
      std::ranges::copy(row_,
                        numbers_->begin() + static_cast<std::ptrdiff_t>(y) * std::ssize(row_));
      return;
    }
    map.grid.set_row(y, blocked.data());
    if (map.unknown) map.unknown->set_row(y, unknown.data());
    std::ranges::fill(blocked, 0);
    std::ranges::fill(unknown, 0);
  }

  std::vector<std::uint64_t> blocked, unknown;  ///< words, as of a grid's row

 private:
  std::vector<std::uint16_t>* numbers_;
  std::vector<std::uint16_t> row_;
};

/// Plain images: free where the darkness (white - level) / white lies below `free_below`.
/// @throws Error(invalid_parameter) unless 0 < free_below <= 1.
LASIUS_EXPORT PixelRule plain_rule(double free_below);

}  // namespace lasius
