// Large arrays: one that grows, a list of many plain values, and one of which little may be used.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/base/held_bytes.h"
#include "core/base/memory_block.h"
#include "core/base/poller.h"

namespace lasius {

/// Memory that keeps what is in it as it grows, and is not cleared. A large one grows in next to no
/// time, and is mapped where it is first written.
template <class T>
class GrowingArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Room for `size` values at least. @throws std::bad_alloc, the array unchanged
  void grow(std::size_t size) { block_.grow(size * kSizeOf<T>); }
  std::size_t size() const noexcept { return block_.size() / kSizeOf<T>; }
  T* data() noexcept { return static_cast<T*>(block_.data()); }
  const T* data() const noexcept { return static_cast<const T*>(block_.data()); }

  std::int64_t bytes() const noexcept { return block_.held(); }  ///< memory held

 private:
  MemoryBlock block_;
};

/// A list that grows without copying: a std::vector would pause for 50 ms at 100 MB.
template <class T>
class GrowingList {
 public:
  T& push_back(T value) {
    if (size_ == values_.size()) values_.grow(std::max(kSmallest, 2 * size_));
    T& place = (*this)[size_++];
    place = value;
    return place;
  }
  void append(std::size_t count, T value) {
    const std::size_t size = size_ + count;
    if (size > values_.size()) values_.grow(std::max({kSmallest, 2 * size_, size}));
    std::fill_n(values_.data() + size_, count, value);
    size_ = size;
  }
  void clear() noexcept { size_ = 0; }

  std::size_t size() const noexcept { return size_; }
  T& operator[](std::size_t i) noexcept { return values_.data()[i]; }
  const T& operator[](std::size_t i) const noexcept { return values_.data()[i]; }
  std::int64_t bytes() const noexcept { return values_.bytes(); }  ///< memory held

 private:
  static constexpr std::size_t kSmallest = 64;

  GrowingArray<T> values_;
  std::size_t size_ = 0;
};

/// Memory that reads as zero and is mapped where it is first written.
template <class T>
class ZeroArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  ZeroArray() = default;
  /// @throws std::bad_alloc
  explicit ZeroArray(std::int64_t size) : block_(static_cast<std::size_t>(size) * kSizeOf<T>) {}

  /// At least `size` values, all zero. Those of a large array are given back, those of a small one
  /// set to zero if it is `marked`. False when stopped: then values may be left, and it must be
  /// renewed again before use, `marked` unchanged.
  bool renew(std::int64_t size, bool marked, Poller& poller) {
    if ((marked || block_.paged()) && !block_.clear(poller)) return false;
    if (size > this->size()) *this = ZeroArray(size);
    return true;
  }
  /// As MemoryBlock::clear.
  bool clear(Poller& poller) { return block_.clear(poller); }

  std::int64_t size() const noexcept {
    return static_cast<std::int64_t>(block_.size() / kSizeOf<T>);
  }
  T& operator[](std::int64_t i) noexcept { return *at(i); }
  const T& operator[](std::int64_t i) const noexcept { return *at(i); }
  T* at(std::int64_t i) noexcept { return static_cast<T*>(block_.data()) + i; }
  const T* at(std::int64_t i) const noexcept { return static_cast<const T*>(block_.data()) + i; }

  std::int64_t bytes() const noexcept { return block_.held(); }  ///< memory held

 private:
  MemoryBlock block_;
};

}  // namespace lasius
