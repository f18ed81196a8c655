// Blocks of tiles: how components of four of them are joined, told by their outlines alone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/held_bytes.h"

namespace lasius {

/// A component's place among those of its tile or block.
using Piece = std::uint16_t;

/// The contacts of a block with its neighbour beyond one side, left to right or top to bottom: the
/// pieces that make them. Both neighbours list the same contacts, in the same order. A piece is
/// followed by the number of contacts that it makes beyond the first in succession, if any.
class Side {
 public:
  static constexpr Piece kNone = 0x7fff;  ///< no piece; all that are listed are smaller

  void clear() noexcept { codes_.clear(); }
  void add(Piece piece, int contacts);

  class Reader {
   public:
    explicit Reader(const Side& side) noexcept
        : at_(side.codes_.data()), end_(at_ + side.codes_.size()) {
      load();
    }
    bool done() const noexcept { return left_ == 0; }
    Piece piece() const noexcept { return piece_; }
    int contacts() const noexcept { return left_; }  ///< that this piece makes yet
    void skip(int contacts) noexcept {
      left_ -= contacts;
      if (left_ == 0) load();
    }

   private:
    void load() noexcept {
      if (at_ == end_) return;
      piece_ = *at_++;
      left_ = at_ != end_ && *at_ > kNone ? 1 + (*at_++ & kNone) : 1;
    }
    const std::uint16_t* at_;
    const std::uint16_t* end_;
    Piece piece_ = kNone;
    int left_ = 0;
  };

  std::int64_t bytes() const noexcept { return held_bytes(codes_); }
  friend bool operator==(const Side&, const Side&) = default;

 private:
  std::vector<std::uint16_t> codes_;  // pieces; with the highest bit, numbers of contacts
};

/// Of a tile, the component that seems largest: most cells are of it.
struct MainComponent {
  Piece piece = Side::kNone;              ///< none if it does not touch the border
  std::array<std::uint64_t, 4> beside{};  ///< a bit for 16 x 16 cells where others have some, too
  friend bool operator==(const MainComponent&, const MainComponent&) = default;

  /// Do all free cells around (x, y) of the tile belong to it?
  bool is_alone(int x, int y) const noexcept { return (beside[y >> 6] >> bit(x, y) & 1) == 0; }
  /// A run of a row is of another one.
  void add_other(int first, int last, int y) noexcept {
    beside[y >> 6] |= (std::uint64_t{2} << bit(last, y)) - (std::uint64_t{1} << bit(first, y));
  }

 private:
  static int bit(int x, int y) noexcept { return (y >> 4 & 3) * 16 + (x >> 4); }
};

/// What the rest of the map sees of a tile or block.
struct Outline {
  enum Direction { north, east, south, west };
  enum Corner { north_west, north_east, south_west, south_east };  ///< or part of a block

  std::array<Side, 4> sides;
  /// With 8 neighbours, the pieces of the corner cells, for steps across a corner; kNone where
  /// blocked, and where the corner lies on the map's edge.
  std::array<Piece, 4> corners{Side::kNone, Side::kNone, Side::kNone, Side::kNone};
  std::uint32_t open = 0;  ///< pieces that reach beyond are 0 to open - 1

  void clear() noexcept;
  friend bool operator==(const Outline&, const Outline&) = default;
};

/// Joins four parts to a block. Reused from block to block.
class BlockJoin {
 public:
  /// In the order of Outline::Corner; those outside the map have empty outlines.
  using Parts = std::array<const Outline*, 4>;
  void join(const Parts& parts, bool eight);

  /// The block's pieces are numbered along its sides, those that reach none of them last.
  const Outline& outline() const noexcept { return outline_; }
  std::uint32_t pieces() const noexcept { return pieces_; }
  std::uint32_t closed() const noexcept { return pieces_ - outline_.open; }
  /// The pieces of the block that a part's open pieces belong to.
  std::span<const std::uint32_t> up(int part) const noexcept {
    return {up_.data() + first_[part], up_.data() + first_[part + 1]};
  }

 private:
  static constexpr std::uint32_t kUnknown = 0xffffffff;

  std::uint32_t find(std::uint32_t i) noexcept;
  void unite(int part_a, Piece a, int part_b, Piece b) noexcept;
  void unite_sides(const Parts& parts, int a, int side_a, int b, int side_b) noexcept;
  Piece number(int part, Piece piece) noexcept;
  void add_side(const Parts& parts, int side, int a, int b, bool eight);

  std::array<std::uint32_t, 5> first_{};  // of each part's pieces in the next two
  std::vector<std::uint32_t> parents_;    // smaller or equal
  std::vector<std::uint32_t> up_;
  std::uint32_t pieces_ = 0;  // of the block, so far
  Outline outline_;
};

}  // namespace lasius
