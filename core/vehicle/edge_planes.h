// From which cells each motion of a lattice is free, as bits of the whole map.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/poller.h"
#include "core/vehicle/lattice.h"
#include "core/vehicle/sweep.h"

namespace lasius::vehicle {

/// What Masks::free() says of every edge at every cell, at once: a row of a mask is runs of
/// columns, and a map whose blocked cells are spread over 2^k columns answers a run by two of its
/// rows.
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
