#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/poller.h"
#include "core/loop/run_status.h"
#include "core/params/parameter_table.h"
#include "core/polygon/crossing_colony.h"
#include "core/polygon/free_space.h"
#include "core/polygon/geometry_check.h"
#include "core/polygon/regions.h"
#include "core/polygon/rings.h"
#include "core/polygon/route.h"
#include "core/polygon/shortest_path.h"
#include "lasius/error.h"
#include "lasius/polygon_plan.h"

namespace lasius::polygon {
namespace {

double checked_margin(double margin) {
  if (const auto wrong = margin_fault(margin)) {
    throw Error(ErrorCode::invalid_parameter, *wrong, kMarginRemedy);
  }
  return margin;
}

const World& checked(const World& world) {
  check(world);
  return world;
}

Maklink maklink_of(const Regions& regions) {
  Maklink graph;
  const FreeSpace& space = regions.space();
  for (std::size_t l = 0; l < regions.links().size(); ++l) {
    const Link& link = regions.links()[l];
    const auto [left, right] = regions.beside(static_cast<int>(l));
    graph.lines.push_back(
        {space.point(regions.at(link.a)), space.point(regions.at(link.b)), left, right});
  }
  for (const Region& region : regions.regions()) {
    auto& corners = graph.regions.emplace_back();
    auto& lines = graph.region_lines.emplace_back();
    for (const Side& side : region.sides) {
      corners.push_back(space.point(regions.at(side.corner)));
      if (side.link >= 0) lines.push_back(side.link);
    }
  }
  graph.free_space = space.pieces;
  return graph;
}

/// The point of a segment nearest to p.
Point nearest_on(Point a, Point b, Point p) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double share = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  if (!(share > 0)) return a;
  return share >= 1 ? b : Point{a.x + share * dx, a.y + share * dy};
}

}  // namespace

class Planner::Impl {
 public:
  Impl(const World& w, const GrowOptions& options, Poller poller)
      : world(checked(w)),
        margin(checked_margin(options.margin.value_or(w.margin))),
        join(options.join),
        regions(make_free_space(w, margin, join), poller),
        whole(!poller.stopped()),
        maklink(whole ? maklink_of(regions) : Maklink{}) {}

  /// On the grid a point of the border may fall just outside: then the free point of the grid
  /// that is nearest to it stands for it.
  Place place(Point p) const {
    Place place{p, regions.space().lattice.nearest(p), {}};
    const double limit = std::ldexp(1.0, 44);
    const Point s = regions.space().lattice.scaled(p);
    if (!(std::abs(s.x) < limit && std::abs(s.y) < limit)) return place;
    constexpr std::int64_t kReach = 2;
    for (std::int64_t reach = 0; reach <= kReach; ++reach) {
      for (std::int64_t dy = -reach; dy <= reach; ++dy) {
        for (std::int64_t dx = -reach; dx <= reach; ++dx) {
          if (std::max(std::abs(dx), std::abs(dy)) != reach) continue;
          const LatticePoint at{place.at.x + dx, place.at.y + dy};
          auto holding = regions.holding(at);
          if (!holding.empty()) return {p, at, std::move(holding)};
        }
      }
    }
    return place;
  }

  /// The answer to a start or goal that is not free.
  Result blocked(bool at_start, Point p, Point nearest) const {
    const bool inside = inside_boundary(p);
    const Fault fault = at_start ? (inside ? Fault::start_blocked : Fault::start_outside)
                                 : (inside ? Fault::goal_blocked : Fault::goal_outside);
    auto result = failed<Result>(Status::invalid, fault,
                                 (at_start ? "start " : "goal ") + text(p) +
                                     (inside ? " is blocked" : " is outside the boundary") +
                                     "; the nearest free point is " + text(nearest));
    result.nearest_free = nearest;
    return result;
  }

