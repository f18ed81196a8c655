// Sees which memory a test program uses: with this, its blocks of 1 KiB and more have pages of
// their own, and PagesUsed counts those that are read or written. Include it in one source of the
// program only; for one thread, on systems with POSIX signals.
#pragma once

#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace lasius {

struct PagedBlock {
  char* first = nullptr;
  std::size_t bytes = 0;
};
inline std::array<PagedBlock, 1024> paged_blocks;
inline constexpr std::size_t kPaged = 1 << 10;  ///< bytes from which on a block has its own pages

/// Counts from its making to its end. Not two at a time.
class PagesUsed {
 public:
  PagesUsed() {
    used_ = 0;
    struct sigaction action {};
    action.sa_sigaction = &PagesUsed::open;
    action.sa_flags = SA_SIGINFO;
    sigaction(SIGSEGV, &action, &before_);
    for (const PagedBlock& b : paged_blocks) {
      if (b.first != nullptr) mprotect(b.first, b.bytes, PROT_NONE);
    }
  }
  ~PagesUsed() {
    for (const PagedBlock& b : paged_blocks) {
      if (b.first != nullptr) mprotect(b.first, b.bytes, PROT_READ | PROT_WRITE);
    }
    sigaction(SIGSEGV, &before_, nullptr);
  }
  PagesUsed(const PagesUsed&) = delete;
  PagesUsed& operator=(const PagesUsed&) = delete;

  std::int64_t count() const noexcept { return used_; }

 private:
  /// The page is opened and counted; an access to any other memory is the fault that it is.
  static void open(int signal, siginfo_t* info, void*) noexcept {
    const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    char* const at = static_cast<char*>(info->si_addr);
    for (const PagedBlock& b : paged_blocks) {
      if (b.first == nullptr || at < b.first || at >= b.first + b.bytes) continue;
      char* const page = at - static_cast<std::size_t>(at - b.first) % size;
      if (mprotect(page, size, PROT_READ | PROT_WRITE) != 0) break;
      used_ = used_ + 1;
      return;
    }
    ::signal(signal, SIG_DFL);
  }

  static inline volatile std::int64_t used_ = 0;
  struct sigaction before_ {};
};

}  // namespace lasius

[[gnu::noinline]] void* operator new(std::size_t size) {
  if (size >= lasius::kPaged) {
    for (lasius::PagedBlock& b : lasius::paged_blocks) {
      if (b.first != nullptr) continue;
      void* p = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      if (p == MAP_FAILED) throw std::bad_alloc();
      b = {static_cast<char*>(p), size};
      return p;
    }
  }
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  for (lasius::PagedBlock& b : lasius::paged_blocks) {
    if (p == nullptr || b.first != p) continue;
    munmap(p, b.bytes);
    b = {};
    return;
  }
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { operator delete(p); }
