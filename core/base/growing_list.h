// A list of many plain values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/base/growing_array.h"

namespace lasius {

/// As a std::vector, which copies all that it holds to grow, though: a pause of 50 ms for 100 MB.
template <class T>
class GrowingList {
 public:
  T& push_back(T value) {
    if (size_ == values_.size()) values_.grow(std::max(kSmallest, 2 * size_));
    T& place = (*this)[size_++];
    place = value;
    return place;
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

}  // namespace lasius
