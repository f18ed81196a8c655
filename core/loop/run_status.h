// How a run ended that was, or was not, cut short, and what came of it.
#pragma once

#include <utility>
#include <vector>

#include "core/loop/colony_loop.h"
#include "lasius/path.h"
#include "lasius/progress.h"
#include "lasius/result.h"
#include "lasius/status.h"
#include "lasius/stop.h"

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

/// The result of a run of the loop on a bitmap. `best` is empty where it found no path.
inline Result result_after(StopCondition::Cause cause, Convergence run, std::vector<Point> best) {
  Result result;
  result.iterations = run.iterations;
  result.best = std::move(run.best);
  result.mean = std::move(run.mean);
  result.arrived = std::move(run.arrived);
  result.status = status_after(cause, best.empty() ? Status::no_path : Status::solved);
  if (best.empty()) return result;
  result.path = std::move(best);
  result.length = path_length(result.path);
  return result;
}

/// Progress with the figures of a run's last iteration.
class RunProgress : public Progress {
 protected:
  explicit RunProgress(const Convergence& run) {
    iteration = run.iterations - 1;
    best_length = run.best.back();
    mean_length = run.mean.back();
    arrived = run.arrived.back();
  }
};

}  // namespace lasius
