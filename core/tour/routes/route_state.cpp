#include "core/tour/routes/route_state.h"

namespace lasius::tour {

RouteState::RouteState(const RouteProblem& problem, const Costs& costs)
    : problem_(&problem), costs_(&costs) {
  const std::size_t routes = problem.routes.size(), tasks = problem.tasks.size();
  next_.assign(tasks + 2 * routes, -1);
  previous_ = stop_ = route_ = next_;
  count_.assign(routes, 0);
  for (int r = 0; r < static_cast<int>(routes) && !problem.ring(); ++r) {
    const Ends& ends = problem.routes[r];
    const int first = begin(r), last = first + 1;
    link(first, last);
    stop_[first] = ends.start;
    stop_[last] = ends.open ? ends.goal : ends.start;
    route_[first] = route_[last] = r;
    cost_ += leg(first, last);
  }
}

void RouteState::remove(int task) {
  const int before = previous_[task], behind = next_[task];
  cost_ -= std::int64_t{leg(before, task)} + leg(task, behind) - leg(before, behind);
  if (before != task) link(before, behind);
  --count_[route_[task]];
  route_[task] = -1;
}

void RouteState::insert(int task, const Place& place) {
  route_[task] = route_[place.before];
  if (place.before == task) route_[task] = 0;  // the first of a ring
  ++count_[route_[task]];
  stop_[task] = place.stop;
  link(place.before, task);
  link(task, place.behind);
  cost_ += place.cost;
}

void RouteState::try_gap(int before, int behind, int task, Place& best) const {
  const int from = stop_[before], to = stop_[behind];
  const std::int64_t gone = leg(before, behind);
  for (const int stop : problem_->tasks[task]) {
    // Where legs are priced late most are dearer by their bounds alone.
    if (best.found() && costs_->priced_late() &&
        std::int64_t{from < 0 ? 0 : costs_->lower(from, stop)} +
                (to < 0 ? 0 : costs_->lower(stop, to)) - gone >=
            best.cost)
      continue;
    const std::int64_t cost = std::int64_t{from < 0 ? 0 : (*costs_)(from, stop)} +
                              (to < 0 ? 0 : (*costs_)(stop, to)) - gone;
    if (!best.found() || cost < best.cost) best = {before, behind, stop, cost};
  }
}

void RouteState::try_beside(int node, int task, Place& best) const {
  if (full(route_[node])) return;
  if (previous_[node] >= 0) try_gap(previous_[node], node, task, best);
  if (next_[node] >= 0) try_gap(node, next_[node], task, best);
}

void RouteState::try_ends(int task, int only, Place& best) const {
  if (problem_->ring()) return;
  for (int r = 0; r < static_cast<int>(count_.size()); ++r) {
    if (only >= 0 && r != only) continue;
    try_beside(begin(r), task, best);
    if (count_[r] > 0) try_beside(begin(r) + 1, task, best);
  }
}

void RouteState::try_all(int task, Place& best) const {
  try_ends(task, -1, best);
  for (int other = 0; other < problem_->size(); ++other)
    if (in(other)) try_beside(other, task, best);
  if (!best.found()) best = {task, task, problem_->tasks[task].front(), 0};  // an empty ring
}

std::vector<int> RouteState::tasks(int route) const {
  std::vector<int> order;
  if (problem_->ring()) {
    int first = 0;
    while (first < problem_->size() && !in(first)) ++first;
    if (first == problem_->size()) return order;
    order.push_back(first);
    for (int v = next_[first]; v != first; v = next_[v]) order.push_back(v);
  } else {
    for (int v = next_[begin(route)]; is_task(v); v = next_[v]) order.push_back(v);
  }
  return order;
}

void RouteState::set(int route, const std::vector<int>& tasks, const std::vector<int>& stops) {
  const std::vector<int> gone = this->tasks(route);
  for (const int task : gone) remove(task);
  int before = begin(route);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const int task = tasks[i];
    if (before < 0) before = task;  // the first of a ring
    const int behind = before == task ? task : next_[before];
    const int from = stop_[before], to = stop_[behind], stop = stops[i];
    const std::int64_t cost = before == task
                                  ? 0
                                  : std::int64_t{from < 0 ? 0 : (*costs_)(from, stop)} +
                                        (to < 0 ? 0 : (*costs_)(stop, to)) - leg(before, behind);
    insert(task, {before, behind, stop, cost});
    before = task;
  }
}

std::vector<std::vector<int>> RouteState::orders() const {
  std::vector<std::vector<int>> orders(problem_->routes.size());
  for (int r = 0; r < static_cast<int>(orders.size()); ++r) {
    const Ends& ends = problem_->routes[r];
    if (ends.start >= 0) orders[r].push_back(ends.start);
    for (const int task : tasks(r)) orders[r].push_back(stop_[task]);
    if (ends.goal >= 0) orders[r].push_back(ends.goal);
  }
  return orders;
}

}  // namespace lasius::tour
