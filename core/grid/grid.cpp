#include "lasius/grid.h"

#include <bit>
#include <string>

#include "lasius/error.h"

namespace lasius {
namespace {

int checked_side(const char* name, int side) {
  if (side >= 1 && side <= Grid::kMaxSide) return side;
  throw Error(ErrorCode::invalid_parameter, std::string(name) + " is " + std::to_string(side),
              "it must be 1 to " + std::to_string(Grid::kMaxSide));
}

// Bits of the last word of a row that lie past the width.
std::uint64_t past_width(int width) noexcept {
  const int used = width & 63;
  return used == 0 ? 0 : ~std::uint64_t{0} << used;
}

}  // namespace

Grid::Grid(int width, int height)
    : width_(checked_side("width", width)),
      height_(checked_side("height", height)),
      words_((width + 63) / 64) {
  // One guard word before each row serves as the one after the row above it, too.
  bits_.assign((static_cast<std::size_t>(height) + 2) * stride() + 1, ~std::uint64_t{0});
  const std::vector<std::uint64_t> free_row(words_, 0);
  for (int y = 0; y < height; ++y) set_row(y, free_row.data());
}

void Grid::set_blocked(Cell c, bool blocked) noexcept {
  std::uint64_t& word = mutable_row(c.y)[c.x >> 6];
  const std::uint64_t bit = std::uint64_t{1} << (c.x & 63);
  word = blocked ? word | bit : word & ~bit;
}

void Grid::set_row(int y, const std::uint64_t* words) noexcept {
  std::uint64_t* target = mutable_row(y);
  for (int i = 0; i < words_; ++i) target[i] = words[i];
  target[words_ - 1] |= past_width(width_);
}

std::int64_t Grid::count_free() const noexcept {
  std::int64_t blocked = 0;
  for (int y = 0; y < height_; ++y) {
    const auto* words = row(y);
    for (int i = 0; i < words_; ++i) blocked += std::popcount(words[i]);
  }
  return static_cast<std::int64_t>(words_) * 64 * height_ - blocked;
}

std::uint64_t Grid::hash() const noexcept {
  // Murmur3's finaliser over each word, chained: not cryptographic, enough to tell maps apart.
  const auto mix = [](std::uint64_t h) noexcept {
    h ^= h >> 33;
    h *= 0xff51afd7ed558ccdULL;
    h ^= h >> 33;
    h *= 0xc4ceb9fe1a85ec53ULL;
    return h ^ (h >> 33);
  };
  std::uint64_t h =
      mix((static_cast<std::uint64_t>(width_) << 32) ^ static_cast<std::uint64_t>(height_));
  for (int y = 0; y < height_; ++y) {
    const auto* words = row(y);
    for (int i = 0; i < words_; ++i) h = mix(h ^ words[i]) + 0x9e3779b97f4a7c15ULL;
  }
  return h;
}

}  // namespace lasius
