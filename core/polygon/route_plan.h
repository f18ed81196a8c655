// Line sequences searched one after the other, by ants or by the genetic algorithm.
#pragma once

#include <functional>

#include "core/base/poller.h"
#include "core/loop/colony_loop.h"
#include "core/polygon/route.h"

namespace lasius::polygon {

/// The two ends of a path, which may lie where no line is drawn, beside an arc of few tangents.
struct Ends {
  Point start, goal;
};

/// Start and goal of a request, the world's where it names none. @throws Error(invalid_parameter)
/// where neither does, and for coordinates that are no finite numbers.
Ends ends_of(const Request& request, const World& world);

/// Dijkstra's route and what runs over it, route by route; the best one is kept. Paths go straight
/// on to the ends that are asked for.
class RoutePlan {
 public:
  /// All of them must outlive it.
  RoutePlan(const Regions& regions, const Ends& ends, const Params& parameters,
            const Request& request, const Observer& observer);

  /// `start` and `goal` lie in regions; `optimum` is the length of the world's shortest path.
  void run(const Place& start, const Place& goal, double optimum, Result& result);

 private:
  StopCondition::Cause search(const Route& route, double good_enough, Result& result);
  Crossing whole(Crossing crossing) const;
  StopCondition::Cause observe(const Convergence& run, const std::function<Crossing()>& best,
                               const Result& result) const;
  void append(const Convergence& run, Result& result) const;

  const Regions& regions_;
  const Ends ends_;
  double end_pieces_ = 0;  // length of the straight pieces from and to ends_
  const Params& parameters_;
  const Request& request_;
  const Observer& observer_;
  Poller poller_;  // of what is not left to the runs
  StopCondition::Cause observer_cause_ = StopCondition::Cause::none;
};

}  // namespace lasius::polygon
