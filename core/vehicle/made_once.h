// What is made when it is first asked for, under a stop condition.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>

#include "lasius/base/stop.h"

namespace lasius::vehicle {

/// Thread-safe. A call that is stopped leaves it to the next one.
template <class Value>
class MadeOnce {
 public:
  /// Null when stopped. @param make  returns it, or nothing where `stop` holds
  template <class Make>
  const Value* get(const StopCondition& stop, Make&& make) const {
    // Another call may be at it, and have more time.
    std::unique_lock lock(making_, std::defer_lock);
    while (!lock.try_lock_for(std::chrono::milliseconds(1))) {
      if (stop.poll() != StopCondition::Cause::none) return nullptr;
    }
    if (!value_ && stop.poll() == StopCondition::Cause::none) value_ = make();
    return value_ ? &*value_ : nullptr;
  }

 private:
  mutable std::timed_mutex making_;
  mutable std::optional<Value> value_;
};

}  // namespace lasius::vehicle
