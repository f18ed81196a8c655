// The corners that a search has reached, and the one table that finds them.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/large_array.h"

namespace lasius::exact {

/// The cone a path may go on in after it turned at a corner: a quadrant given by two signs, and the
/// side of it that the turn is towards.
class Heading {
 public:
  Heading() = default;
  /// Signs of dx and dy; turned towards the vertical line (else towards the horizontal one)?
  constexpr Heading(int right, int down, bool towards_column) noexcept
      : bits_(static_cast<std::uint8_t>((right > 0 ? 1 : 0) | (down > 0 ? 2 : 0) |
                                        (towards_column ? 4 : 0))) {}
  constexpr int right() const noexcept { return (bits_ & 1) * 2 - 1; }
  constexpr int down() const noexcept { return (bits_ & 2) - 1; }
  constexpr bool towards_column() const noexcept { return (bits_ & 4) != 0; }

 private:
  std::uint8_t bits_ = 0;
};

/// A corner of a blocked cell, or the start (index 0), in half-cell coordinates.
struct Corner {
  int x = 0, y = 0;
  double length = 0;   ///< of the shortest known path from the start
  double to_goal = 0;  ///< straight distance
  std::uint32_t parent = 0;
  Heading heading = {};
  bool expanded = false;     ///< its cone was scanned at this length
  bool weighed : 1 = false;  ///< the weighted search has expanded it
  bool tied : 1 = false;     ///< another way is as short
  std::uint8_t scans = 0;    ///< how often its cone was scanned and cut off, at this length
};
static_assert(sizeof(Corner) == 32);

/// All corners reached, by index and by place. Place and index share a word of an open table with
/// linear probing that is at most half full.
///
/// The leading bits of a hash choose a row of eight slots, those after them a segment of the table.
/// A full segment is split by one more bit (extendible hashing; Fagin et al. 1979), so that growing
/// never takes longer than one segment.
class CornerTable {
 public:
  static constexpr std::uint32_t kStart = 0;

  /// Forgets all; `width` of the map in cells.
  void reset(int width, const Corner& start) {
    tiles_ = (static_cast<std::uint32_t>(width) >> 3) + 1;
    corners_.clear();
    corners_.push_back(start);
    in_use_ = 0;
    depth_ = 0;
    set_slots(kSmallest);
    directory_.assign(1, take_segment(0));
    only_ = directory_[0].words;
  }

  Corner& operator[](std::uint32_t i) noexcept { return corners_[i]; }
  const Corner& operator[](std::uint32_t i) const noexcept { return corners_[i]; }
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(corners_.size()); }

  /// Where lattice point (x, y) is in the table, or would be.
  std::uint64_t* slot(int x, int y) const noexcept { return slot_of(place_of(x, y)); }
  /// The index at a slot, kStart if it is empty.
  static std::uint32_t at(const std::uint64_t* slot) noexcept {
    return static_cast<std::uint32_t>(*slot);
  }
  /// Makes a corner at lattice point (x, y) for the empty slot found for it; its caller fills in
  /// the rest. Invalidates slots.
  std::uint32_t add(std::uint64_t* slot, int x, int y) {
    const std::uint32_t index = size();
    Corner& corner = corners_.push_back({});
    corner.x = 2 * x;
    corner.y = 2 * y;
    const std::uint64_t place = place_of(x, y);
    *slot = place << 32 | index;
    if (depth_ == 0) {
      if (2 * corners_.size() > slots_) grow(*directory_[0].owner);
    } else {
      Segment& segment = *directory_[direction(place)].owner;
      if (2 * ++segment.used > kSegment) grow(segment);
    }
    return index;
  }

  std::int64_t bytes() const noexcept {
    std::int64_t bytes = corners_.bytes() + held_bytes(segments_, directory_, scratch_);
    for (const auto& segment : segments_) {
      bytes += static_cast<std::int64_t>(sizeof(Segment)) + held_bytes(segment->words);
    }
    return bytes;
  }

 private:
  static constexpr std::size_t kSmallest = 512;  // slots of the first segment at first
  static constexpr int kRowBits = 12;
  static constexpr std::size_t kSegment = std::size_t{8} << kRowBits;
  static constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio

  using Words = std::vector<std::uint64_t>;  // place << 32 | index; 0: empty
  struct Segment {
    Words words;
    std::size_t used = 0;
    int depth = 0;  // bits that all of it have in common
  };
  struct Entry {
    std::uint64_t* words = nullptr;
    Segment* owner = nullptr;
  };

