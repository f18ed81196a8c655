// Eight floats side by side. Where LASIUS_LANES_AVX2 is defined they stand in a register of AVX2,
// else in two vectors of four that any compiler makes: with the same operations in the same order.
#pragma once

#include <array>
#include <cmath>
#include <cstring>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#if defined(LASIUS_LANES_AVX2)
#define LASIUS_LANES [[gnu::target("avx2"), gnu::always_inline]] inline
#define LASIUS_LANES_TARGET [[gnu::target("avx2")]]
#else
#define LASIUS_LANES [[gnu::always_inline]] inline
#define LASIUS_LANES_TARGET
#endif

namespace lasius::kernels {
namespace {

#if defined(LASIUS_LANES_AVX2)

struct Lanes {
  __m256 of;
};

LASIUS_LANES Lanes load(const float* p) noexcept { return {_mm256_loadu_ps(p)}; }
LASIUS_LANES void store(float* p, Lanes a) noexcept { _mm256_storeu_ps(p, a.of); }
LASIUS_LANES Lanes all(float v) noexcept { return {_mm256_set1_ps(v)}; }
LASIUS_LANES Lanes operator+(Lanes a, Lanes b) noexcept { return {_mm256_add_ps(a.of, b.of)}; }
LASIUS_LANES Lanes operator-(Lanes a, Lanes b) noexcept { return {_mm256_sub_ps(a.of, b.of)}; }
LASIUS_LANES Lanes operator*(Lanes a, Lanes b) noexcept { return {_mm256_mul_ps(a.of, b.of)}; }
LASIUS_LANES Lanes operator/(Lanes a, Lanes b) noexcept { return {_mm256_div_ps(a.of, b.of)}; }
LASIUS_LANES Lanes least(Lanes a, Lanes b) noexcept { return {_mm256_min_ps(a.of, b.of)}; }
LASIUS_LANES Lanes most(Lanes a, Lanes b) noexcept { return {_mm256_max_ps(a.of, b.of)}; }
LASIUS_LANES Lanes root(Lanes a) noexcept { return {_mm256_sqrt_ps(a.of)}; }
/// Bit l: that of lane l.
LASIUS_LANES unsigned less(Lanes a, Lanes b) noexcept {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.of, b.of, _CMP_LT_OQ)));
}

#elif defined(__x86_64__)

struct Lanes {
  __m128 low, high;
};

LASIUS_LANES Lanes load(const float* p) noexcept { return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)}; }
LASIUS_LANES void store(float* p, Lanes a) noexcept {
  _mm_storeu_ps(p, a.low);
  _mm_storeu_ps(p + 4, a.high);
}
LASIUS_LANES Lanes all(float v) noexcept { return {_mm_set1_ps(v), _mm_set1_ps(v)}; }
LASIUS_LANES Lanes operator+(Lanes a, Lanes b) noexcept {
  return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)};
}
LASIUS_LANES Lanes operator-(Lanes a, Lanes b) noexcept {
  return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)};
}
LASIUS_LANES Lanes operator*(Lanes a, Lanes b) noexcept {
  return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)};
}
LASIUS_LANES Lanes operator/(Lanes a, Lanes b) noexcept {
  return {_mm_div_ps(a.low, b.low), _mm_div_ps(a.high, b.high)};
}
LASIUS_LANES Lanes least(Lanes a, Lanes b) noexcept {
  return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}
LASIUS_LANES Lanes most(Lanes a, Lanes b) noexcept {
  return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}
LASIUS_LANES Lanes root(Lanes a) noexcept { return {_mm_sqrt_ps(a.low), _mm_sqrt_ps(a.high)}; }
LASIUS_LANES unsigned less(Lanes a, Lanes b) noexcept {
  const int low = _mm_movemask_ps(_mm_cmplt_ps(a.low, b.low));
  return static_cast<unsigned>(low | _mm_movemask_ps(_mm_cmplt_ps(a.high, b.high)) << 4);
}

#else

struct Lanes {
  std::array<float, 8> of;
};

template <class Make>
Lanes each(const Make& make) noexcept {
  Lanes a;
  for (int l = 0; l < 8; ++l) a.of[l] = make(l);
  return a;
}
inline Lanes load(const float* p) noexcept {
  return each([&](int l) { return p[l]; });
}
inline void store(float* p, const Lanes& a) noexcept { std::memcpy(p, a.of.data(), sizeof a.of); }
inline Lanes all(float v) noexcept {
  return each([&](int) { return v; });
}
inline Lanes operator+(const Lanes& a, const Lanes& b) noexcept {
  return each([&](int l) { return a.of[l] + b.of[l]; });
}
inline Lanes operator-(const Lanes& a, const Lanes& b) noexcept {
  return each([&](int l) { return a.of[l] - b.of[l]; });
}
inline Lanes operator*(const Lanes& a, const Lanes& b) noexcept {
  return each([&](int l) { return a.of[l] * b.of[l]; });
}
inline Lanes operator/(const Lanes& a, const Lanes& b) noexcept {
  return each([&](int l) { return a.of[l] / b.of[l]; });
}
inline Lanes least(const Lanes& a, const Lanes& b) noexcept {
  return each([&](int l) { return a.of[l] < b.of[l] ? a.of[l] : b.of[l]; });
}
inline Lanes most(const Lanes& a, const Lanes& b) noexcept {
  return each([&](int l) { return a.of[l] > b.of[l] ? a.of[l] : b.of[l]; });
}
inline Lanes root(const Lanes& a) noexcept {
  return each([&](int l) { return std::sqrt(a.of[l]); });
}
inline unsigned less(const Lanes& a, const Lanes& b) noexcept {
  unsigned bits = 0;
  for (int l = 0; l < 8; ++l) bits |= static_cast<unsigned>(a.of[l] < b.of[l]) << l;
  return bits;
}

#endif

LASIUS_LANES Lanes size_of(Lanes a) noexcept { return most(a, all(0) - a); }

/// A vector or point of space in each lane.
struct Lanes3 {
  Lanes x, y, z;
};
LASIUS_LANES Lanes3 all(const std::array<float, 3>& v) noexcept {
  return {all(v[0]), all(v[1]), all(v[2])};
}
LASIUS_LANES Lanes3 operator+(Lanes3 a, Lanes3 b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
LASIUS_LANES Lanes3 operator-(Lanes3 a, Lanes3 b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
LASIUS_LANES Lanes3 operator*(Lanes s, Lanes3 a) noexcept { return {s * a.x, s * a.y, s * a.z}; }
LASIUS_LANES Lanes dot(Lanes3 a, Lanes3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
LASIUS_LANES Lanes3 cross(Lanes3 a, Lanes3 b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace
}  // namespace lasius::kernels
