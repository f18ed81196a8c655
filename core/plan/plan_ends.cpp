#include "core/plan/plan_ends.h"

#include "core/base/nearest_text.h"
#include "core/loop/run_status.h"

namespace lasius {
namespace {

/// The answer to a start or goal that is blocked or outside; `other` is the other end, if good.
Result invalid(const Ends& ends, bool at_start, const Asked& end, const std::stop_token& token,
               const std::optional<Point>& other) {
  const auto [fault, text] = ends.fault(at_start, end);
  auto result = failed<Result>(Status::invalid, fault, text);
  result.nearest_free = ends.nearest(end, token);
  if (result.nearest_free && other) {
    result.nearest_reachable = ends.joined(*other, centre(*result.nearest_free)) == true
                                   ? result.nearest_free
                                   : ends.nearest(end, token, other);
  }
  if (result.nearest_free) {
    const auto& reachable = result.nearest_reachable;
    result.error += nearest_text(at_start, cell_name(*result.nearest_free),
                                 reachable ? std::optional(cell_name(*reachable)) : std::nullopt);
  } else if (!token.stop_requested()) {
    result.error += "; the map has no free cell";
  }
  return result;
}

Result stopped(StopCondition::Cause cause) {
  Result result;
  end_run(result, cause, Status::limit);
  return result;
}

}  // namespace

std::pair<Fault, std::string> fault_of_end(const Grid& grid, bool at_start, Cell cell,
                                           const std::string& what, const std::string& name) {
  const bool inside = grid.contains(cell);
  const Fault fault = at_start ? (inside ? Fault::start_blocked : Fault::start_outside)
                               : (inside ? Fault::goal_blocked : Fault::goal_outside);
  return {fault, (at_start ? "start " : "goal ") + (name.empty() ? cell_name(cell) : name) +
                     " is " + (inside ? what : "outside the map")};
}

Result apart(const Ends& ends, const Request& request, const Asked& start, const Asked& goal,
             Point from) {
  auto result = failed<Result>(Status::unreachable, Fault::disconnected,
                               "start " + start.name() + " and goal " + goal.name() +
                                   " lie in different regions of free cells");
  if (request.goal_tolerance > 0)
    result.nearest_reachable = ends.nearest(goal, request.stop.token, from);
  return result;
}

std::optional<Result> refused(const Ends& ends, const Request& request, const Asked& start,
                              const Asked& goal, Places& places) {
  places = {start.at, goal.at};
  const bool goal_serves = ends.serves(goal);
  if (!ends.serves(start)) {
    const auto to = goal_serves ? std::optional(places.to) : std::nullopt;
    Poller poller(request.stop);
    places.way_out = ends.way_out(start, to, poller);
    if (!places.way_out && to && request.goal_tolerance > 0)
      places.way_out = ends.way_out(start, {}, poller);
    if (poller.stopped()) return stopped(poller.cause());
    if (!places.way_out) return invalid(ends, true, start, request.stop.token, to);
    places.from = *places.way_out;
  }
  if (goal_serves) {
    const auto joined = places.from == places.to ? true : ends.joined(places.from, places.to);
    if (!joined) return stopped(request.stop.poll());
    if (*joined) return std::nullopt;
  }
  const double tolerance = request.goal_tolerance;
  if (tolerance > 0) {
    const auto nearest = ends.nearest_point(goal, request.stop.token, places.from);
    if (nearest && distance(*nearest, places.to) <= tolerance) {
      places.to = *nearest;
      return std::nullopt;
    }
  }
  Result refusal = goal_serves ? apart(ends, request, start, goal, places.from)
                               : invalid(ends, false, goal, request.stop.token, places.from);
  if (const auto& nearest = refusal.nearest_reachable; nearest && tolerance > 0)
    refusal.error += "; the nearest cell that can be reached, " + cell_name(*nearest) + ", is " +
                     rounded_text(distance(centre(*nearest), goal.at)) +
                     " cells from the goal, its tolerance " + rounded_text(tolerance);
  return refusal;
}

}  // namespace lasius
