// A clock that counts how often it is read, and a signal that came.
#pragma once

#include <atomic>
#include <chrono>
#include <stop_token>

#include "lasius/stop.h"

namespace lasius {

/// Time is up at the n-th look at the clock, counted from 0.
class CountingTime final : public TimeSource {
 public:
  explicit CountingTime(int polls) : left_(polls) {}
  Clock::time_point now() const noexcept override {
    ++polls_;
    return left_-- > 0 ? Clock::time_point{} : Clock::time_point{} + std::chrono::hours(1);
  }
  int polls() const noexcept { return polls_; }
  /// Holds once time is up.
  StopCondition is_up() const {
    return {.deadline = Clock::time_point{} + std::chrono::minutes(1), .time = this};
  }

 private:
  mutable std::atomic<int> left_;
  mutable std::atomic<int> polls_ = 0;
};

/// Holds from the beginning.
inline StopCondition fired() {
  std::stop_source source;
  source.request_stop();
  return {.token = source.get_token()};
}

}  // namespace lasius
