#include "lasius/stop.h"

#include <algorithm>

#include "core/base/time_source.h"

namespace lasius {

Clock::time_point deadline_in(std::chrono::duration<double> time) noexcept {
  using Seconds = std::chrono::duration<double>;
  constexpr Seconds kCentury = std::chrono::hours(24 * 36525);
  if (!(time < kCentury)) return Clock::time_point::max();
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::max(time, Seconds(0)));
}

TimeSource::~TimeSource() = default;

StopCondition::Cause StopCondition::poll() const noexcept {
  if (token.stop_requested()) return Cause::token;
  if (deadline == Clock::time_point::max()) return Cause::none;
  return (time != nullptr ? time->now() : Clock::now()) >= deadline ? Cause::deadline : Cause::none;
}

std::string_view to_string(StopCondition::Cause cause) noexcept {
  switch (cause) {
    case StopCondition::Cause::none:
      return "none";
    case StopCondition::Cause::token:
      return "token";
    case StopCondition::Cause::deadline:
      return "deadline";
  }
  return "";
}

}  // namespace lasius
