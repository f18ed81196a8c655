// Many questions on one map, planned side by side and answered in order.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>

#include "lasius/export.h"
#include "lasius/planner.h"

namespace lasius {

/// One question of a batch. Deadline and token come from BatchOptions.
struct Query {
  Cell start;
  Cell goal;
};

struct BatchOptions {
  int threads = 0;  ///< to 1024; 0: as many as OpenMP gives; never changes an answer
  /// Time for each query, counted from when it is begun; not negative.
  std::optional<std::chrono::duration<double>> time_limit{};
  double target_gap = 0;    ///< as in Request
  std::stop_token token{};  ///< ends the batch: see plan_batch
};

/// One answer of a batch.
struct BatchAnswer {
  std::size_t index = 0;  ///< of the query
  Result result;
  std::chrono::duration<double> elapsed{};
};
using BatchReceiver = std::function<void(const BatchAnswer&)>;

/// Answers `queries` with `params`, each on one thread and so, save for time limits, exactly as
/// `planner.plan` does. `receive` is called once a query, in the order of the queries, by one
/// thread at a time, as soon as all earlier ones are answered. Memory: one Workspace a thread, and
/// at most 64 + 8 threads answers that wait for an earlier one.
///
/// Once the token asks to stop, no further query is begun; those in flight end as `interrupted`
/// and are received. What `receive` throws ends the batch likewise and is thrown again.
/// Returns the number of answers received: all of them unless stopped.
/// @throws Error(invalid_parameter) for parameters or options out of range, before any query.
LASIUS_EXPORT std::size_t plan_batch(const Planner& planner, std::span<const Query> queries,
                                     const Params& params, const BatchOptions& options,
                                     const BatchReceiver& receive);

}  // namespace lasius
