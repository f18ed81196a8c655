// From which cells each motion of a lattice is free, as bits of the whole map.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/vehicle/lattice.h"
#include "core/vehicle/sweep.h"

namespace lasius::vehicle {

/// What Masks::free() says of masks from the cells of a row of the map, at once: a row of a mask is
/// runs of columns, and a map whose blocked cells are spread over 2^k columns answers a run by two
/// of its rows.
class MaskRows {
 public:
  MaskRows(const Space::Impl& space, const Masks& masks, std::span<const Masks::Mask> of);

  int words() const noexcept { return (width_ + 63) / 64; }  ///< of a row
  /// Words first to last of row y: bit i of word w says whether the mask is free from cell
  /// (64 w + i, y); outside of the map it is not. O(rows of the mask) a word.
  void free(int mask, int y, int first, int last, std::uint64_t* to) const;
  /// Rows of a mask's runs, by which steps are counted.
  std::int64_t parts(int mask) const { return static_cast<std::int64_t>(parts_[mask].size()); }

 private:
  /// A row of a mask: whether columns first .. first + 2^spread - 1, from its cell, are blocked.
  struct Part {
    int y, first, spread;
  };
  static constexpr int kSpreads = 7;  ///< over 1, 2, ... 64 columns: a mask has no longer run

  static std::vector<Part> parts_of(const Masks& masks, const Masks::Mask& mask);
  /// The words from column x, a multiple of 64, on.
  std::ptrdiff_t at(int y, int x) const noexcept {
    return static_cast<std::ptrdiff_t>(y + above_) * stride_ + ((x + left_) >> 6);
  }

  int width_, above_ = 0, left_ = 0, stride_ = 0;
  std::vector<std::vector<Part>> parts_;
  /// The map, with ones around it; its blocked cells spread to the left.
  std::array<std::vector<std::uint64_t>, kSpreads> planes_;
};

/// What Masks::free() says of every edge at every cell.
class EdgePlanes {
 public:
  /// Bytes that they take; not to be made where that is more than kMost.
  static std::int64_t bytes(const Space::Impl& space, const Lattice& lattice) noexcept;
  static constexpr std::int64_t kMost = std::int64_t{1} << 28;

  /// O(rows of all masks x words of the map). Empty if stopped.
  static std::optional<EdgePlanes> make(const Space::Impl& space, const Lattice& lattice,
                                        Poller& poller);

  int words() const noexcept { return words_; }  ///< of a row
  /// Bit i: whether the edge is free from cell (64 word + i, y).
  std::uint64_t word(int edge, int word, int y) const noexcept {
    return bits_[(static_cast<std::size_t>(edge) * height_ + y) * words_ + word];
  }
  bool free(int edge, int x, int y) const noexcept {
    return (word(edge, x >> 6, y) >> (x & 63) & 1) != 0;
  }

 private:
  EdgePlanes(int height, int words, std::size_t edges)
      : height_(height), words_(words), bits_(edges * height * words) {}

  int height_, words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace lasius::vehicle
