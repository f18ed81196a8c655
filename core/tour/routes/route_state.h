// Routes as rings of tasks, with what it costs to put one in and to take one out.
#pragma once

#include <vector>

#include "core/tour/routes/routes.h"

namespace lasius::tour {

/// Routes that some tasks are in. Nodes are the tasks, then the begin and end of each route, but
/// for a ring, which has neither.
class RouteState {
 public:
  /// A gap between two nodes that follow each other.
  struct Place {
    int before = -1, behind = -1;
    int stop = -1;  ///< that does the task there
    std::int64_t cost = 0;
    bool found() const noexcept { return before >= 0; }
  };

  RouteState(const RouteProblem& problem, const Costs& costs);

  std::int64_t cost() const noexcept { return cost_; }
  bool in(int task) const noexcept { return route_[task] >= 0; }
  int route(int task) const noexcept { return route_[task]; }
  int count(int route) const noexcept { return count_[route]; }
  int next(int node) const noexcept { return next_[node]; }
  bool is_task(int node) const noexcept { return node < problem_->size(); }
  /// The node before a route's first task; -1 of a ring.
  int begin(int route) const noexcept {
    return problem_->ring() ? -1 : problem_->size() + 2 * route;
  }

  void remove(int task);
  void insert(int task, const Place& place);
  /// Betters `best`, which may be none, by the gaps beside a node that is in.
  void try_beside(int node, int task, Place& best) const;
  /// The gaps at the ends of all routes, or of one (-1: all).
  void try_ends(int task, int only, Place& best) const;
  /// All gaps.
  void try_all(int task, Place& best) const;

  /// The tasks of a route in their order; of a ring from any.
  std::vector<int> tasks(int route) const;
  int stop(int task) const noexcept { return stop_[task]; }
  /// Sets what a route does, in order: tasks and the stops that do them.
  void set(int route, const std::vector<int>& tasks, const std::vector<int>& stops);
  std::vector<std::vector<int>> orders() const;

 private:
  Cost leg(int a, int b) const {
    const int from = stop_[a], to = stop_[b];
    return from < 0 || to < 0 || a == b ? 0 : (*costs_)(from, to);
  }
  void try_gap(int before, int behind, int task, Place& best) const;
  bool full(int route) const noexcept { return count_[route] >= problem_->room(); }
  void link(int a, int b) {
    next_[a] = b;
    previous_[b] = a;
  }

  const RouteProblem* problem_;
  const Costs* costs_;
  std::vector<int> next_, previous_, stop_, route_, count_;
  std::int64_t cost_ = 0;
};

}  // namespace lasius::tour
