// The one run of all batches: tasks are done side by side, and their answers given on in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "lasius/batch_options.h"
#include "lasius/export.h"
#include "lasius/stop.h"

namespace lasius {

/// One plan of a batch.
struct BatchTask {
  std::size_t index = 0;    ///< of the request
  std::uint64_t seed = 0;   ///< to plan with
  StopCondition stop = {};  ///< the request's, and the batch's
};
/// Does a task. What it returns gives the answer on.
using BatchWorker = std::function<std::function<void()>(const BatchTask&)>;

/// Does the tasks of a batch, each request with each seed from `seed` on: `stop_of` gives a
/// request's own condition, `make_worker` is called on each thread. Ends and returns as plan_batch.
/// @throws Error(invalid_parameter) for options or seeds out of range, before anything is begun.
LASIUS_EXPORT std::size_t run_tasks(std::size_t requests, std::uint64_t seed,
                                    const BatchOptions& options,
                                    const std::function<StopCondition(std::size_t)>& stop_of,
                                    const std::function<BatchWorker()>& make_worker);

/// The plan_batch of a world: what `make_plan` returns on each thread, a copyable function, is
/// called with a request and a seed, and returns the result.
template <class Result, class Request, class MakePlan>
std::size_t run_batch(std::span<const Request> requests, std::uint64_t seed,
                      const BatchOptions& options, const BatchReceiverOf<Result>& receive,
                      const MakePlan& make_plan) {
  if (!receive)
    throw invalid_parameter("the receiver is empty", "give one, or leave it out for all answers");
  const auto make_worker = [&]() -> BatchWorker {
    return [&, plan = make_plan()](const BatchTask& task) mutable -> std::function<void()> {
      Request request = requests[task.index];
      request.stop = task.stop;
      const auto begin = Clock::now();
      BatchAnswerOf<Result> answer{task.index, task.seed, plan(request, task.seed), {}};
      answer.elapsed = Clock::now() - begin;
      return [&receive, answer = std::move(answer)] { receive(answer); };
    };
  };
  const auto stop_of = [&](std::size_t index) { return requests[index].stop; };
  return run_tasks(requests.size(), seed, options, stop_of, make_worker);
}

}  // namespace lasius
