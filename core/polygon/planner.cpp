#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/loop/run_status.h"
#include "core/params/parameter_table.h"
#include "core/polygon/free_space.h"
#include "core/polygon/lengths.h"
#include "core/polygon/nearest.h"
#include "core/polygon/regions.h"
#include "core/polygon/route.h"
#include "core/polygon/route_plan.h"
#include "core/polygon/shortest_path.h"
#include "core/polygon/world/geometry_check.h"
#include "core/polygon/world/rings.h"
#include "lasius/polygon/plan.h"
#include "lasius/tour/tour.h"

namespace lasius::polygon {
namespace {

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

/// The piece of free space that holds a point, its border included; -1: none.
int piece_of(const FreeSpace& space, Point p) {
  for (std::size_t i = 0; i < space.pieces.size(); ++i) {
    const Polygon& piece = space.pieces[i];
    const auto in_it = [p](const Ring& hole) { return inside(hole, p); };
    if (inside(piece.outer, p) && std::ranges::none_of(piece.holes, in_it))
      return static_cast<int>(i);
  }
  return -1;
}

/// How many pieces there are, and ways around obstacles.
std::pair<std::size_t, std::size_t> passages(const FreeSpace& space) {
  std::size_t holes = 0;
  for (const Polygon& piece : space.pieces) holes += piece.holes.size();
  return {space.pieces.size(), holes};
}

/// Of a point within the boundary: is it an obstacle's?
bool covered(const World& world, Point p) {
  const auto within = [p](const Ring& ring) { return inside(ring, p); };
  return std::ranges::any_of(world.boundary.holes, within) ||
         std::ranges::any_of(world.obstacles, [&](const Polygon& obstacle) {
           return within(obstacle.outer) && std::ranges::none_of(obstacle.holes, within);
         });
}

GrowOptions with_margin(GrowOptions options, double margin) {
  options.margin = options.margin.value_or(margin);
  if (const auto wrong = margin_fault(*options.margin)) refuse(*wrong, kMarginRemedy);
  return options;
}

}  // namespace

class Planner::Impl {
 public:
  Impl(const World& w, const GrowOptions& options, Poller& poller)
      : world(checked(w)),
        growth(with_margin(options, w.margin)),
        regions(make_free_space(w, growth, Tangents::many), poller) {
    if (poller.stopped()) return;
    const bool grows = *growth.margin > 0;
    if (grows && growth.join == Join::round) {
      few.emplace(make_free_space(w, growth, Tangents::few), poller);
    } else if (grows && growth.join == Join::mitre) {
      GrowOptions other = growth;
      other.join = Join::round;
      round = make_free_space(w, other, Tangents::many);
    }
    if (poller.stopped()) return;
    maklink = maklink_of(lined());
    whole = true;
  }

  /// What lines are drawn in, and where a way from p enters it.
  const Regions& lined() const { return few ? *few : regions; }
  Place enter(Point p) const {
    Place place = place_in(lined(), p);
    if (!place.regions.empty()) return place;
    return place_in(lined(), nearest_point(lined().space(), world.boundary.outer, p).value_or(p));
  }

  /// The answer to a start or goal that is not free; `other` is the other one.
  Result blocked(bool at_start, Point p, const Place& other) const {
    const bool inside = polygon::inside(world.boundary.outer, p);
    const Fault fault = at_start ? (inside ? Fault::start_blocked : Fault::start_outside)
                                 : (inside ? Fault::goal_blocked : Fault::goal_outside);
    const bool near = *growth.margin > 0 && !covered(world, p);
    const std::string why = !inside ? " is outside the boundary; "
                            : near  ? " is nearer to what is blocked than the margin of " +
                                         number_text(*growth.margin) + "; "
                                   : " is blocked; ";
    auto result =
        failed<Result>(Status::invalid, fault, (at_start ? "start " : "goal ") + text(p) + why);
    const auto nearest = nearest_point(regions.space(), world.boundary.outer, p);
    result.nearest_free = nearest;
    if (!nearest) {
      result.error += "no space is free";
      return result;
    }
    result.error += "the nearest free point ";
    if (other.regions.empty() || joined(regions, other, place_in(regions, *nearest))) {
      if (!other.regions.empty()) result.nearest_reachable = nearest;
      result.error += "is " + text(*nearest);
      return result;
    }
    const Point leads = nearest_joined(regions, world.boundary.outer, other, p).given;
    result.nearest_reachable = leads;
    result.error += (at_start ? "from which the goal can be reached is " + text(leads)
                              : "that can be reached from the start is " + text(leads)) +
                    "; " + text(*nearest) + " is nearer, but " +
                    (at_start ? "does not lead there" : "cannot be reached");
    return result;
  }

