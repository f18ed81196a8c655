// Where a stop condition reads the time.
#pragma once

#include "lasius/stop.h"

namespace lasius {

/// A clock: one that stands still while nothing is planned, say, or that of a test.
class LASIUS_EXPORT TimeSource {
 public:
  virtual ~TimeSource();
  /// Thread-safe. The default implementation reads the steady clock.
  virtual Clock::time_point now() const noexcept { return Clock::now(); }
};

}  // namespace lasius
