// A block of memory that a scratch array lives in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/poller.h"
#include "lasius/export.h"

namespace lasius {

/// Memory of the C library; from kPaged bytes on, pages of its own straight from the system. They
/// are taken where they are first written, so that a new block costs nothing, growing copies
/// nothing, and what is given back is given back at once. The C library does so only until a large
/// block was freed: after that large ones, too, come from its heap, cleared or copied whole
/// (mallopt(3), M_MMAP_THRESHOLD).
class LASIUS_EXPORT MemoryBlock {
 public:
  static constexpr std::size_t kPaged = std::size_t{1} << 20;

  MemoryBlock() = default;
  /// All bytes 0. @throws std::bad_alloc, as `grow`.
  explicit MemoryBlock(std::size_t bytes);
  MemoryBlock(MemoryBlock&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  MemoryBlock& operator=(MemoryBlock&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~MemoryBlock();

  /// More bytes; what is in the block stays, new bytes hold anything. Unchanged where this throws.
  void grow(std::size_t bytes);

  /// All bytes 0 again; pages are given back. False when stopped, with some of it done.
  bool clear(Poller& poller);

  bool paged() const noexcept { return size_ >= kPaged; }
  std::size_t size() const noexcept { return size_; }  ///< in bytes
  void* data() const noexcept { return data_; }

  /// Bytes that take memory: of pages, those touched. Asks the system, page by page.
  std::int64_t held() const noexcept;

 private:
  void* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace lasius
