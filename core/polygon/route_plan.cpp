#include "core/polygon/route_plan.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/loop/run_status.h"
#include "core/params/parameter_table.h"
#include "core/polygon/crossing_run.h"
#include "lasius/path/path.h"

namespace lasius::polygon {

RoutePlan::RoutePlan(const Regions& regions, const Ends& ends, const Params& parameters,
                     const Request& request, const Observer& observer)
    : regions_(regions),
      ends_(ends),
      parameters_(parameters),
      request_(request),
      observer_(observer),
      poller_(request.stop) {}

void RoutePlan::run(const Place& start, const Place& goal, double optimum, Result& result) {
  end_pieces_ = distance(ends_.start, start.given) + distance(goal.given, ends_.goal);
  const double good_enough = request_.target_gap > 0 ? optimum * (1 + request_.target_gap) : 0;
  StopCondition::Cause cause = StopCondition::Cause::none;
  midpoint_routes(regions_, start, goal, parameters_.routes, poller_, [&](const Route& route) {
    cause = observer_cause_;  // though there is another route
    if (cause == StopCondition::Cause::none) cause = search(route, good_enough, result);
    return cause == StopCondition::Cause::none && result.crossing.length > good_enough;
  });
  if (cause == StopCondition::Cause::none) cause = poller_.cause();
  end_run(result, cause, Status::solved);
  result.path = result.crossing.path;
  result.length = result.crossing.length;
}

/// Says why the run on the route was cut short, or that it was not.
StopCondition::Cause RoutePlan::search(const Route& route, double good_enough, Result& result) {
  const Crossing dijkstra = cross_at(route, std::vector<double>(route.gates.size(), 0.5));
  CrossingRun run{.best = dijkstra, .curves = {}};
  if (!route.gates.empty()) {
    const RunControl control{request_.stop, good_enough - end_pieces_,
                             [&](const Convergence& now, const std::function<Crossing()>& best) {
                               return observer_cause_ = observe(now, best, result);
                             }};
    run = find_algorithm(parameters_.algorithm()).kind == Algorithm::Kind::genetic
              ? run_crossing_ga(route, dijkstra, parameters_, control)
              : run_crossing_colony(route, dijkstra, parameters_, control);
    append(run.curves, result);
  }
  const Crossing best = whole(std::move(run.best));
  if (!result.dijkstra || best.length < result.crossing.length) {
    result.dijkstra = whole(dijkstra);
    result.crossing = best;
    result.discrete_optimum = discrete_optimum(route, parameters_.values, poller_);
    if (result.discrete_optimum) result.discrete_optimum = whole(*result.discrete_optimum);
    result.sequence_optimum = whole(sequence_optimum(route, regions_.space()));
  }
  return run.cause;
}

/// The crossing with the straight pieces from and to the ends that are asked for.
Crossing RoutePlan::whole(Crossing crossing) const {
  if (!(end_pieces_ > 0)) return crossing;
  auto& path = crossing.path;
  if (path.front() != ends_.start) path.insert(path.begin(), ends_.start);
  if (path.back() != ends_.goal) path.push_back(ends_.goal);
  crossing.length = path_length(path);
  return crossing;
}

StopCondition::Cause RoutePlan::observe(const Convergence& run,
                                        const std::function<Crossing()>& best,
                                        const Result& result) const {
  PlanProgress view;
  view.path = [&] {
    const Crossing here = whole(best());
    return result.dijkstra && result.crossing.length <= here.length ? result.crossing.path
                                                                    : here.path;
  };
  view.iteration = result.curves.iterations;
  if (result.dijkstra) view.best_length = result.crossing.length;
  view.lower_bound = result.lower_bound;
  return show(observer_, run, view);
}

void RoutePlan::append(const Convergence& run, Result& result) const {
  for (const double best : run.best) {
    const double length = best + end_pieces_;
    result.curves.best.push_back(result.dijkstra ? std::min(length, result.crossing.length)
                                                 : length);
  }
  for (const double mean : run.mean) result.curves.mean.push_back(mean + end_pieces_);
  result.curves.arrived.insert(result.curves.arrived.end(), run.arrived.begin(), run.arrived.end());
  result.curves.iterations += run.iterations;
}

}  // namespace lasius::polygon
