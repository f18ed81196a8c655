// The glances by instruction set, each in a source of its own.
#pragma once

#include "kernels/contact/lane_contact.h"

namespace lasius::kernels {

#if defined(__x86_64__)
const LaneContact& avx2_lane_contact() noexcept;
#endif

}  // namespace lasius::kernels
