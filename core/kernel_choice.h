// Which kernels and how many threads a call uses. Neither ever changes an answer.
#pragma once

#include "kernels/cpu.h"
#include "lasius/params.h"

namespace lasius {

/// The best instruction set of this CPU, or the one named by the environment variable
/// LASIUS_KERNELS (scalar, avx2, avx512). @throws Error(invalid_parameter) if it names none, or one
/// that this CPU lacks.
kernels::Isa chosen_isa();

/// params.threads, or where that is 0 as many as OpenMP gives.
int thread_count(const Params& params) noexcept;

}  // namespace lasius
