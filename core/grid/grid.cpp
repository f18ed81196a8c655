#include "lasius/grid/grid.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"

namespace lasius {
namespace {

int checked_side(const char* name, int side) {
  if (side >= 1 && side <= Grid::kMaxSide) return side;
  refuse(std::string(name) + " is " + std::to_string(side),
         "it must be 1 to " + std::to_string(Grid::kMaxSide));
}

// Bits of the last word of a row that lie past the width.
std::uint64_t past_width(int width) noexcept {
  const int used = width & 63;
  return used == 0 ? 0 : ~std::uint64_t{0} << used;
}

/// @throws Error(invalid_parameter) unless there is a byte for each cell of a rectangle.
void check_bytes(std::size_t count, int width, int height) {
  const auto needed = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (count == needed) return;
  refuse(std::to_string(count) + " bytes are given for " + size_text(width, height) + " cells",
         "give " + std::to_string(needed) + ", one a cell, row by row");
}

/// Eight bytes as eight bits, the first one lowest; set where the byte is not 0.
std::uint64_t packed(const std::uint8_t* bytes) noexcept {
  static_assert(std::endian::native == std::endian::little);
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  // The top bit of each byte that is not 0; then all of them side by side.
  constexpr std::uint64_t kLow = 0x7f7f7f7f7f7f7f7fULL;
  const std::uint64_t set = ((((word & kLow) + kLow) | word) & ~kLow) >> 7;
  return (set * 0x0102040810204080ULL) >> 56;
}

/// Bits from `count` bytes, up to 64; set where the byte is not 0.
std::uint64_t packed(const std::uint8_t* bytes, int count) noexcept {
  std::uint64_t bits = 0;
  int i = 0;
  for (; i + 8 <= count; i += 8) bits |= packed(bytes + i) << i;
  for (; i < count; ++i) bits |= std::uint64_t{bytes[i] != 0} << i;
  return bits;
}

/// Calls visit(word, bit, count, first) for each word of a row that holds some of the columns x to
/// x + width - 1: its index, its first bit that does, how many do, and that bit's column from x.
template <class Visit>
void for_each_word(int x, int width, const Visit& visit) {
  for (int from = x; from < x + width;) {
    const int bit = from & 63;
    const int count = std::min(64 - bit, x + width - from);
    visit(from >> 6, bit, count, from - x);
    from += count;
  }
}

std::uint64_t low_bits(int count) noexcept { return ~std::uint64_t{0} >> (64 - count); }

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

Grid::Grid(int width, int height, std::span<const std::uint8_t> cells, Nonzero nonzero)
    : Grid(width, height) {
  paste({0, 0, width, height}, cells, nonzero);
}

Grid::Grid(Grid&& other) noexcept
    : width_(std::exchange(other.width_, 0)),
      height_(std::exchange(other.height_, 0)),
      words_(std::exchange(other.words_, 0)),
      bits_(std::exchange(other.bits_, {})) {}

Grid& Grid::operator=(Grid&& other) noexcept {
  width_ = std::exchange(other.width_, 0);
  height_ = std::exchange(other.height_, 0);
  words_ = std::exchange(other.words_, 0);
  bits_ = std::exchange(other.bits_, {});
  return *this;
}

void Grid::check_inside(const Rectangle& part) const {
  const bool inside = part.x >= 0 && part.y >= 0 && part.width >= 0 && part.height >= 0 &&
                      part.width <= width_ - part.x && part.height <= height_ - part.y;
  if (inside) return;
  refuse("the rectangle of " + size_text(part.width, part.height) + " cells at " +
             pair_text(part.x, part.y) + " is not inside the map",
         "the map is " + size_text(width_, height_) + " cells");
}

void Grid::fill(const Rectangle& part, bool blocked) {
  check_inside(part);
  for (int y = part.y; y < part.y + part.height; ++y) {
    std::uint64_t* const words = mutable_row(y);
    for_each_word(part.x, part.width, [&](int word, int bit, int count, int) {
      const std::uint64_t mask = low_bits(count) << bit;
      words[word] = blocked ? words[word] | mask : words[word] & ~mask;
    });
  }
}

void Grid::paste(const Rectangle& part, std::span<const std::uint8_t> cells, Nonzero nonzero) {
  check_inside(part);
  check_bytes(cells.size(), part.width, part.height);
  const std::uint64_t flip = nonzero == Nonzero::blocked ? 0 : ~std::uint64_t{0};
  const std::uint8_t* from = cells.data();
  for (int y = part.y; y < part.y + part.height; ++y, from += part.width) {
    std::uint64_t* const words = mutable_row(y);
    for_each_word(part.x, part.width, [&](int word, int bit, int count, int first) {
      const std::uint64_t mask = low_bits(count) << bit;
      const std::uint64_t bits = ((packed(from + first, count) << bit) ^ flip) & mask;
      words[word] = (words[word] & ~mask) | bits;
    });
  }
}

std::vector<std::uint8_t> Grid::bytes(const Rectangle& part, Nonzero nonzero) const {
  check_inside(part);
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(part.width) *
                                  static_cast<std::size_t>(part.height));
  const std::uint64_t flip = nonzero == Nonzero::blocked ? 0 : 1;
  std::uint8_t* to = cells.data();
  for (int y = part.y; y < part.y + part.height; ++y, to += part.width) {
    const std::uint64_t* const words = row(y);
    for_each_word(part.x, part.width, [&](int word, int bit, int count, int first) {
      const std::uint64_t bits = words[word] >> bit;
      for (int i = 0; i < count; ++i)
        to[first + i] = static_cast<std::uint8_t>(((bits >> i) & 1) ^ flip);
    });
  }
  return cells;
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
