#include "core/base/memory_block.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <new>

namespace lasius {
namespace {

void* mapped(std::size_t bytes) {
  void* const p = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (p == MAP_FAILED) throw std::bad_alloc();
  return p;
}

}  // namespace

MemoryBlock::MemoryBlock(std::size_t bytes) {
  if (bytes >= kPaged) {
    data_ = mapped(bytes);
    madvise(data_, bytes, MADV_NOHUGEPAGE);  // little of it may be used
  } else {
    data_ = std::calloc(std::max<std::size_t>(bytes, 1), 1);
    if (data_ == nullptr) throw std::bad_alloc();
  }
  size_ = bytes;
}

MemoryBlock::~MemoryBlock() {
  if (paged())
    munmap(data_, size_);
  else
    std::free(data_);
}

void MemoryBlock::grow(std::size_t bytes) {
  if (bytes <= size_) return;
  if (bytes < kPaged) {
    void* const larger = std::realloc(data_, bytes);
    if (larger == nullptr) throw std::bad_alloc();
    data_ = larger;
  } else if (paged()) {
    void* const larger = mremap(data_, size_, bytes, MREMAP_MAYMOVE);
    if (larger == MAP_FAILED) throw std::bad_alloc();
    data_ = larger;
  } else {
    void* const pages = mapped(bytes);
    if (size_ > 0) std::memcpy(pages, data_, size_);
    std::free(data_);
    data_ = pages;
  }
  size_ = bytes;
}

bool MemoryBlock::clear(Poller& poller) {
  constexpr std::size_t kPiece = Poller::kWords * sizeof(std::uint64_t);
  for (std::size_t from = 0; from < size_; from += kPiece) {
    const std::size_t part = std::min(kPiece, size_ - from);
    char* const at = static_cast<char*>(data_) + from;
    // Pages that are locked cannot be given back.
    if (!paged() || madvise(at, part, MADV_DONTNEED) != 0) std::memset(at, 0, part);
    if (poller.stop_after(static_cast<std::int64_t>(part / sizeof(std::uint64_t)))) return false;
  }
  return true;
}

std::int64_t MemoryBlock::held() const noexcept {
  if (!paged()) return static_cast<std::int64_t>(size_);
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::array<unsigned char, 4096> in_memory;
  std::int64_t bytes = 0;
  for (std::size_t from = 0; from < size_; from += in_memory.size() * page) {
    const std::size_t part = std::min(in_memory.size() * page, size_ - from);
    if (mincore(static_cast<char*>(data_) + from, part, in_memory.data()) != 0)
      return static_cast<std::int64_t>(size_);
    const auto end = in_memory.begin() + static_cast<std::ptrdiff_t>((part + page - 1) / page);
    for (auto p = in_memory.begin(); p != end; ++p) bytes += (*p & 1) != 0 ? page : 0;
  }
  return bytes;
}

}  // namespace lasius
