// How much memory vectors hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lasius {

/// sizeof, to which a pointer is a value like others.
template <class T>
inline constexpr std::size_t kSizeOf = sizeof(T);  // NOLINT(bugprone-sizeof-expression)

/// Of their elements; what these hold themselves is not counted.
template <class... T>
std::int64_t held_bytes(const std::vector<T>&... vectors) noexcept {
  return (std::int64_t{0} + ... + static_cast<std::int64_t>(vectors.capacity() * kSizeOf<T>));
}

/// Of the elements, and what each of them holds by its bytes().
template <class T>
std::int64_t held_bytes_of_all(const std::vector<T>& vector) noexcept {
  std::int64_t bytes = held_bytes(vector);
  for (const T& element : vector) bytes += element.bytes();
  return bytes;
}

}  // namespace lasius