  // Tile by tile, 8 x 8 lattice points each: below 2^31 for every map.
  std::uint64_t place_of(int x, int y) const noexcept {
    const auto tile =
        static_cast<std::uint64_t>(y >> 3) * tiles_ + static_cast<std::uint64_t>(x >> 3);
    return tile << 6 | static_cast<std::uint64_t>((y & 7) << 3 | (x & 7));
  }
  static std::uint64_t hash(std::uint64_t place) noexcept { return (place >> 6) * kMultiplier; }
  std::size_t direction(std::uint64_t place) const noexcept {
    return hash(place) << kRowBits >> 1 >> (63 - depth_);
  }
  // The points of a tile have slots in a row, eight a cache line: neighbours are looked up
  // together.
  std::uint64_t* slot_of(std::uint64_t place) const noexcept {
    // Most searches have one segment: no load has to wait for the directory's.
    std::uint64_t* const words = depth_ == 0 ? only_ : directory_[direction(place)].words;
    std::size_t at = ((hash(place) >> row_shift_ << 3) + (place & 63)) & (slots_ - 1);
    while (words[at] != 0 && words[at] >> 32 != place) at = (at + 1) & (slots_ - 1);
    return words + at;
  }

  void set_slots(std::size_t slots) noexcept {
    slots_ = slots;
    row_shift_ = 64 + 3 - std::countr_zero(slots);
  }

  void empty(Words& words) {
    if (words.size() < slots_) {
      words.assign(slots_, 0);
    } else {
      std::fill_n(words.begin(), slots_, 0);
    }
  }

  // An empty one.
  Entry take_segment(int depth) {
    if (in_use_ == segments_.size()) {
      segments_.push_back(std::make_unique<Segment>());
    }
    Segment& segment = *segments_[in_use_++];
    segment.used = 0;
    segment.depth = depth;
    empty(segment.words);
    return {segment.words.data(), &segment};
  }

  void grow(Segment& segment) {
    if (slots_ < kSegment) {
      enlarge(segment);
    } else {
      split(segment);
    }
  }
  // The only segment: to twice its slots, or four times as many in memory that an earlier search
  // took. Corners in the order in which they came: what comes together lies together.
  void enlarge(Segment& segment) {
    set_slots((segment.words.size() < 4 * slots_ ? 2 : 4) * slots_);
    empty(segment.words);
    directory_[0].words = only_ = segment.words.data();
    for (std::uint32_t i = 1; i < size(); ++i) {
      const std::uint64_t place = place_of(corners_[i].x >> 1, corners_[i].y >> 1);
      *slot_of(place) = place << 32 | i;
    }
  }
  void split(Segment& segment) {
    std::swap(segment.words, scratch_);
    direct_half(segment);
    empty(segment.words);
    for (Entry& entry : directory_) {
      if (entry.owner == &segment) entry.words = segment.words.data();
    }
    segment.used = 0;
    for (std::size_t i = 0; i < kSegment; ++i) {
      const std::uint64_t word = scratch_[i];
      if (word == 0) continue;
      *slot_of(word >> 32) = word;
      ++directory_[direction(word >> 32)].owner->used;
    }
  }
  // Directs one half of what leads to a segment, the one with the next bit set, to a new one.
  void direct_half(Segment& segment) {
    if (segment.depth == depth_) {
      ++depth_;
      directory_.resize(2 * directory_.size());
      for (std::size_t i = directory_.size(); i-- > 0;) directory_[i] = directory_[i / 2];
    }
    const Entry half = take_segment(++segment.depth);
    const std::size_t bit = std::size_t{1} << (depth_ - segment.depth);
    for (std::size_t i = 0; i < directory_.size(); ++i) {
      if (directory_[i].owner == &segment && (i & bit) != 0) directory_[i] = half;
    }
  }

  GrowingList<Corner> corners_;
  std::vector<std::unique_ptr<Segment>> segments_;  // those in use first
  std::size_t in_use_ = 0;
  std::vector<Entry> directory_;   // by the leading bits of the hash
  std::uint64_t* only_ = nullptr;  // words of the first segment while it is the only one
  int depth_ = 0;                  // how many of them
  int row_shift_ = 0;
  std::size_t slots_ = kSmallest;  // of each segment
  Words scratch_;
  std::uint64_t tiles_ = 1;  // in a row of tiles
};

}  // namespace lasius::exact
