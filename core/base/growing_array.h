// Large arrays that grow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/base/held_bytes.h"
#include "core/base/memory_block.h"

namespace lasius {

/// Memory that keeps what is in it as it grows, and is not cleared. A large one grows in next to no
/// time, and is mapped where it is first written.
template <class T>
class GrowingArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Room for `size` values at least. Throws std::bad_alloc, and is then as before.
  void grow(std::size_t size) { block_.grow(size * kSizeOf<T>); }
  std::size_t size() const noexcept { return block_.size() / kSizeOf<T>; }
  T* data() noexcept { return static_cast<T*>(block_.data()); }
  const T* data() const noexcept { return static_cast<const T*>(block_.data()); }

  std::int64_t bytes() const noexcept { return block_.held(); }  ///< memory held

 private:
  MemoryBlock block_;
};

}  // namespace lasius
