// What a run took, and what it may take.
#pragma once

#include <chrono>
#include <optional>

#include "lasius/base/stop.h"

namespace lasius::tool {

/// Milliseconds since `start`.
inline double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// The deadline that `seconds` from now sets.
inline Clock::time_point deadline_after(const std::optional<double>& seconds) {
  return seconds ? deadline_in(std::chrono::duration<double>(*seconds)) : Clock::time_point::max();
}

/// What a search after one under `stop` may take: `seconds` from now, if that one had a deadline.
inline StopCondition again(const StopCondition& stop, const std::optional<double>& seconds) {
  const bool limited = stop.deadline != Clock::time_point::max();
  return {.token = stop.token, .deadline = deadline_after(limited ? seconds : std::nullopt)};
}

}  // namespace lasius::tool
