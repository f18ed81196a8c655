#include "kernels/base/mask.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace lasius::kernels {
namespace {

bool meets_scalar(const std::uint64_t* left, const std::uint64_t* right, const std::uint64_t* mask,
                  int rows, int shift) noexcept {
  std::uint64_t met = 0;
  for (int i = 0; i < rows; ++i)
    met |= ((left[i] >> shift) | ((right[i] << 1) << (63 - shift))) & mask[i];
  return met != 0;
}

#if defined(__x86_64__)
// A shift by 64 leaves nothing here.
[[gnu::target("avx2")]] bool meets_avx2(const std::uint64_t* left, const std::uint64_t* right,
                                        const std::uint64_t* mask, int rows, int shift) noexcept {
  const __m128i down = _mm_cvtsi32_si128(shift);
  const __m128i up = _mm_cvtsi32_si128(64 - shift);
  __m256i met = _mm256_setzero_si256();
  for (int i = 0; i < rows; i += kMaskRows) {
    const auto at = [i](const std::uint64_t* of) {
      return reinterpret_cast<const __m256i*>(of + i);
    };
    const __m256i low = _mm256_srl_epi64(_mm256_loadu_si256(at(left)), down);
    const __m256i high = _mm256_sll_epi64(_mm256_loadu_si256(at(right)), up);
    const __m256i bits = _mm256_or_si256(low, high);
    met = _mm256_or_si256(met, _mm256_and_si256(bits, _mm256_loadu_si256(at(mask))));
  }
  return _mm256_testz_si256(met, met) == 0;
}
#endif

}  // namespace

MeetsFn meets_mask([[maybe_unused]] Isa isa) noexcept {
#if defined(__x86_64__)
  if (isa >= Isa::avx2) return meets_avx2;
#endif
  return meets_scalar;
}

}  // namespace lasius::kernels
