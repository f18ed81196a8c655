// Many requests among polygons, planned side by side and answered in order.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lasius/batch_options.h"
#include "lasius/polygon_plan.h"

namespace lasius::polygon {

using BatchAnswer = BatchAnswerOf<Result>;      ///< one answer of a batch
using BatchReceiver = BatchReceiverOf<Result>;  ///< called with each

/// Answers `requests` with `parameters`, several at a time, each as `planner.plan` does with the
/// answer's seed. Order, threads, stops, what is thrown on and what is returned are those of
/// lasius::plan_batch; a start or goal that is outside or blocked is an answer, Status::invalid.
/// @throws Error(invalid_parameter) for parameters, options or a target gap out of range, for a
///         request without start or goal where the world names none, and for an empty receiver,
///         before anything is planned.
LASIUS_POLYGON_EXPORT std::size_t plan_batch(const Planner& planner,
                                             std::span<const Request> requests,
                                             const Params& parameters, const BatchOptions& options,
                                             const BatchReceiver& receive);

/// The same, all answers at the end, in that order; fewer when stopped.
LASIUS_POLYGON_EXPORT std::vector<BatchAnswer> plan_batch(const Planner& planner,
                                                          std::span<const Request> requests,
                                                          const Params& parameters = {},
                                                          const BatchOptions& options = {});

}  // namespace lasius::polygon
