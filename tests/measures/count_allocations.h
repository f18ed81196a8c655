// Counts what a test program allocates, and lets an allocation fail; with count_allocations.cpp
// among the program's sources. Growth by realloc counts, too, where no sanitizer has its own.
#pragma once

#include <atomic>
#include <cstdint>

namespace lasius {
inline std::atomic<std::int64_t> allocations{0};
inline std::atomic<std::int64_t> allocated_bytes{0};
/// Of these, the number of the one that fails; none by default.
inline std::atomic<std::int64_t> failing_allocation{-1};

/// Of a call that was made once before: what it keeps is there already.
template <class Call>
std::int64_t allocations_of_the_second(const Call& call) {
  call();
  const std::int64_t before = allocations;
  call();
  return allocations - before;
}
}  // namespace lasius
