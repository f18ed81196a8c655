// The frontier of a best-first search: items in the order of a key, in buckets.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"

namespace lasius {

/// A queue of indices in buckets of equal width, last in, first out within a bucket. Keys beyond
/// the last bucket wait in an overflow list and are dealt out when the buckets are empty.
///
/// The floor of the bucket in hand is a lower bound of all keys in the queue: a key lies in the
/// bucket floor((key - origin) / width), both operations rounded, so that the bound holds up to a
/// relative 2^-51, which the search allows for. A smaller key than those in hand moves the queue
/// back; one below the origin waits in the first bucket and lowers the floor for good.
class BucketQueue {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Empties the queue; keys start at `origin`.
  void reset(double origin, double width) noexcept {
    origin_ = origin;
    width_ = width;
    per_width_ = 1 / width;
    current_ = 0;
    least_ = kInfinity;
    items_.clear();
    spare_ = kNone;
    overflow_ = kNone;
    full_.fill(0);
  }

  double width() const noexcept { return width_; }

  void push(std::uint32_t index, double key) {
    std::uint32_t item = spare_;
    if (item != kNone) {
      spare_ = items_[item].next;
    } else {
      item = static_cast<std::uint32_t>(items_.size());
      items_.push_back({});
    }
    items_[item] = {key, index, kNone};
    place(item);
  }

  /// Moves to the first bucket that holds something; false if nothing does. Dealing items out is
  /// work that the poller is told of: on long ways most wait and are dealt out many times.
  bool advance(Poller& poller) {
    for (;;) {
      int word = current_ >> 6;
      std::uint64_t bits = full_[word] & (~std::uint64_t{0} << (current_ & 63));
      while (bits == 0 && ++word < kWords) bits = full_[word];
      if (bits != 0) {
        current_ = word * 64 + std::countr_zero(bits);
        return true;
      }
      if (overflow_ == kNone) return false;
      poller.stop_after(deal_out());
    }
  }
  /// After advance(): no key is below this.
  double floor() const noexcept { return std::min(origin_ + current_ * width_, least_); }
  /// Takes an item of the bucket that advance() found.
  std::uint32_t pop() noexcept {
    const std::uint32_t item = heads_[current_];
    Item& taken = items_[item];
    heads_[current_] = taken.next;
    if (taken.next == kNone) full_[current_ >> 6] &= ~(std::uint64_t{1} << (current_ & 63));
    taken.next = spare_;
    spare_ = item;
    return taken.index;
  }

  /// What pop() takes next of the bucket in hand, unless something is pushed before; or kNone.
  std::uint32_t next() const noexcept {
    const std::uint32_t item = heads_[current_];
    return item != kNone ? items_[item].index : kNone;
  }

  std::int64_t bytes() const noexcept { return items_.bytes(); }  ///< held beside the queue itself

 private:
  static constexpr int kWords = 128;
  static constexpr int kBuckets = kWords * 64;

  struct Item {
    double key;
    std::uint32_t index;
    std::uint32_t next;
  };

  void place(std::uint32_t item) noexcept {
    const double at = (items_[item].key - origin_) * per_width_;
    if (!(at < kBuckets)) {
      items_[item].next = overflow_;
      overflow_ = item;
      return;
    }
    const int bucket = at > 0 ? static_cast<int>(at) : 0;
    if (at < 0) least_ = std::min(least_, items_[item].key);
    current_ = std::min(current_, bucket);
    const std::uint64_t bit = std::uint64_t{1} << (bucket & 63);
    std::uint64_t& word = full_[bucket >> 6];
    items_[item].next = (word & bit) != 0 ? heads_[bucket] : kNone;
    heads_[bucket] = item;
    word |= bit;
  }

  // All buckets are empty: starts them anew at the least key that waits; returns the items dealt.
  std::int64_t deal_out() noexcept {
    std::uint32_t waiting = overflow_;
    overflow_ = kNone;
    double least = items_[waiting].key;
    for (std::uint32_t i = waiting; i != kNone; i = items_[i].next) {
      least = std::min(least, items_[i].key);
    }
    origin_ = least;
    current_ = 0;
    std::int64_t dealt = 0;
    while (waiting != kNone) {
      ++dealt;
      const std::uint32_t next = items_[waiting].next;
      place(waiting);
      waiting = next;
    }
    return dealt;
  }

  double origin_ = 0;
  double width_ = 1;
  double per_width_ = 1;
  int current_ = 0;
  double least_ = 0;  // of the keys below the first bucket, which holds them
  std::uint32_t spare_ = kNone;
  std::uint32_t overflow_ = kNone;
  GrowingList<Item> items_;
  std::array<std::uint64_t, kWords> full_{};  // a bit for each bucket that holds something
  std::array<std::uint32_t, kBuckets> heads_{};
};

}  // namespace lasius
