// The one run of all batches: tasks are done side by side, and their answers given on in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/invalid_parameter.h"
#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/plan/batch_options.h"

namespace lasius {

/// One plan of a batch.
struct BatchTask {
  std::size_t index = 0;    ///< of the request
  std::uint64_t seed = 0;   ///< to plan with
  StopCondition stop = {};  ///< the request's, and the batch's
};
/// Does a task, and returns a function that hands the answer to the batch's receiver: it is called
/// when the answers before were received. The task is the worker's to move from.
using BatchWorker = std::function<std::function<void()>(BatchTask&)>;

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
    return [&, plan = make_plan()](BatchTask& task) mutable -> std::function<void()> {
      Request request = requests[task.index];
      request.stop = std::move(task.stop);
      const auto begin = Clock::now();
      BatchAnswerOf<Result> answer{task.index, task.seed, plan(request, task.seed), {}};
      answer.elapsed = Clock::now() - begin;
      return [&receive, answer = std::move(answer)] { receive(answer); };
    };
  };
  const auto stop_of = [&](std::size_t index) { return requests[index].stop; };
  return run_tasks(requests.size(), seed, options, stop_of, make_worker);
}

/// All answers of a plan_batch: `batch` runs it, given the receiver.
template <class Result, class Request, class Batch>
std::vector<BatchAnswerOf<Result>> all_answers(std::span<const Request> requests,
                                               const Batch& batch) {
  std::vector<BatchAnswerOf<Result>> answers;
  answers.reserve(requests.size());
  batch([&](const BatchAnswerOf<Result>& answer) { answers.push_back(answer); });
  return answers;
}

}  // namespace lasius
