// Many requests on one map, planned side by side and answered in order.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lasius/export.h"
#include "lasius/plan/batch_options.h"
#include "lasius/plan/planner.h"

namespace lasius {

using BatchAnswer = BatchAnswerOf<Result>;      ///< one answer of a batch
using BatchReceiver = BatchReceiverOf<Result>;  ///< called with each

/// Answers `requests` with `params`, each on one thread (Params::threads has no effect) and so,
/// save for time limits, exactly as `planner.plan` does with the answer's seed. `receive` is called
/// once for each request and seed, in their order, the seeds of a request together, by one thread
/// at a time, as soon as all earlier ones are answered. Memory: one Workspace per thread, and at
/// most 64 + 8 x threads answers that wait for an earlier one.
///
/// Once the token asks to stop, nothing further is begun; those in flight end as `interrupted`
/// and are received. What `receive` throws ends the batch likewise and is thrown again.
/// Returns the number of answers received: all of them unless stopped.
///
/// `own` are rules of the caller's own, see OwnRules: its functions are called from several threads
/// at a time, a copy of them for each plan.
/// @throws Error(invalid_parameter) for parameters that validate() refuses, options or a
///         target gap out of range, for own rules that do not go with the parameters or the map,
///         and for an empty receiver, before anything is planned.
LASIUS_EXPORT std::size_t plan_batch(const Planner& planner, std::span<const Request> requests,
                                     const Params& params, const BatchOptions& options,
                                     const BatchReceiver& receive, const OwnRules& own = {});

/// The same, all answers at the end, in that order; fewer when stopped.
LASIUS_EXPORT std::vector<BatchAnswer> plan_batch(const Planner& planner,
                                                  std::span<const Request> requests,
                                                  const Params& params = {},
                                                  const BatchOptions& options = {},
                                                  const OwnRules& own = {});

}  // namespace lasius
