// What the two searchers over crossing points have in common.
#pragma once

#include "core/polygon/crossing_run.h"

namespace lasius::polygon {

/// A run of the common loop on one route, which must outlive it. Until something shorter is found
/// `start` is the best path.
class CrossingSearch : public ColonyWorld {
 public:
  CrossingSearch(const Route& route, const Crossing& start, const Params& parameters,
                 const RunControl& control)
      : route_(route),
        start_(start),
        parameters_(parameters),
        control_(control),
        best_length_(start.length) {}

  CrossingRun run() {
    CrossingRun run;
    run.cause = run_colony_loop(*this, iterations_of(parameters_), control_.stop, run.curves);
    run.best = best();
    return run;
  }

  double best_length() const override { return best_length_; }
  bool settled() override { return best_length_ <= control_.good_enough; }
  StopCondition::Cause observe(const Convergence& run) override {
    return control_.observe(run, [this] { return best(); });
  }

 protected:
  virtual Crossing best() const = 0;

  const Route& route_;
  const Crossing& start_;
  const Params& parameters_;
  const RunControl& control_;
  double best_length_;
};

}  // namespace lasius::polygon
