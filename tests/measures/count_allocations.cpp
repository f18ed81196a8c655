#include "tests/measures/count_allocations.h"

#include <cstdlib>
#include <new>

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