  /// Even-odd rule, on the input; the boundary itself is inside. Only for the words of a message.
  bool inside_boundary(Point p) const {
    bool inside = false;
    const Ring& ring = world.boundary.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      const bool between = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
                           std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
      const double turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      if (between && turn == 0) return true;
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
  }

  const World world;
  const double margin;
  const Join join;
  const Regions regions;
  const bool whole;  ///< not cut short
  const Maklink maklink;
};

Planner::Planner(const World& world, const GrowOptions& options)
    : Planner(std::move(*make(world, options, {}))) {}
Planner::Planner(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}

std::optional<Planner> Planner::make(const World& world, const GrowOptions& options,
                                     const StopCondition& stop) {
  auto made = std::make_unique<const Impl>(world, options, Poller(stop));
  if (!made->whole) return std::nullopt;
  return Planner(std::move(made));
}

Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

const World& Planner::world() const noexcept { return impl_->world; }
double Planner::margin() const noexcept { return impl_->margin; }
Join Planner::join() const noexcept { return impl_->join; }
const Maklink& Planner::maklink() const noexcept { return impl_->maklink; }
int Planner::components() const noexcept { return impl_->regions.pieces(); }
const std::vector<Polygon>& Planner::grown_obstacles() const noexcept {
  return impl_->regions.space().obstacles;
}

bool Planner::free(Point p) const { return !impl_->place(p).regions.empty(); }

Point Planner::nearest_free(Point p) const {
  if (free(p)) return p;
  // Squared distances from p, but for that of p from q, the nearest point of the box around the
  // world: else all points would be as near to a p that is far away, by rounding.
  const auto [low, high] = bounds_of(impl_->world.boundary.outer);
  const Point q{std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)};
  const auto compared = [&](Point near) {
    const double dx = near.x - q.x, dy = near.y - q.y;
    return dx * (dx - 2 * (p.x - q.x)) + dy * (dy - 2 * (p.y - q.y));
  };
  Point best = impl_->maklink.free_space.front().outer.front();
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point near = nearest_on(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], p);
      if (!(compared(near) < least)) continue;
      least = compared(near);
      best = near;
    }
  };
  for (const Polygon& piece : impl_->maklink.free_space) {
    look(piece.outer);
    for (const Ring& hole : piece.holes) look(hole);
  }
  return best;
}

namespace {

/// The answer where the goal is the start.
Result stay(Point at) {
  auto result = already_there<Result>();
  result.path = {at};
  return result;
}

bool joined(const Regions& regions, const Place& start, const Place& goal) {
  return std::ranges::any_of(start.regions, [&](int a) {
    return std::ranges::any_of(goal.regions,
                               [&](int b) { return regions.piece(a) == regions.piece(b); });
  });
}

/// The answer where no way leads from one to the other.
Result apart(Point start, Point goal) {
  return failed<Result>(Status::unreachable, Fault::disconnected,
                        "start " + text(start) + " and goal " + text(goal) +
                            " lie in different pieces of free space");
}

/// Dijkstra's route and what runs over it, route by route; the best one is kept.
class RoutePlan {
 public:
  RoutePlan(const Regions& regions, const Params& parameters, const Request& request,
            const Observer& observer)
      : regions_(regions),
        parameters_(parameters),
        request_(request),
        observer_(observer),
        poller_(request.stop) {}

  void run(const Place& start, const Place& goal, double optimum, Result& result) {
    const double enough = request_.target_gap > 0 ? optimum * (1 + request_.target_gap) : 0;
    StopCondition::Cause cause = StopCondition::Cause::none;
    midpoint_routes(regions_, start, goal, parameters_.routes, poller_, [&](const Route& route) {
      cause = search(route, enough, result);
      return cause == StopCondition::Cause::none && result.crossing.length > enough;
    });
    if (cause == StopCondition::Cause::none) cause = poller_.cause();
    result.status = status_after(cause, Status::solved);
    result.path = result.crossing.path;
    result.length = result.crossing.length;
  }

