#include "kernels/contact/lane_contacts.h"

#if defined(__x86_64__)

#define LASIUS_LANES_AVX2
#include "kernels/contact/lanes.h"
// After it.
#include "kernels/contact/lane_contact_body.h"

namespace lasius::kernels {

const LaneContact& avx2_lane_contact() noexcept { return kContact; }

}  // namespace lasius::kernels

#endif
