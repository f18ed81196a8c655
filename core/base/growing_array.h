// Large arrays that grow.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace lasius {

/// Memory that keeps what is in it as it grows, and is not cleared. A large block is mapped anew,
/// so that growing it takes next to no time, and mapped where it is first written.
template <class T>
class GrowingArray {
 public:
  /// Room for `size` values at least. Throws std::bad_alloc, and is then as before.
  void grow(std::size_t size) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (size <= size_) return;
    void* const larger = std::realloc(data_.get(), size * sizeof(T));
    if (larger == nullptr) throw std::bad_alloc();
    static_cast<void>(data_.release());
    data_.reset(static_cast<T*>(larger));
    size_ = size;
  }
  std::size_t size() const noexcept { return size_; }
  T* data() const noexcept { return data_.get(); }

 private:
  struct Free {
    void operator()(T* p) const noexcept { std::free(p); }
  };
  std::unique_ptr<T[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace lasius
