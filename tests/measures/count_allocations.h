// Counts what a test program allocates, and lets an allocation fail. Include it in one source of
// the program only. Arrays that grow by realloc count, too, where no sanitizer has its own.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

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

// Not inlined: compilers that see through one of a pair warn of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (lasius::allocations++ == lasius::failing_allocation) throw std::bad_alloc();
  lasius::allocated_bytes += static_cast<std::int64_t>(size);
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
#if !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
extern "C" void* __libc_realloc(void* p, std::size_t size);  // NOLINT(bugprone-reserved-identifier)
extern "C" void* realloc(void* p, std::size_t size) noexcept {
  if (lasius::allocations++ == lasius::failing_allocation) return nullptr;
  lasius::allocated_bytes += static_cast<std::int64_t>(size);
  return __libc_realloc(p, size);
}
#endif
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
