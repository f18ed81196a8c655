// How a call is told to stop: by a token, a deadline, or what a function of the caller's answers.
#pragma once

#include <chrono>
#include <concepts>
#include <functional>
#include <stop_token>
#include <string_view>
#include <type_traits>
#include <utility>

#include "lasius/export.h"

namespace lasius {

using Clock = std::chrono::steady_clock;

/// The deadline `from` + `time`: `from` itself where `time` is negative, and
/// Clock::time_point::max(), which is never, where it is 100 years or more.
LASIUS_EXPORT Clock::time_point deadline_in(std::chrono::duration<double> time,
                                            Clock::time_point from = Clock::now()) noexcept;

/// A clock that deadlines are compared with: simulated time, say, or one that stands still while
/// the caller is at work.
class LASIUS_EXPORT TimeSource {
 public:
  virtual ~TimeSource();
  /// Never earlier than what it said before. Thread-safe. The steady clock, unless overridden.
  virtual Clock::time_point now() const noexcept;
};

/// When to stop. Long work polls it at least every 4096 ant steps, or 65536 words of 64 cells of a
/// bitmap.
struct StopCondition {
  std::stop_token token = {};  ///< ends the call as Status::interrupted
  /// Ends the call as Status::limit.
  Clock::time_point deadline = Clock::time_point::max();
  /// The clock that is read, which outlives the call; null: the steady clock.
  const TimeSource* time = nullptr;

  /// The time that the deadline is compared with.
  LASIUS_EXPORT Clock::time_point now() const noexcept;

  /// What asks to stop.
  enum class Cause { none, token, deadline };
  /// Reads the token, then the clock (the clock only if there is a deadline).
  LASIUS_EXPORT Cause poll() const noexcept;
};
/// The name, as in "deadline".
LASIUS_EXPORT std::string_view to_string(StopCondition::Cause cause) noexcept;

/// Whether what has called is to go on. Told to stop, and where it has not ended by itself, as a
/// search has in its last iteration or in one in which it settles, it ends with the best so far as
/// Status::interrupted.
enum class Go { on, stop };

/// Called with these, it answers Go, or returns nothing.
template <class Function, class... Args>
concept AnswersGo = std::invocable<Function&, Args&...> &&
    (std::is_void_v<std::invoke_result_t<Function&, Args&...>> ||
     std::same_as<std::invoke_result_t<Function&, Args&...>, Go>);

/// A function of the caller's that answers Go, or returns nothing, which is Go::on; or none.
template <class... Args>
class Callback {
 public:
  Callback() = default;
  /// Of anything that can be copied and called so; none of an empty std::function or Callback.
  template <AnswersGo<Args...> Function>
  Callback(Function function) {
    if constexpr (requires { function.operator bool(); })
      if (!function) return;
    function_ = [called = std::move(function)](Args... args) mutable {
      if constexpr (std::is_void_v<std::invoke_result_t<Function&, Args&...>>) {
        called(args...);
        return Go::on;
      } else {
        return called(args...);
      }
    };
  }
  /// Precondition: there is one.
  Go operator()(Args... args) const { return function_(args...); }
  explicit operator bool() const noexcept { return static_cast<bool>(function_); }  ///< is there?

 private:
  std::function<Go(Args...)> function_;
};

}  // namespace lasius