  /// Where a path to a goal that cannot be reached ends; with its place, or nothing and why.
  std::optional<Place> instead_of(const Place& goal, const Place& start, double tolerance,
                                  Result& refusal) const {
    const Place near = nearest_joined(regions, world.boundary.outer, start, goal.given);
    refusal.nearest_reachable = near.given;
    const double away = far_distance(near.given, goal.given);
    if (away <= tolerance) return near;
    refusal.error += "; the nearest point that can be reached, " + text(near.given) + ", is " +
                     number_text(away) + " from the goal, its tolerance " + number_text(tolerance);
    return std::nullopt;
  }

  /// What mitre joins take away from start and goal, or from the whole.
  std::string note(const Result& answer, Point start, Point goal) const {
    if (!round) return {};
    const int from = piece_of(*round, start), to = piece_of(*round, goal);
    if (answer.status == Status::invalid) {
      const bool at_start =
          answer.fault == Fault::start_blocked || answer.fault == Fault::start_outside;
      if ((at_start ? from : to) < 0) return {};
      return std::string("with round joins the ") + (at_start ? "start" : "goal") +
             " is free: mitre joins reach farther than the margin";
    }
    if (answer.status == Status::unreachable && from >= 0 && from == to)
      return "with round joins start and goal are joined: mitre joins close a passage that the "
             "margin leaves open";
    const FreeSpace& mine = regions.space();
    if (passages(mine) == passages(*round)) return {};
    return "mitre joins close passages that the margin leaves open; round joins do not";
  }

