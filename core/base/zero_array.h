// Large arrays of which little may be used.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace lasius {

/// Memory that reads as zero and is mapped where it is first written.
template <class T>
class ZeroArray {
 public:
  ZeroArray() = default;
  explicit ZeroArray(std::int64_t size)
      : data_(static_cast<T*>(std::calloc(static_cast<std::size_t>(size), sizeof(T)))) {
    if (data_ == nullptr) throw std::bad_alloc();
  }
  /// Is there any? Not before a size was given.
  explicit operator bool() const noexcept { return data_ != nullptr; }
  T& operator[](std::int64_t i) const noexcept { return data_.get()[i]; }
  T* at(std::int64_t i) const noexcept { return data_.get() + i; }

 private:
  struct Free {
    void operator()(T* p) const noexcept { std::free(p); }
  };
  std::unique_ptr<T[], Free> data_;
};

}  // namespace lasius
