// What emscripten 3.1.6 has of pages: mmap alone. Its madvise does nothing and says that it has,
// its mremap fails. These keep to the manual, as far as core/base/memory_block.cpp asks.

#include <sys/mman.h>

#include <algorithm>
#include <cstring>

extern "C" {

int madvise(void* pages, size_t bytes, int advice) {
  if (advice == MADV_DONTNEED) std::memset(pages, 0, bytes);
  return 0;
}

void* mremap(void* pages, size_t bytes, size_t wanted, int, ...) {
  void* const moved =
      mmap(nullptr, wanted, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (moved == MAP_FAILED) return moved;
  std::memcpy(moved, pages, std::min(bytes, wanted));
  munmap(pages, bytes);
  return moved;
}

}  // extern "C"
