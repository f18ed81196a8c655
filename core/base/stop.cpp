#include "lasius/base/stop.h"

#include <algorithm>

#include "lasius/base/enum_names.h"

namespace lasius {

Clock::time_point deadline_in(std::chrono::duration<double> time, Clock::time_point from) noexcept {
  using Seconds = std::chrono::duration<double>;
  constexpr Seconds kCentury = std::chrono::hours(24 * 36525);
  if (!(time < kCentury)) return Clock::time_point::max();
  const auto wait = std::chrono::duration_cast<Clock::duration>(std::max(time, Seconds(0)));
  return from > Clock::time_point::max() - wait ? Clock::time_point::max() : from + wait;
}

TimeSource::~TimeSource() = default;
Clock::time_point TimeSource::now() const noexcept { return Clock::now(); }

Clock::time_point StopCondition::now() const noexcept {
  return time != nullptr ? time->now() : Clock::now();
}

StopCondition::Cause StopCondition::poll() const noexcept {
  if (token.stop_requested()) return Cause::token;
  if (deadline == Clock::time_point::max()) return Cause::none;
  return now() >= deadline ? Cause::deadline : Cause::none;
}

std::string_view to_string(StopCondition::Cause cause) noexcept {
  static constexpr std::array<std::string_view, 3> kNames{"none", "token", "deadline"};
  return name_of(cause, kNames);
}

}  // namespace lasius
