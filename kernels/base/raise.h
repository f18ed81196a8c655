// Powers of a whole row.
#pragma once

#include "kernels/base/cpu.h"

namespace lasius::kernels {

/// values[k] <- values[k]^exponent for `count` normal values above 0, by `power`, or by
/// multiplication for the exponents 1, 2 and 4 that schedules end at. Bit for bit the same on every
/// instruction set.
using RaiseFn = void (*)(double* values, int count, double exponent) noexcept;
RaiseFn raise_row(Isa isa) noexcept;

}  // namespace lasius::kernels
