// Waiting for the other end of a pipe, which a signal has to be able to end.
#pragma once

#include "lasius/export.h"

namespace lasius {

/// While it lives, this process waits for somebody else: to open a named pipe, or to write to it.
/// One at a time.
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
