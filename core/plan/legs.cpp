#include "core/plan/legs.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/special_values.h"
#include "core/loop/run_status.h"
#include "lasius/path/path.h"

namespace lasius {
namespace {

std::string via_name(std::size_t i) { return "via point " + std::to_string(i + 1); }

/// A sentence about a leg's start and goal as one about what these are.
std::string named(std::string error, const std::string& from, const std::string& to) {
  constexpr std::string_view kStart = "start ", kGoal = "goal ", kAnd = " and goal ";
  if (const auto at = error.find(kAnd); at != std::string::npos)
    error.replace(at + 5, kGoal.size(), to + ' ');
  if (error.starts_with(kStart)) return error.replace(0, kStart.size(), from + ' ');
  if (error.starts_with(kGoal)) return error.replace(0, kGoal.size(), to + ' ');
  return error;
}

template <class Number>
void append(std::vector<Number>& to, const std::vector<Number>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Puts a leg behind those before it.
void join(Result& whole, Result&& leg, bool last) {
  Convergence& all = whole.curves;
  const Convergence& more = leg.curves;
  if (last && !more.best.empty()) {
    all.best.assign(static_cast<std::size_t>(all.iterations), kNaN);
    for (const double length : more.best) all.best.push_back(whole.length + length);
  }
  all.iterations += more.iterations;
  append(all.arrived, more.arrived);
  append(all.steps, more.steps);
  for (const auto curve :
       {&Convergence::mean, &Convergence::raw_best, &Convergence::cut_mean, &Convergence::cut_best,
        &Convergence::iteration_best, &Convergence::band, &Convergence::trail_entropy})
    append(all.*curve, more.*curve);
  for (const Point p : leg.path)
    if (whole.path.empty() || p != whole.path.back()) whole.path.push_back(p);
  append(whole.curve, leg.curve);
  whole.length += leg.length;
  if (whole.lower_bound && leg.lower_bound)
    *whole.lower_bound += *leg.lower_bound;
  else
    whole.lower_bound.reset();
  whole.optimal = whole.optimal && leg.optimal;
  if (leg.way_out) whole.way_out = leg.way_out;
  whole.own_rules = whole.own_rules || leg.own_rules;
  if (leg.status != Status::solved) {
    whole.status = leg.status;
    whole.limit = leg.limit;
  }
  whole.goal_reached = leg.goal_reached;
}

}  // namespace

Result plan_legs(const Request& asked, const std::function<Result(const Request&)>& plan) {
  Result whole;
  whole.status = Status::solved;
  whole.length = 0;
  whole.lower_bound = 0;
  whole.optimal = true;
  const std::size_t count = asked.via.size();
  for (std::size_t i = 0; i <= count; ++i) {
    const bool last = i == count;
    Request leg = asked;
    leg.via.clear();
    if (i > 0) leg.start_point = asked.via[i - 1];
    if (!last) {
      leg.goal_point = asked.via[i];
      leg.goal_tolerance = 0;
    }
    Result found = plan(leg);
    if (found.path.empty()) {
      found.error = named(std::move(found.error), i == 0 ? "start" : via_name(i - 1),
                          last ? "goal" : via_name(i));
      const bool at_start =
          found.fault == Fault::start_blocked || found.fault == Fault::start_outside;
      if (!found.error.empty() && !last && !at_start) found.bad_via = static_cast<int>(i);
      const int done = whole.curves.iterations + found.curves.iterations;
      found.curves = {};  // of no path
      found.curves.iterations = done;
      found.lower_bound.reset();
      return found;
    }
    join(whole, std::move(found), last);
  }
  return whole;
}

void refuse_squeezes(const Grid& grid, const Request& asked, Corners corners, Result& result) {
  if (corners == Corners::allow) return;
  auto at = result.path.begin();
  for (std::size_t i = 0; i < asked.via.size(); ++i) {
    const Point via = asked.via[i];
    at = std::find(at, result.path.end(), via);
    if (at == result.path.end()) return;
    const bool inside = at != result.path.begin() && at + 1 != result.path.end();
    if (!inside || via.x != std::floor(via.x) || via.y != std::floor(via.y)) continue;
    if (!path_fault(grid, std::span<const Point>(at - 1, at + 2), corners)) continue;
    result = failed<Result>(Status::unreachable, Fault::disconnected,
                            via_name(i) +
                                " lies between two blocked cells that meet there, and "
                                "the path would have to pass between them");
    result.bad_via = static_cast<int>(i);
    return;
  }
}

}  // namespace lasius
