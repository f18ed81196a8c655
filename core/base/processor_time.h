// Processor time, of which waits for other programs are no part.
#pragma once

#include <chrono>
#include <ctime>

#include "lasius/base/stop.h"

namespace lasius {

/// Of all threads of the process.
inline double processor_seconds() noexcept {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// For deadlines that a busy machine does not bring nearer.
class ProcessorTime final : public TimeSource {
 public:
  Clock::time_point now() const noexcept override {
    return Clock::time_point{} + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(processor_seconds()));
  }
};

}  // namespace lasius
