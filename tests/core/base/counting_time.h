// A clock that counts how often it is read, and a signal that came.
#pragma once

#include <atomic>
#include <chrono>
#include <stop_token>

#include "lasius/base/stop.h"

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

/// Fires a token at the n-th look at the clock, counted from 0.
class FiringTime final : public TimeSource {
 public:
  explicit FiringTime(int looks) : left_(looks) {}
  Clock::time_point now() const noexcept override {
    if (left_-- <= 0) source_.request_stop();
    return {};
  }
  std::stop_token token() const { return source_.get_token(); }
  StopCondition fires() const {
    return {
        .token = token(), .deadline = Clock::time_point{} + std::chrono::hours(1), .time = this};
  }

 private:
  mutable std::atomic<int> left_;
  mutable std::stop_source source_;
};

/// Never holds.
inline const StopCondition kNeverStops;

/// Holds from the beginning.
inline StopCondition fired() {
  std::stop_source source;
  source.request_stop();
  return {.token = source.get_token()};
}

}  // namespace lasius