 private:
  /// Says why the run on the route was cut short, or that it was not.
  StopCondition::Cause search(const Route& route, double enough, Result& result) {
    const Crossing dijkstra = cross_at(route, std::vector<double>(route.gates.size(), 0.5));
    CrossingRun run{.best = dijkstra, .curves = {}};
    if (!route.gates.empty()) {
      const RunControl control{request_.stop, enough,
                               [&](const Convergence& now) { return observe(now, result); }};
      run = find_algorithm(parameters_.algorithm()).kind == Algorithm::Kind::genetic
                ? run_crossing_ga(route, dijkstra, parameters_, control)
                : run_crossing_colony(route, dijkstra, parameters_, control);
      append(run.curves, result);
    }
    if (!result.dijkstra || run.best.length < result.crossing.length) {
      result.dijkstra = dijkstra;
      result.crossing = std::move(run.best);
      result.discrete_optimum = discrete_optimum(route, parameters_.values, poller_);
      result.sequence_optimum = sequence_optimum(route, regions_.space());
    }
    return run.cause;
  }

  StopCondition::Cause observe(const Convergence& run, const Result& result) const {
    Progress view;
    view.iteration = result.iterations;
    if (result.dijkstra) view.best_length = result.crossing.length;
    view.lower_bound = result.lower_bound;
    return show(observer_, run, view);
  }

  static void append(const Convergence& run, Result& result) {
    for (const double best : run.best)
      result.best.push_back(result.dijkstra ? std::min(best, result.crossing.length) : best);
    result.mean.insert(result.mean.end(), run.mean.begin(), run.mean.end());
    result.arrived.insert(result.arrived.end(), run.arrived.begin(), run.arrived.end());
    result.iterations += run.iterations;
  }

  const Regions& regions_;
  const Params& parameters_;
  const Request& request_;
  const Observer& observer_;
  Poller poller_;  // of what is not left to the runs
};

}  // namespace

Result Planner::plan(const Request& request, const Params& parameters,
                     const Observer& observer) const {
  validate(parameters);
  check_target_gap(request.target_gap);
  Result result;
  constexpr std::string_view kStart = "start";
  const auto find = [&](std::string_view what, const std::optional<Point>& asked,
                        const std::optional<Point>& written) {
    const auto& point = asked ? asked : written;
    if (!point || !std::isfinite(point->x) || !std::isfinite(point->y)) {
      throw Error(ErrorCode::invalid_parameter, "the world has no " + std::string(what),
                  "give a " + std::string(what));
    }
    Place place = impl_->place(*point);
    if (place.regions.empty())
      result = impl_->blocked(what == kStart, *point, nearest_free(*point));
    return place;
  };
  const Place start = find(kStart, request.start, impl_->world.start);
  if (start.regions.empty()) return result;
  const Place goal = find("goal", request.goal, impl_->world.goal);
  if (goal.regions.empty()) return result;
  if (start.given == goal.given) return stay(start.given);
  const Regions& regions = impl_->regions;
  if (!joined(regions, start, goal)) return apart(start.given, goal.given);

  const ShortestPath shortest = shortest_path(regions, start, goal, request.stop);
  result.lower_bound = shortest.lower_bound;
  if (find_algorithm(parameters.algorithm()).kind == Algorithm::Kind::exact) {
    result.status = status_after(shortest.cause, Status::solved);
    result.path = shortest.path;
    result.length = shortest.path.empty() ? kNaN : shortest.length;
    result.optimal = !shortest.path.empty();
    if (observer && result.optimal) {
      Progress view;  // the only path that the search finds is the last
      view.best_length = result.length;
      view.lower_bound = result.lower_bound;
      observer(view);
    }
    return result;
  }
  RoutePlan(regions, parameters, request, observer).run(start, goal, shortest.lower_bound, result);
  // Lengths are sums of rounded roots: a path may come out a hair below the bound.
  result.lower_bound = std::min(*result.lower_bound, result.length);
  result.optimal = result.length <= *result.lower_bound;
  return result;
}

}  // namespace lasius::polygon
