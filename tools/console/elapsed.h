// What a run took.
#pragma once

#include <chrono>

#include "lasius/stop.h"

namespace lasius::tool {

/// Milliseconds since `start`.
inline double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace lasius::tool
