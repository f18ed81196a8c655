// Stopping where only a question can be asked.
#pragma once

#include <functional>
#include <stop_token>
#include <utility>

#include "lasius/base/stop.h"

namespace lasius::vehicle {

/// A clock that asks whether to stop each time it is read, for callers that have no token to fire,
/// but a function: other libraries' cancel checkers and termination conditions. It outlives the
/// calls that are given its condition.
class StopWhen final : public TimeSource {
 public:
  /// @param stop  is called often, by one thread at a time or as many as plan; it must not throw.
  /// Empty: never
  explicit StopWhen(std::function<bool()> stop) : stop_(std::move(stop)) {}
  StopWhen(const StopWhen&) = delete;
  StopWhen& operator=(const StopWhen&) = delete;

  Clock::time_point now() const noexcept override {
    if (stop_ && stop_()) source_.request_stop();
    return Clock::now();
  }
  /// Ends after this time as Status::limit, or, where the function says so, as Status::interrupted.
  StopCondition within(std::chrono::duration<double> time) const {
    return {.token = source_.get_token(), .deadline = deadline_in(time, now()), .time = this};
  }

 private:
  std::function<bool()> stop_;
  mutable std::stop_source source_;
};

}  // namespace lasius::vehicle
