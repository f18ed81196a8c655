#include "core/loop/batch_run.h"
#include "core/params/parameter_table.h"
#include "core/polygon/route_plan.h"
#include "lasius/polygon/plan.h"

namespace lasius::polygon {

std::size_t plan_batch(const Planner& planner, std::span<const Request> requests,
                       const Params& parameters, const BatchOptions& options,
                       const BatchReceiver& receive) {
  validate(parameters);
  for (const Request& request : requests) {
    check_target_gap(request.target_gap);
    check_goal_tolerance(request.goal_tolerance);
    (void)ends_of(request, planner.world());
  }
  const auto make_plan = [&] {
    return [&planner, mine = parameters](const Request& request, std::uint64_t seed) mutable {
      mine.seed = seed;
      return planner.plan(request, mine);
    };
  };
  return run_batch<Result>(requests, parameters.seed, options, receive, make_plan);
}

std::vector<BatchAnswer> plan_batch(const Planner& planner, std::span<const Request> requests,
                                    const Params& parameters, const BatchOptions& options) {
  return all_answers<Result>(requests, [&](const BatchReceiver& receive) {
    plan_batch(planner, requests, parameters, options, receive);
  });
}

}  // namespace lasius::polygon
