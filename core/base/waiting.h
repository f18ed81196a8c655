// Waiting for the other end of a pipe, which a signal has to be able to end.
#pragma once

#include "lasius/export.h"

namespace lasius {

/// While it lives, this process opens what may be a named pipe, and waits until somebody opens its
/// other end. One at a time.
class LASIUS_EXPORT Waiting {
 public:
  explicit Waiting(bool waits = true) noexcept;
  ~Waiting();
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

  /// True where there is one that waits. For signal handlers.
  static bool now() noexcept;
};

}  // namespace lasius
