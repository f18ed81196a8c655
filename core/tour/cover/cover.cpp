#include "lasius/tour/cover.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/poller.h"
#include "core/grid/grow_obstacles.h"
#include "core/tour/cover/cover_ground.h"
#include "core/tour/cover/near_ends.h"
#include "core/tour/cover/swath_order.h"
#include "core/tour/cover/swaths.h"
#include "core/tour/map_pricer.h"
#include "core/tour/order/bound.h"
#include "core/tour/route_tour.h"
#include "core/tour/tour_steps.h"
#include "lasius/base/error.h"

namespace lasius {

namespace {

using tour::Cost;
using tour::Costs;
using tour::CoverGround;
using tour::Swath;
using tour::SwathPricer;

constexpr int kMostSwaths = tour::SwathPlan::kMost;
constexpr int kMostLines = 100'000, kMostSamples = 200'000'000;
constexpr int kPrepared = 15;     // swaths for which preparing pays
constexpr int kMostBound = 4000;  // stops, whose ascent takes their square in steps
constexpr int kRounds = 6;        // of the bound: further ones gain little
// Of the time to a deadline.
constexpr double kShareOfSwaths = 0.3, kShareOfPreparing = 0.3, kShareOfOrder = 0.6,
                 kShareOfOrderAlone = 2.0 / 3, kShareOfBound = 0.8;
constexpr int kSoon = 1'500'000;  // cells, of which the first swaths are laid whatever stops

bool stopped(const StopCondition& stop) { return stop.poll() != StopCondition::Cause::none; }

void check(const Grid& grid, double radius, const CoverRequest& request) {
  const int longest = std::max(grid.width(), grid.height());
  const auto refuse = [](const std::string& problem, const std::string& remedy) {
    throw Error(ErrorCode::invalid_parameter, problem, remedy);
  };
  if (!(request.width > 0) || !(request.width <= longest))
    refuse("the width to cover at a time is " + number_text(request.width) + " cells",
           "give more than 0 and at most the map's " + number_text(longest));
  if (std::min(grid.width(), grid.height()) / request.width > kMostSwaths)
    refuse("a width of " + number_text(request.width) + " cells asks for more than " +
               number_text(kMostSwaths) + " swaths",
           "give a larger one, or parts of the map");
  const double lines = longest / request.width;
  const double samples = CoverGround::samples_asked(grid, request.width, radius);
  if (samples > kMostSamples || lines > kMostLines) {
    const bool of_width = CoverGround::samples_asked(grid, request.width, 0) > kMostSamples;
    const std::string width = "a width of " + number_text(request.width) + " cells asks for more ";
    const std::string than = "samples of the map's area than " + number_text(kMostSamples);
    if (of_width || lines > kMostLines)
      refuse(width + (of_width ? than : "lines than " + number_text(kMostLines)),
             "give a larger one, or parts of the map");
    refuse("a radius of " + number_text(radius) +
               " cells, which just fits corridors, asks for more " + than,
           "give one that is no multiple of 0.5, or parts of the map");
  }
  if (request.generations < 0)
    refuse("generations are " + number_text(request.generations), "give 0 or more");
}

// Shares of area, by what swaths and the whole tour come near.
void measure(const CoverGround& ground, const std::vector<Swath>& swaths, CoverResult& result) {
  tour::SwathCounts counts(ground);
  for (const Swath& swath : swaths) counts.add(swath);
  const std::int64_t swept = counts.covered(), twice = counts.covered(2);
  for (const TourLeg& leg : result.tour.legs)
    for (std::size_t i = 1; i < leg.path.size(); ++i) counts.add({leg.path[i - 1], leg.path[i]});
  const auto share = [](std::int64_t part, std::int64_t of) {
    return of > 0 ? static_cast<double>(part) / static_cast<double>(of) : 0;
  };
  result.covered = share(counts.covered(), ground.wanted_samples());
  result.overlap = share(twice, swept);
}

CoverResult without_path(CoverResult result, const TourLeg& leg) {
  const Point from = result.stops[leg.from], to = result.stops[leg.to];
  TourResult none;
  none.status = Status::no_path;
  none.error = "no path was found from the end of a swath at " + pair_text(from.x, from.y) +
               " to " + pair_text(to.x, to.y);
  result.tour = std::move(none);
  result.stops.clear();
  return result;
}

// By chains over clear cells. From the start; of an open tour without it from any swath's end.
std::vector<int> order_by_chains(const std::vector<tour::EndLink>& links, const CoverResult& result,
                                 const std::optional<Point>& start) {
  std::vector<int> order = tour::chained(result.swaths(), result.stops, links).order;
  if (start)
    std::rotate(order.begin(), std::find(order.begin(), order.end(), 2 * result.swaths()),
                order.end());
  return order;
}

// Legs are planned before the bound, which alone needs no more than the time that is left.
// `between`: a bound of the legs between swaths.
void join_swaths(const Planner& planner, const CoverRequest& request, double between,
                 const std::vector<tour::EndLink>& links, CoverResult& result,
                 const TourObserver& observer) {
  const int swaths = result.swaths(), n = static_cast<int>(result.stops.size());
  TourResult& found = result.tour;
  const StopCondition ordering =
      earlier(request.stop, n <= kMostBound ? kShareOfOrder : kShareOfOrderAlone);
  tour::MapPricer legs(planner, result.stops, ordering, SwathPricer::kApart);
  std::vector<Cost> matrix;
  if (tour::priced_at_once(planner, n))
    if (const auto lengths =
            planner.distances(result.stops, result.stops, request.threads, ordering))
      for (const double length : *lengths) matrix.push_back(tour::grains(length));
  const bool known = !matrix.empty();
  if (!known && !stopped(request.stop)) legs.price_near(request.threads);
  SwathPricer pricer(swaths, known ? Costs(n, matrix.data()) : Costs(n, legs));
  std::vector<Cost> all;
  for (int a = 0; known && a < n; ++a)
    for (int b = 0; b < n; ++b) all.push_back(pricer.lower(a, b));
  const Costs costs = known ? Costs(n, all.data()) : Costs(n, pricer);
  const tour::Ends ends{request.open, request.start ? n - 1 : -1, -1};
  const std::int64_t apart = std::int64_t{n - swaths - request.open} * SwathPricer::kApart;
  const auto cells = [&](std::int64_t cost) {
    return result.swept +
           static_cast<double>(std::max<std::int64_t>(0, cost - apart)) / tour::kGrains;
  };
  tour::OrderOptions options{.seed = request.seed,
                             .generations = request.generations,
                             .first = order_by_chains(links, result, request.start),
                             .stop = ordering};
  bool told_to_stop = false;
  if (observer)
    options.observer = [&](std::span<const int> order, std::int64_t cost) {
      told_to_stop = observer(order, cells(cost)) == Go::stop;
      return !told_to_stop;
    };
  const tour::OrderFound order = find_order(costs, ends, result.stops, options);
  found.order = whole_swaths(order.order, pricer, request.open);
  add_legs(found.order, request.open, found);
  for (TourLeg& leg : found.legs) {
    const Point from = result.stops[leg.from], to = result.stops[leg.to];
    if (!pricer.joined(leg.from, leg.to) || from == to) continue;
    leg.path = {from, to};  // a swath
    leg.length = distance(from, to);
  }
  plan_legs(planner, result.stops, request.threads, found);
  if (known && order.optimal) {
    found.lower_bound = cells(order.cost);
  } else {
    found.lower_bound = (result.swept + between) * (1 - 1e-9);  // their roundings
    const StopCondition bounding = earlier(request.stop, kShareOfBound);
    Poller poller(bounding);
    legs.price_until(bounding);
    const std::int64_t alike = apart - static_cast<std::int64_t>(result.swept * tour::kGrains);
    if (n <= kMostBound && !stopped(request.stop))
      found.lower_bound = std::max(
          *found.lower_bound,
          cells(tour_bound(costs, ends, result.stops, order.cost, kRounds, poller, alike)));
  }
  found.priced = known ? std::int64_t{n} * (n - 1) / 2 - swaths : legs.priced();
  found.status = told_to_stop ? Status::interrupted : status_after(order.cause, request.stop);
}

}  // namespace

CoverResult plan_cover(const Planner& unprepared, const CoverRequest& request,
                       const TourObserver& observer) {
  check(unprepared.grid(), unprepared.robot().radius, request);
  CoverResult result;
  TourResult& found = result.tour;
  if (request.start && !unprepared.clear_at(*request.start)) {
    found.status = Status::invalid;
    found.error =
        "the start at " + pair_text(request.start->x, request.start->y) + " is outside or blocked";
    return result;
  }
  found.status = Status::interrupted;
  const Grid& grid = unprepared.grid();
  const bool soon = std::int64_t{grid.width()} * grid.height() <= kSoon;
  const StopCondition first = soon ? StopCondition{} : without_deadline(request.stop);
  const tour::ToolLines lines(grid, unprepared.robot().radius);
  const auto ground = CoverGround::make(unprepared, lines, request.width, request.start, first);
  if (!ground) return result;
  result.resolution = ground->spacing();
  if (ground->free_samples() > 0)
    result.unreachable = 1 - static_cast<double>(ground->wanted_samples()) /
                                 static_cast<double>(ground->free_samples());
  const double radius = lines.radius();
  const auto clear =
      radius == 0 ? grid : grow_obstacles(grid, Growth(grid, radius, ClearanceOf::centres), first);
  if (!clear) return result;
  std::optional<tour::SwathPlan> plan;
  if (ground->place()) {
    plan = tour::SwathMaker(unprepared, *clear, lines, *ground)
               .best(request.threads, first, earlier(request.stop, kShareOfSwaths));
    // Another heading's may be fewer, or any at all.
    if (!plan || (plan->cut && (plan->swaths.empty() || plan->too_many()))) {
      if (!request.stop.token.stop_requested()) found.status = Status::limit;
      return result;
    }
  }
  if (!plan || plan->swaths.empty()) {
    found.status = Status::invalid;
    found.error = request.start             ? "the tool cannot move from where the start is"
                  : clear->count_free() > 0 ? "the tool has no place on the map that it can move in"
                                            : "the tool has no place on the map";
    return result;
  }
  result.angle = plan->heading.degrees;
  if (plan->too_many())
    throw Error(ErrorCode::invalid_parameter,
                "a width of " + number_text(request.width) + " cells asks for " +
                    number_text(static_cast<int>(plan->swaths.size())) + " swaths, more than " +
                    number_text(kMostSwaths),
                "give a larger one, or parts of the map");
  for (const Swath& swath : plan->swaths) {
    result.stops.push_back(swath.from);
    result.stops.push_back(swath.to);
    result.swept += swath.length();
  }
  if (request.start) result.stops.push_back(*request.start);
  // A disc's graph too: most legs are short, and found in it at once.
  const bool prepares =
      result.swaths() >= kPrepared && unprepared.preparation().state == Preparation::State::none;
  const Planner planner =
      prepares ? unprepared.prepared(
                     {.threads = request.threads, .stop = earlier(request.stop, kShareOfPreparing)})
               : unprepared;
  std::vector<Swath> ways = plan->swaths;  // the start is one of no length
  if (request.start) ways.push_back({*request.start, *request.start});
  if (request.start || plan->links.empty()) plan->links = near_ends(*clear, lines, result.stops);
  join_swaths(planner, request, ways_between(ways, request.open), plan->links, result, observer);
  if (plan->cut && found.status == Status::solved) found.status = Status::limit;
  for (const TourLeg& leg : found.legs)
    if (leg.path.empty()) return without_path(std::move(result), leg);
  sum_up(found);
  // The way back along a single swath is no leg that the order pays for.
  if (found.order.size() == 2 && !request.open) found.lower_bound = 2 * result.swept;
  if (found.lower_bound) found.lower_bound = std::min(found.length, *found.lower_bound);
  settle_optimal(found);
  measure(*ground, plan->swaths, result);
  return result;
}

}  // namespace lasius
