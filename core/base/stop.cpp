#include "lasius/stop.h"

#include <algorithm>

namespace lasius {

Clock::time_point deadline_in(std::chrono::duration<double> time) noexcept {
  using Seconds = std::chrono::duration<double>;
  constexpr Seconds kCentury = std::chrono::hours(24 * 36525);
  if (!(time < kCentury)) return Clock::time_point::max();
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::max(time, Seconds(0)));
}

TimeSource::~TimeSource() = default;

}  // namespace lasius
