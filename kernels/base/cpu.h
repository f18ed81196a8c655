// What this CPU can do.
#pragma once

namespace lasius::kernels {

/// Instruction sets that kernels are written for, each including the ones before it.
enum class Isa { scalar, avx2, avx512 };

/// The best one this CPU and its system support.
Isa supported_isa() noexcept;

}  // namespace lasius::kernels
