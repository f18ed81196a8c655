// How many requests are planned side by side, and what their answers tell, whatever the world.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

namespace lasius {

/// How a batch is run.
struct BatchOptions {
  int threads = 0;  ///< to 1024; 0: as many as OpenMP gives; never changes an answer
  /// Time for each request, counted from when it is begun; not negative. With 0 a search ends
  /// at its first look at the clock, as Status::limit unless it has its answer by then. A request's
  /// own deadline holds beside it.
  std::optional<std::chrono::duration<double>> time_limit{};
  std::stop_token token{};  ///< ends the batch: see plan_batch
  /// How many seeds each request is answered with, 1 to 2^20: that of the parameters and those
  /// after it, of which the last is at most 2^53 - 1.
  int seeds = 1;
};

/// One answer of a batch, with the Result of its world.
template <class Result>
struct BatchAnswerOf {
  std::size_t index = 0;                    ///< of the request
  std::uint64_t seed = 0;                   ///< that it was planned with
  Result result;                            ///< as the planner's `plan` gives it
  std::chrono::duration<double> elapsed{};  ///< taken by this one
};
/// Called with each answer.
template <class Result>
using BatchReceiverOf = std::function<void(const BatchAnswerOf<Result>&)>;

}  // namespace lasius
