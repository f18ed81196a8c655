// How a run ended, cut short or not, what came of it, and what an observer sees of it.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lasius/base/status.h"
#include "lasius/base/stop.h"
#include "lasius/path/path.h"
#include "lasius/plan/progress.h"
#include "lasius/plan/result.h"

namespace lasius {

/// The status of a run that `cause` cut short; `otherwise` where nothing did.
constexpr Status status_after(StopCondition::Cause cause, Status otherwise) noexcept {
  switch (cause) {
    case StopCondition::Cause::deadline:
      return Status::limit;
    case StopCondition::Cause::token:
      return Status::interrupted;
    case StopCondition::Cause::none:
      break;
  }
  return otherwise;
}

/// Says in `result` how a run ended; a deadline is the only limit here.
template <class SomeResult>
void end_run(SomeResult& result, StopCondition::Cause cause, Status otherwise) {
  result.status = status_after(cause, otherwise);
  result.limit = result.status == Status::limit ? Limit::time : Limit::none;
}

/// Makes `result` invalid or unreachable.
template <class SomeResult>
SomeResult failed(Status status, Fault fault, const std::string& why) {
  SomeResult result;
  result.status = status;
  result.fault = fault;
  result.error = why;
  return result;
}

/// The answer where the goal is the start: a path of length 0, which the caller adds.
template <class SomeResult>
SomeResult already_there() {
  SomeResult result;
  result.status = Status::solved;
  result.length = 0;
  result.lower_bound = 0;
  result.optimal = true;
  return result;
}

/// The result of a run of the loop on a bitmap. `best` is empty where it found no path.
inline Result result_after(StopCondition::Cause cause, Convergence run, std::vector<Point> best) {
  Result result;
  result.curves = std::move(run);
  end_run(result, cause, best.empty() ? Status::no_path : Status::solved);
  if (best.empty()) return result;
  result.path = std::move(best);
  result.length = path_length(result.path);
  return result;
}

/// Shows an observer, if there is one, the run's last iteration; `view` has the iterations and the
/// best length before the run, if any. Says whether it asked to stop.
template <class SomeObserver, class View>
StopCondition::Cause show(const SomeObserver& observer, const Convergence& run, View view) {
  if (!observer) return StopCondition::Cause::none;
  view.iteration += run.iterations - 1;
  view.best_length = std::fmin(view.best_length, run.best.back());
  view.mean_length = run.mean.back();
  view.arrived = run.arrived.back();
  view.curves = &run;
  return observer(view) == Go::stop ? StopCondition::Cause::token : StopCondition::Cause::none;
}

}  // namespace lasius
