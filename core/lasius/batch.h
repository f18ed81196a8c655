// Many requests on one map, planned side by side and answered in order.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "lasius/export.h"
#include "lasius/planner.h"

namespace lasius {

/// How a batch is run.
struct BatchOptions {
  int threads = 0;  ///< to 1024; 0: as many as OpenMP gives; never changes an answer
  /// Time for each request, counted from when it is begun; not negative. A request's own deadline
  /// holds beside it.
  std::optional<std::chrono::duration<double>> time_limit{};
  std::stop_token token{};  ///< ends the batch: see plan_batch
  /// Each request is answered with `Params::seed` and the seeds after it, as many as this, 1 to
  /// 2^20.
  int seeds = 1;
  /// The caller's own, see OwnRules; or none. It and its table outlive the batch. Its functions are
  /// called from several threads at a time, for a plan each.
  const OwnRules* own_rules = nullptr;
};

/// One answer of a batch.
struct BatchAnswer {
  std::size_t index = 0;                    ///< of the request
  std::uint64_t seed = 0;                   ///< that it was planned with
  Result result;                            ///< as Planner::plan gives it
  std::chrono::duration<double> elapsed{};  ///< taken by this one
};
/// Called with each answer.
using BatchReceiver = std::function<void(const BatchAnswer&)>;

/// Answers `requests` with `params`, each on one thread and so, save for time limits, exactly as
/// `planner.plan` does with the answer's seed. `receive` is called once a request and seed, in
/// their order, the seeds of a request together, by one thread at a time, as soon as all earlier
/// ones are answered. Memory: one Workspace a thread, and at most 64 + 8 threads answers that wait
/// for an earlier one.
///
/// Once the token asks to stop, nothing further is begun; those in flight end as `interrupted`
/// and are received. What `receive` throws ends the batch likewise and is thrown again.
/// Returns the number of answers received: all of them unless stopped.
/// @throws Error(invalid_parameter) for parameters, options or a target gap out of range, and for
///         an empty receiver, before anything is planned.
LASIUS_EXPORT std::size_t plan_batch(const Planner& planner, std::span<const Request> requests,
                                     const Params& params, const BatchOptions& options,
                                     const BatchReceiver& receive);

/// The same, all answers at the end, in that order; fewer when stopped.
LASIUS_EXPORT std::vector<BatchAnswer> plan_batch(const Planner& planner,
                                                  std::span<const Request> requests,
                                                  const Params& params = {},
                                                  const BatchOptions& options = {});

}  // namespace lasius
