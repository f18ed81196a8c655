#include "kernels/base/raise.h"

#include "kernels/base/power.h"

namespace lasius::kernels {
namespace {

[[gnu::always_inline]] inline void raise_body(double* values, int count, double exponent) noexcept {
  if (exponent == 1) return;
  if (exponent == 2) {
    for (int k = 0; k < count; ++k) values[k] *= values[k];
  } else if (exponent == 4) {
    for (int k = 0; k < count; ++k) {
      const double square = values[k] * values[k];
      values[k] = square * square;
    }
  } else {
    for (int k = 0; k < count; ++k) values[k] = power(values[k], exponent);
  }
}

void raise_scalar(double* values, int count, double exponent) noexcept {
  raise_body(values, count, exponent);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void raise_avx2(double* values, int count, double exponent) noexcept {
  raise_body(values, count, exponent);
}
[[gnu::target("avx512f,avx512dq,avx512vl")]] void raise_avx512(double* values, int count,
                                                               double exponent) noexcept {
  raise_body(values, count, exponent);
}
#endif

}  // namespace

RaiseFn raise_row([[maybe_unused]] Isa isa) noexcept {
#if defined(__x86_64__)
  if (isa >= Isa::avx512) return raise_avx512;
  if (isa >= Isa::avx2) return raise_avx2;
#endif
  return raise_scalar;
}

}  // namespace lasius::kernels
