// How a call is told to stop: a token, a deadline, or both.
#pragma once

#include <chrono>
#include <cstdint>
#include <stop_token>

#include "lasius/export.h"

namespace lasius {

using Clock = std::chrono::steady_clock;

/// The time that is so long from now, for a deadline: now where it is negative, never (the clock's
/// last time) from a century on.
LASIUS_EXPORT Clock::time_point deadline_in(std::chrono::duration<double> time) noexcept;

/// A source of time, so that tests can inject one that counts its calls.
class LASIUS_EXPORT TimeSource {
 public:
  virtual ~TimeSource();
  /// Thread-safe. The default implementation reads the steady clock.
  virtual Clock::time_point now() const noexcept { return Clock::now(); }
};

/// When to stop. Long work polls it at least every 4096 ant steps or 65536 scanned words.
struct StopCondition {
  std::stop_token token = {};
  Clock::time_point deadline = Clock::time_point::max();
  const TimeSource* time = nullptr;  ///< null: the steady clock

  enum class Cause { none, token, deadline };
  /// Reads the token, then the clock (the clock only if there is a deadline).
  Cause poll() const noexcept {
    if (token.stop_requested()) return Cause::token;
    if (deadline == Clock::time_point::max()) return Cause::none;
    return (time != nullptr ? time->now() : Clock::now()) >= deadline ? Cause::deadline
                                                                      : Cause::none;
  }
};

/// Counts work and polls a condition each time a budget is spent. Not shared between threads.
class Poller {
 public:
  static constexpr std::int64_t kWords = 65536;  ///< scanned words between two polls
  static constexpr std::int64_t kSteps = 4096;   ///< ant steps between two polls

  explicit Poller(const StopCondition& condition, std::int64_t interval = kWords) noexcept
      : condition_(&condition), interval_(interval), left_(interval) {}

  /// True once the condition asked to stop; `work` is what was done since the last call.
  bool stop_after(std::int64_t work) noexcept {
    left_ -= work;
    if (left_ > 0 || cause_ != StopCondition::Cause::none) return stopped();
    left_ = interval_;
    cause_ = condition_->poll();
    return stopped();
  }
  bool stopped() const noexcept { return cause_ != StopCondition::Cause::none; }
  StopCondition::Cause cause() const noexcept { return cause_; }

 private:
  const StopCondition* condition_;
  std::int64_t interval_;
  std::int64_t left_;
  StopCondition::Cause cause_ = StopCondition::Cause::none;
};

}  // namespace lasius
