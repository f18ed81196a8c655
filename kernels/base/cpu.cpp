#include "kernels/base/cpu.h"

namespace lasius::kernels {

Isa supported_isa() noexcept {
#if defined(__x86_64__)
  // All that the kernels are compiled for: virtual machines mask features one by one.
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("bmi") ||
      !__builtin_cpu_supports("bmi2")) {
    return Isa::scalar;
  }
  const bool masks = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                     __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  return masks ? Isa::avx512 : Isa::avx2;
#else
  return Isa::scalar;
#endif
}

}  // namespace lasius::kernels
