// Opening a named pipe, which a signal has to be able to end.
#pragma once

#include <string>

#include "lasius/export.h"

namespace lasius {

/// Lives while a file is opened: where that is a named pipe, until somebody opens its other end.
class LASIUS_EXPORT OpeningPipe {
 public:
  explicit OpeningPipe(const std::string& path);
  ~OpeningPipe();
  OpeningPipe(const OpeningPipe&) = delete;
  OpeningPipe& operator=(const OpeningPipe&) = delete;

  /// True while one of this process lives that is of a named pipe. For signal handlers.
  static bool under_way() noexcept;

 private:
  bool is_pipe_;
};

}  // namespace lasius
