#include "kernels/contact/lane_contact.h"

#include "kernels/contact/lane_contacts.h"
#include "kernels/contact/lanes.h"
// After both.
#include "kernels/contact/lane_contact_body.h"

namespace lasius::kernels {

const LaneContact& lane_contact([[maybe_unused]] Isa isa) noexcept {
#if defined(__x86_64__)
  if (isa >= Isa::avx2) return avx2_lane_contact();
#endif
  return kContact;
}

}  // namespace lasius::kernels
