// Which kernels a call uses. They never change an answer.
#pragma once

#include "kernels/base/cpu.h"
#include "lasius/export.h"

namespace lasius {

/// The best instruction set of this CPU, or the one named by the environment variable
/// LASIUS_KERNELS (scalar, avx2, avx512). @throws Error(invalid_parameter) if it names none, or one
/// that this CPU lacks.
LASIUS_EXPORT kernels::Isa chosen_isa();

}  // namespace lasius
