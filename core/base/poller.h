// The one place where long work asks whether it is to stop.
#pragma once

#include <cstdint>

#include "lasius/stop.h"

namespace lasius {

/// Other work, done in turns with that of a poller's owner.
class InterleavedWork {
 public:
  virtual ~InterleavedWork() = default;
  /// Called after `work` units of the owner's work; returns what asks to stop.
  virtual StopCondition::Cause turn(std::int64_t work) = 0;
};

/// Counts work and polls a condition each time a budget is spent. Not shared between threads.
class Poller {
 public:
  static constexpr std::int64_t kWords = 65536;  ///< scanned words between two polls
  static constexpr std::int64_t kSteps = 4096;   ///< ant steps between two polls

  explicit Poller(const StopCondition& condition, std::int64_t interval = kWords,
                  InterleavedWork* other_work = nullptr) noexcept
      : condition_(&condition), other_work_(other_work), interval_(interval), left_(interval) {}

  /// True once the condition asked to stop; `work` is what was done since the last call.
  bool stop_after(std::int64_t work) {
    left_ -= work;
    if (left_ > 0 || stopped()) return stopped();
    const std::int64_t done = interval_ - left_;
    left_ = interval_;
    polled_ = true;
    cause_ = condition_->poll();
    if (other_work_ != nullptr && !stopped()) cause_ = other_work_->turn(done);
    return stopped();
  }
  bool stopped() const noexcept { return cause_ != StopCondition::Cause::none; }
  StopCondition::Cause cause() const noexcept { return cause_; }
  /// True once the condition was polled.
  bool polled() const noexcept { return polled_; }

 private:
  const StopCondition* condition_;
  InterleavedWork* other_work_;
  std::int64_t interval_;
  std::int64_t left_;
  bool polled_ = false;
  StopCondition::Cause cause_ = StopCondition::Cause::none;
};

}  // namespace lasius
