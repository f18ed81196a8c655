// The cells that eight ants have entered: VisitedPlane, one a lane; layouts as in
// abreast_avx512_lanes.h. The including file defines LASIUS_TARGET.
#pragma once

#include <immintrin.h>

#include <array>
#include <cstdint>

#include "kernels/walk/abreast_avx512_lanes.h"
#include "kernels/walk/walk.h"

namespace lasius::kernels {
namespace {

class AbreastPlanes {
 public:
  /// Planes with strips of so many words.
  explicit AbreastPlanes(std::int64_t rows) noexcept : rows_(rows) {}

  void take(int i, const WalkSlot& slot) noexcept {
    origin_[i] = slot.visited.origin;
    word_[i] = slot.word;
  }
  /// A lane without an ant has a word of its own.
  void rest(int i) noexcept { origin_[i] = word_[i] = spare_.data() + 1; }
  std::uint64_t* word(int i) const noexcept { return word_[i]; }

  /// Finds the words of the cells.
  LASIUS_TARGET [[gnu::always_inline]] void find(__mmask8 walks, __m512i x, __m512i y) noexcept {
    const __m512i strip = _mm512_mul_epu32(_mm512_srli_epi64(x, 5), all(rows_ * 8));
    store(word_, _mm512_mask_add_epi64(load(word_), walks, load(origin_),
                                       _mm512_add_epi64(strip, _mm512_slli_epi64(y, 3))));
  }

  /// Words of `visited`, one an ant: of the ants' cells and of those above and below.
  struct Words {
    __m512i above, own, below;
  };
  LASIUS_TARGET [[gnu::always_inline]] Words words() const noexcept {
    // Words of one strip follow each other: from the one above on, four of ants i and i + 4.
    const __m512i a = two_columns(0), b = two_columns(1), c = two_columns(2), d = two_columns(3);
    const __m512i even_ab = _mm512_unpacklo_epi64(a, b), even_cd = _mm512_unpacklo_epi64(c, d);
    const __m512i odd_ab = _mm512_unpackhi_epi64(a, b), odd_cd = _mm512_unpackhi_epi64(c, d);
    const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    const __m512i second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    return {_mm512_permutex2var_epi64(even_ab, first, even_cd),
            _mm512_permutex2var_epi64(odd_ab, first, odd_cd),
            _mm512_permutex2var_epi64(even_ab, second, even_cd)};
  }

  /// Bit k: move k, of four or eight, leads to a cell that the ant has entered. One an ant; `own`
  /// is words().
  template <int kMoves>
  LASIUS_TARGET [[gnu::always_inline]] __m512i closed(__m512i at,
                                                      const Words& words) const noexcept {
    const __m512i shift = _mm512_add_epi64(_mm512_and_epi64(at, all(31)), all(15));
    const __m512i up = _mm512_srlv_epi64(words.above, shift);
    const __m512i here = _mm512_srlv_epi64(words.own, shift);
    const __m512i down = _mm512_srlv_epi64(words.below, shift);
    if constexpr (kMoves == 4) {
      return _mm512_or_epi64(_mm512_or_epi64(_mm512_and_epi64(_mm512_srli_epi64(up, 1), all(1)),
                                             _mm512_and_epi64(_mm512_slli_epi64(here, 1), all(2))),
                             _mm512_or_epi64(_mm512_and_epi64(here, all(4)),
                                             _mm512_and_epi64(_mm512_slli_epi64(down, 2), all(8))));
    }
    return _mm512_or_epi64(
        _mm512_or_epi64(_mm512_and_epi64(up, all(7)),
                        _mm512_and_epi64(_mm512_slli_epi64(here, 3), all(8))),
        _mm512_or_epi64(_mm512_and_epi64(_mm512_slli_epi64(here, 2), all(16)),
                        _mm512_and_epi64(_mm512_slli_epi64(down, 5), all(0xe0))));
  }

  /// Marks the cells as entered.
  LASIUS_TARGET [[gnu::always_inline]] void mark(__mmask8 walks, __m512i at,
                                                 const Words& words) noexcept {
    const __m512i bit = _mm512_add_epi64(_mm512_and_epi64(at, all(31)), all(16));
    alignas(64) PerAnt<std::uint64_t> here, beside;
    store(here, _mm512_or_epi64(words.own, _mm512_sllv_epi64(all(1), bit)));
    store(beside, _mm512_sllv_epi64(all(1), _mm512_xor_epi64(bit, all(32))));
    const __m512i word = load(word_), strip = all(rows_ * 8);
    const __mmask8 right = _mm512_test_epi64_mask(bit, all(32));
    const __m512i strip_beside =
        _mm512_mask_mov_epi64(_mm512_sub_epi64(word, strip), right, _mm512_add_epi64(word, strip));
    alignas(64) PerAnt<std::uint64_t*> word_beside;
    store(word_beside, _mm512_mask_mov_epi64(word, walks, strip_beside));
    for (int i = 0; i < 8; ++i) *word_[i] = here[i];
    for (int i = 0; i < 8; ++i) *word_beside[i] |= beside[i];
  }

 private:
  LASIUS_TARGET [[gnu::always_inline]] __m512i two_columns(int i) const noexcept {
    return _mm512_inserti64x4(
        _mm512_castsi256_si512(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(word_[i] - 1))),
        _mm256_loadu_si256(reinterpret_cast<const __m256i*>(word_[i + 4] - 1)), 1);
  }

  alignas(64) PerAnt<std::uint64_t*> origin_{};
  alignas(64) PerAnt<std::uint64_t*> word_{};  ///< of the ants' cells
  std::array<std::uint64_t, 4> spare_{};
  std::int64_t rows_;
};

}  // namespace
}  // namespace lasius::kernels
