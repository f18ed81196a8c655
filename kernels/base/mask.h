// Whether what a mask of bits covers is set anywhere, wherever it lies.
#pragma once

#include <cstdint>

#include "kernels/base/cpu.h"

namespace lasius::kernels {

/// Masks' rows are padded with zeros to so many.
inline constexpr int kMaskRows = 4;

/// Whether one of `rows` rows of 64 bits has a bit that the mask's row has, too. The bits of row i
/// begin `shift`, 0 to 63, bits into left[i] and go on in right[i].
/// @param rows  a multiple of kMaskRows, of all three
using MeetsFn = bool (*)(const std::uint64_t* left, const std::uint64_t* right,
                         const std::uint64_t* mask, int rows, int shift) noexcept;
/// That of an instruction set.
MeetsFn meets_mask(Isa isa) noexcept;

}  // namespace lasius::kernels
