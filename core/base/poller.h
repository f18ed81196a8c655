// The one place where long work asks whether it is to stop.
#pragma once

#include <cstdint>
#include <utility>

#include "lasius/base/stop.h"

namespace lasius {

/// Counts work and polls a condition each time a budget is spent. Not shared between threads.
class Poller {
 public:
  static constexpr std::int64_t kWords = 65536;  ///< scanned words between two polls
  static constexpr std::int64_t kSteps = 4096;   ///< ant steps between two polls

  explicit Poller(const StopCondition&&, std::int64_t = kWords) = delete;  // none to refer to
  explicit Poller(const StopCondition& condition, std::int64_t interval = kWords) noexcept
      : condition_(&condition), interval_(interval), left_(interval) {}

  /// True once the condition asked to stop; `work` is what was done since the last call.
  bool stop_after(std::int64_t work) {
    left_ -= work;
    if (left_ > 0 || stopped()) return stopped();
    work_ += interval_ - left_;
    left_ = interval_;
    polled_ = true;
    cause_ = condition_->poll();
    return stopped();
  }
  /// Somebody else asks to stop, or `none`. Precondition: nobody has.
  void stop(StopCondition::Cause cause) noexcept { cause_ = cause; }
  /// The work until the last poll, since it was last taken.
  std::int64_t take_work() noexcept { return std::exchange(work_, 0); }
  bool stopped() const noexcept { return cause_ != StopCondition::Cause::none; }
  StopCondition::Cause cause() const noexcept { return cause_; }
  /// True once the condition was polled.
  bool polled() const noexcept { return polled_; }

 private:
  const StopCondition* condition_;
  std::int64_t interval_;
  std::int64_t left_;
  std::int64_t work_ = 0;
  bool polled_ = false;
  StopCondition::Cause cause_ = StopCondition::Cause::none;
};

}  // namespace lasius
