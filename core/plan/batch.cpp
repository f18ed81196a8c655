#include "lasius/plan/batch.h"

#include <memory>

#include "core/colony/own_update.h"
#include "core/loop/batch_run.h"
#include "core/params/grid_parameters.h"
#include "core/params/parameter_table.h"
#include "core/plan/alternatives.h"
#include "core/plan/answer.h"
#include "core/plan/planner_impl.h"

namespace lasius {

std::size_t plan_batch(const Planner& planner, std::span<const Request> requests,
                       const Params& params, const BatchOptions& options,
                       const BatchReceiver& receive, const OwnRules& own) {
  validate(params);
  check_own_rules(own, planner.grid(), params);
  const Algorithm& algorithm = find_algorithm(params.algorithm());
  check_serves(algorithm, planner.robot());
  for (const Request& request : requests) {
    check_certifies(algorithm, request.target_gap);
    check_goal_tolerance(request.goal_tolerance);
    check_alternatives(request, algorithm, planner.robot());
  }
  if (algorithm.kind == Algorithm::Kind::exact)
    PlannerParts::of(planner).own.expect(static_cast<std::int64_t>(requests.size()) *
                                         options.seeds);
  const auto make_plan = [&] {
    Params mine = params;
    mine.threads = 1;
    return [&planner, &own, mine, workspace = std::make_shared<Workspace>()](
               const Request& request, std::uint64_t seed) mutable {
      mine.seed = seed;
      return planner.plan(request, mine, {.workspace = workspace.get(), .own_rules = own});
    };
  };
  return run_batch<Result>(requests, params.seed, options, receive, make_plan);
}

std::vector<BatchAnswer> plan_batch(const Planner& planner, std::span<const Request> requests,
                                    const Params& params, const BatchOptions& options,
                                    const OwnRules& own) {
  return all_answers<Result>(requests, [&](const BatchReceiver& receive) {
    plan_batch(planner, requests, params, options, receive, own);
  });
}

}  // namespace lasius
