// The cells that eight ants have entered: a VisitedPlane a lane; layouts as in avx2_vectors.h.
#pragma once

#include <immintrin.h>

#include <cstdint>
#include <cstring>

#include "kernels/walk/avx2_vectors.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

class LockstepPlanes {
 public:
  /// Planes with strips of so many words.
  explicit LockstepPlanes(std::int64_t rows) noexcept
      : strip_bytes_(static_cast<std::int64_t>(sizeof(std::uint64_t)) * rows) {}

  /// A lane without an ant may share a plane in which it marks nothing.
  void take(int i, const WalkSlot& slot) noexcept { origin_[place(i)] = slot.visited.origin; }
  std::uint64_t* word(int i) const noexcept { return word_[place(i)]; }

  /// Finds the words of the cells. They lie less than 2^29 bytes from the origin.
  LASIUS_AVX2 [[gnu::always_inline]] void find(__m256i at) noexcept {
    const __m256i strip_bytes = all(static_cast<std::uint32_t>(strip_bytes_));
    const __m256i x = _mm256_blend_epi16(at, _mm256_setzero_si256(), 0xaa);
    const __m256i y = _mm256_srli_epi32(at, 16);
    const __m256i offset = _mm256_add_epi32(
        _mm256_mullo_epi32(_mm256_srli_epi32(x, 5), strip_bytes), _mm256_slli_epi32(y, 3));
    // Bit 4 of x: the cell is in its word's upper half, and the lower half of the next strip's.
    const __m256i upper = _mm256_srai_epi32(_mm256_slli_epi32(x, 27), 31);
    const __m256i lower_offset = _mm256_add_epi32(offset, _mm256_and_si256(upper, strip_bytes));
    const Wide origin = load_wide(origin_);
    store_wide(word_, plus(origin, widen(offset)));
    store_wide(lower_, plus(origin, widen(lower_offset)));
  }

  /// Of each ant the words of its cell and of those above and below, shifted so that bits 0 to 2
  /// are those of the cells to the left, in the middle and to the right.
  struct Entered {
    __m256i above, beside, below;
  };
  LASIUS_AVX2 [[gnu::always_inline]] Entered around(__m256i at) const noexcept {
    const Columns even = columns(0), odd = columns(4);
    const Wide shift = widen(_mm256_add_epi32(_mm256_and_si256(at, all(31)), all(15)));
    return {shifted(even.above, odd.above, shift), shifted(even.own, odd.own, shift),
            shifted(even.below, odd.below, shift)};
  }

  /// Marks the cells as entered, whose words are found: the same bit in the lower half of one word
  /// and in the upper half of its neighbour to the left.
  LASIUS_AVX2 [[gnu::always_inline]] void mark(__m256i walks, __m256i at) noexcept {
    const __m256i in_half = _mm256_and_si256(_mm256_add_epi32(at, all(16)), all(31));
    alignas(32) PerAnt bit;
    store(bit, _mm256_and_si256(_mm256_sllv_epi32(all(1), in_half), walks));
    const std::int64_t to_upper = static_cast<std::int64_t>(sizeof(PackedCell)) - strip_bytes_;
    for (int i = 0; i < 8; ++i) {
      char* lower = lower_[place(i)];
      add(lower, bit[i]);
      add(lower + to_upper, bit[i]);
    }
  }

 private:
  /// Of four ants.
  struct Columns {
    __m256i above, own, below;
  };
  LASIUS_AVX2 [[gnu::always_inline]] Columns columns(int first) const noexcept {
    // Words of one strip follow each other: from the one above on, four an ant.
    const __m256i a = column(first), b = column(first + 1);
    const __m256i c = column(first + 2), d = column(first + 3);
    const __m256i even_ab = _mm256_unpacklo_epi64(a, b), even_cd = _mm256_unpacklo_epi64(c, d);
    const __m256i odd_ab = _mm256_unpackhi_epi64(a, b), odd_cd = _mm256_unpackhi_epi64(c, d);
    return {_mm256_permute2x128_si256(even_ab, even_cd, 0x20),
            _mm256_permute2x128_si256(odd_ab, odd_cd, 0x20),
            _mm256_permute2x128_si256(even_ab, even_cd, 0x31)};
  }
  LASIUS_AVX2 [[gnu::always_inline]] __m256i column(int at) const noexcept {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(word_[at] - 1));
  }
  LASIUS_AVX2 [[gnu::always_inline]] static __m256i shifted(__m256i even, __m256i odd,
                                                            Wide by) noexcept {
    return narrow({_mm256_srlv_epi64(even, by.even), _mm256_srlv_epi64(odd, by.odd)});
  }
  [[gnu::always_inline]] static void add(char* at, std::uint32_t bit) noexcept {
    std::uint32_t half;
    std::memcpy(&half, at, sizeof(half));
    half |= bit;
    std::memcpy(at, &half, sizeof(half));
  }

  alignas(32) PerAntWide<std::uint64_t*> origin_{};
  alignas(32) PerAntWide<std::uint64_t*> word_{};  ///< of the ants' cells
  alignas(32) PerAntWide<char*> lower_{};          ///< of their two, that with it in its lower half
  std::int64_t strip_bytes_;
};

}  // namespace
}  // namespace lasius::kernels
