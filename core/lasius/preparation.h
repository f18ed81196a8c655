// What `exact` can prepare of a map before its first question.
#pragma once

#include <cstdint>
#include <string_view>

#include "lasius/export.h"
#include "lasius/stop.h"

namespace lasius {

/// How much `exact` may prepare of a map before its first question.
struct PrepareOptions {
  int threads = 0;  ///< at most 1024; 0: as many as OpenMP gives; never changes what is prepared
  /// Preparation that would hold more is given up. A Workspace takes 32 bytes more for each corner.
  std::int64_t max_bytes = std::int64_t{1} << 30;
  StopCondition stop = {};
};

/// What came of it.
struct Preparation {
  enum class State {
    none,       ///< not asked for, or gone with an edit
    ready,      ///< `exact` plans on it
    too_large,  ///< given up: it would take more than max_bytes
    stopped,    ///< given up: the stop condition said so
  };
  State state = State::none;
  std::int64_t corners = 0;  ///< at which a path may bend; 0 if stopped before they were counted
  std::int64_t edges = 0;    ///< from corner to corner in sight, if ready
  std::int64_t bytes = 0;    ///< held, if ready
  double seconds = 0;        ///< spent
};
LASIUS_EXPORT std::string_view to_string(Preparation::State) noexcept;

}  // namespace lasius