  const World world;
  const GrowOptions growth;
  const Regions regions;
  std::optional<Regions> few;      ///< with few tangents, for round joins
  std::optional<FreeSpace> round;  ///< beside that of mitre joins
  Maklink maklink;
  bool whole = false;  ///< not cut short
};

Planner::Planner(const World& world, const GrowOptions& options)
    : Planner(std::move(*make(world, options, {}))) {}
Planner::Planner(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}

std::optional<Planner> Planner::make(const World& world, const GrowOptions& options,
                                     const StopCondition& stop) {
  Poller poller(stop);
  auto made = std::make_unique<const Impl>(world, options, poller);
  if (!made->whole) return std::nullopt;
  return Planner(std::move(made));
}

Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

const World& Planner::world() const noexcept { return impl_->world; }
double Planner::margin() const noexcept { return *impl_->growth.margin; }
Join Planner::join() const noexcept { return impl_->growth.join; }
Boundary Planner::boundary() const noexcept { return impl_->growth.boundary; }
const Maklink& Planner::maklink() const noexcept { return impl_->maklink; }
const std::vector<Polygon>& Planner::free_space() const noexcept {
  return impl_->regions.space().pieces;
}
int Planner::components() const noexcept { return impl_->regions.pieces(); }
const std::vector<Polygon>& Planner::grown_obstacles() const noexcept {
  return impl_->regions.space().obstacles;
}

bool Planner::free(Point p) const { return !place_in(impl_->regions, p).regions.empty(); }

std::optional<Point> Planner::nearest_free(Point p) const {
  if (free(p)) return p;
  return nearest_point(impl_->regions.space(), impl_->world.boundary.outer, p);
}

namespace {

/// The answer where the goal is the start.
Result stay(Point at) {
  auto result = already_there<Result>();
  result.path = {at};
  result.optimum = 0;
  return result;
}

/// The answer where no way leads from one to the other.
Result apart(Point start, Point goal) {
  return failed<Result>(Status::unreachable, Fault::disconnected,
                        "start " + text(start) + " and goal " + text(goal) +
                            " lie in different pieces of free space");
}

Point end_of(const char* what, const std::optional<Point>& asked,
             const std::optional<Point>& written) {
  const auto& point = asked ? asked : written;
  if (!point) refuse(std::string("the world has no ") + what, std::string("give a ") + what);
  if (std::isfinite(point->x) && std::isfinite(point->y)) return *point;
  refuse(std::string("the ") + what + " is (" + number_text(point->x) + ", " +
             number_text(point->y) + ")",
         "give finite coordinates");
}

Result exact(const ShortestPath& shortest, const Observer& observer) {
  Result result;
  end_run(result, shortest.cause, Status::solved);
  result.lower_bound = shortest.lower_bound;
  result.path = shortest.path;
  result.length = shortest.path.empty() ? kNaN : shortest.length;
  result.optimal = !shortest.path.empty();
  if (observer && result.optimal) {
    PlanProgress view;  // the only path that the search finds is the last
    view.path = [&] { return result.path; };
    view.best_length = result.length;
    view.lower_bound = result.lower_bound;
    observer(view);
  }
  return result;
}

/// Precondition: both ends are free, and joined.
Result answer(const Planner::Impl& world, const Place& start, const Place& goal,
              const Request& request, const Params& parameters, const Observer& observer) {
  if (start.given == goal.given) return stay(start.given);
  const auto begin = std::chrono::steady_clock::now();
  const ShortestPath shortest = shortest_path(world.regions, start, goal, request.stop);
  const auto took = std::chrono::steady_clock::now() - begin;
  Result result;
  const auto from = world.enter(start.given), to = world.enter(goal.given);
  if (find_algorithm(parameters.algorithm()).kind == Algorithm::Kind::exact ||
      !joined(world.lined(), from, to)) {
    result = exact(shortest, observer);
  } else {
    result.optimum_time = took;
    result.lower_bound = shortest.lower_bound;
    RoutePlan(world.lined(), {start.given, goal.given}, parameters, request, observer)
        .run(from, to, shortest.lower_bound, result);
    // Lengths are sums of rounded roots: a path may come out a hair below the bound.
    result.lower_bound = std::min(*result.lower_bound, result.length);
    result.optimal = result.length <= *result.lower_bound;
  }
  if (!shortest.path.empty()) result.optimum = shortest.length;
  return result;
}

}  // namespace

Ends ends_of(const Request& request, const World& world) {
  return {end_of("start", request.start, world.start), end_of("goal", request.goal, world.goal)};
}

Result Planner::plan(const Request& request, const Params& parameters,
                     const Observer& observer) const {
  validate(parameters);
  check_target_gap(request.target_gap);
  check_goal_tolerance(request.goal_tolerance);
  const auto [start, goal] = ends_of(request, impl_->world);
  const Regions& regions = impl_->regions;
  const Place from = place_in(regions, start);
  std::optional<Place> to = place_in(regions, goal);
  Result result;
  if (from.regions.empty()) {
    result = impl_->blocked(true, start, *to);
    to.reset();
  } else if (start != goal && !joined(regions, from, *to)) {
    result = to->regions.empty() ? impl_->blocked(false, goal, from) : apart(start, goal);
    to = request.goal_tolerance > 0 ? impl_->instead_of(*to, from, request.goal_tolerance, result)
                                    : std::nullopt;
  }
  if (to) {
    result = answer(*impl_, from, *to, request, parameters, observer);
    if (request.goal_tolerance > 0) result.goal_reached = to->given;
  }
  result.note = impl_->note(result, start, goal);
  return result;
}

struct PlannerParts {
  static const Planner::Impl& of(const Planner& planner) noexcept { return *planner.impl_; }
};

namespace {

class StopsAmongPolygons final : public TourWorld {
 public:
  explicit StopsAmongPolygons(const Planner& planner)
      : planner_(planner), world_(PlannerParts::of(planner)) {}

  bool inside(Point p) const override { return polygon::inside(world_.world.boundary.outer, p); }
  std::vector<std::vector<int>> regions(std::span<const Point> points) const override {
    std::vector<std::vector<int>> pieces(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      for (const int r : place_in(world_.regions, points[i]).regions)
        pieces[i].push_back(world_.regions.piece(r));
    return pieces;
  }
  std::optional<std::vector<double>> distances(std::span<const Point> points, int threads,
                                               const StopCondition& stop) const override {
    std::vector<Place> places;
    for (const Point p : points) places.push_back(place_in(world_.regions, p));
    return lengths_among(world_.regions, places, threads, stop);
  }
  std::vector<Point> leg(Point from, Point to) const override {
    return planner_.plan({.start = from, .goal = to}).path;
  }

 private:
  const Planner& planner_;
  const Planner::Impl& world_;
};

}  // namespace

TourResult plan_tour(const Planner& planner, const TourRequest& request,
                     const TourObserver& observer) {
  check_threads(request.threads);
  for (const Point p : request.points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      refuse("a stop is (" + number_text(p.x) + ", " + number_text(p.y) + ")",
             "give finite coordinates");
  return lasius::plan_tour(StopsAmongPolygons(planner), request, observer);
}

}  // namespace lasius::polygon
