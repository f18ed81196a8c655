#include "lasius/vehicle/tour.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/processor_time.h"
#include "core/tour/order/search.h"
#include "core/tour/route_tour.h"
#include "core/tour/routes/find_routes.h"
#include "core/vehicle/bound.h"
#include "core/vehicle/sweep.h"
#include "core/vehicle/tour/leg_prices.h"
#include "core/vehicle/tour/unjoined.h"

namespace lasius::vehicle {

namespace {

using tour::RoutesFound;

constexpr std::size_t kMostPoses = 2000;
constexpr int kIdle = 10;   // searches for an order without a shorter tour, where it is not proven
constexpr int kEffort = 5;  // the share of generations that each such search has
constexpr std::chrono::duration<double> kSoon{0.8};      // of the processor, after a signal
constexpr int kManyStates = 50'000, kFewStates = 4'000;  // of a leg, until then and later
constexpr double kSpacing = 0.5;                         // cells, of a leg's path
constexpr std::string_view kNoWay = "no way was found between it and the others";

std::optional<double> yaw_of(const TourRequest& request, int stop) {
  return request.yaws.empty() ? std::nullopt : request.yaws[static_cast<std::size_t>(stop)];
}

void check_tour(const TourRequest& request, int n) {
  check(request, n);
  if (!request.after.empty() || !request.load.empty() || request.capacity || by_ants(request))
    throw invalid_parameter("tours of vehicles have no order given in part, and no ants",
                            "leave after, load, capacity and the algorithm out");
  if (!request.yaws.empty() && request.yaws.size() != static_cast<std::size_t>(n))
    throw invalid_parameter("yaws has " + number_text(request.yaws.size()) + " entries",
                            "give one a stop, " + number_text(n));
  for (const auto& yaw : request.yaws)
    require_parameter(!yaw || std::fabs(*yaw) <= 1e5, "a yaw", yaw.value_or(0),
                      "give radians, at most 100000");
  tour::check_ends(n, {request.open, request.start.value_or(-1), request.goal.value_or(-1)});
  for (const int end : ends_of(request))
    if (end < 0 || !yaw_of(request, end))
      throw invalid_parameter("stop " + number_text(end) + ", an end of the tour, has no yaw",
                              "say where the vehicle looks there");
}

std::vector<Pose> free_poses(const Planner& planner, Point at, std::optional<double> yaw) {
  std::vector<Pose> poses;
  for (int i = 0; i < (yaw ? 1 : kTourHeadings); ++i) {
    const Pose pose{at.x, at.y, yaw.value_or(i * 2 * std::numbers::pi / kTourHeadings)};
    if (planner.space().free(pose)) poses.push_back(pose);
  }
  return poses;
}

/// Stops are of one region where the disc in the footprint gets from one to the other.
/// Once stopped, all further ones.
StopPlaces places_of(const Planner& planner, std::span<const Point> points,
                     const std::vector<std::vector<Pose>>& poses, const StopCondition& stop) {
  StopPlaces places{std::vector<std::vector<int>>(points.size()), {}};
  std::vector<Pose> regions;
  const Space::Impl& map = planner.space().impl();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    places.outside.push_back(!(p.x >= 0 && p.x <= map.width() && p.y >= 0 && p.y <= map.height()));
    if (poses[i].empty()) continue;
    const Pose& pose = poses[i].front();
    const auto found = std::find_if(regions.begin(), regions.end(), [&](const Pose& other) {
      return !planner.cut_off({.start = other, .goals = {pose}, .stop = stop});
    });
    places.regions[i] = {static_cast<int>(found - regions.begin())};
    if (found == regions.end()) regions.push_back(pose);
  }
  return places;
}

class TourSearch {
 public:
  TourSearch(const Planner& planner, const TourRequest& request, const TourObserver& observer,
             TourStops stops, const std::vector<std::vector<Pose>>& poses, TourResult& tour)
      : planner_(planner),
        request_(request),
        observer_(observer),
        stops_(std::move(stops)),
        tour_(tour),
        legs_(planner, poses_of(stops_, poses), request.threads, request.stop) {
    std::vector<std::vector<int>>& at = places_.at;
    at.resize(stops_.indices.size());
    for (int a = 0; a < legs_.costs().size(); ++a) at[legs_.at(a).place].push_back(a);
    for (int place = 0; place < stops_.size(); ++place) {
      places_.end.push_back(is_end(place) ? 1 : 0);
      for (const int side : {0, 1})
        places_.needs_leg[side].push_back(needs_leg(place, side) ? 1 : 0);
    }
    problem_ = stops_.routes;
    for (std::vector<int>& task : problem_.tasks) {
      std::vector<int> all;
      for (const int place : task) all.insert(all.end(), at[place].begin(), at[place].end());
      task = std::move(all);
    }
    for (tour::Ends& ends : problem_.routes)
      for (int* const end : {&ends.start, &ends.goal})
        if (*end >= 0) *end = at[*end].front();
    to_bound_ = problem_;
  }

  void run() {
    const StopCondition patient = without_deadline(request_.stop);
    bool at_hand = true;  // what order there is when time is up will do
    for (int idle = 0; idle < kIdle;) {
      const StopCondition& stop = best_.empty() ? patient : request_.stop;  // a tour, however late
      const RoutesFound found =
          find_routes(problem_, legs_.costs(),
                      {.seed = request_.seed,
                       .generations = (request_.generations + kEffort - 1) / kEffort,
                       .stop = at_hand ? request_.stop : stop});
      const std::vector<PosePair> order = legs_of(found.orders);
      if (!best_.empty() && found.cost >= best_cost_ && found.optimal) break;
      const std::vector<PosePair> missing = legs_.unknown(order);
      price(missing, stop);
      const bool better = legs_.unknown(order).empty() && offer(found.orders, order);
      if (better && !tell()) break;
      cause_ = request_.stop.poll();
      if (legs_.unknown(order).empty()) keep_tried(found.orders, order);
      if (cause_ == StopCondition::Cause::token && best_.empty())
        join_soon(tried_.empty() ? found.orders : tried_);
      if (cause_ == StopCondition::Cause::token) break;
      if (cause_ != StopCondition::Cause::none && !best_.empty()) break;
      const bool in_vain = missing.empty() && best_.empty();
      if (in_vain && at_hand && cause_ != StopCondition::Cause::none) {
        at_hand = false;
        continue;
      }
      const Unjoined lost = unjoined(legs_, places_, in_vain ? order : std::vector<PosePair>{});
      if (lost.place < 0 && missing.empty()) break;
      if (!lost.untried.empty())
        price(lost.untried, stop);
      else if (lost.place >= 0 && !leave_out(lost.place))
        return;
      idle = better || lost.place >= 0 || found.optimal || best_.empty() ? 0 : idle + 1;
    }
    conclude();
  }

 private:
  static std::vector<TourPose> poses_of(const TourStops& stops,
                                        const std::vector<std::vector<Pose>>& poses) {
    std::vector<TourPose> all;
    for (int place = 0; place < stops.size(); ++place)
      for (const Pose& pose : poses[static_cast<std::size_t>(stops.indices[place])])
        all.push_back({pose, place});
    return all;
  }

  void price(const std::vector<PosePair>& legs, const StopCondition& stop, int hasty_states = 0) {
    legs_.price(legs, request_.threads, stop, hasty_states);
    tour_.priced += static_cast<std::int64_t>(legs.size());
  }

  // Of orders all of whose legs were planned, that with the fewest that have no way.
  void keep_tried(const std::vector<std::vector<int>>& orders, const std::vector<PosePair>& legs) {
    const auto lost = std::count_if(legs.begin(), legs.end(),
                                    [&](const PosePair& leg) { return !legs_.has_way(leg); });
    if (!tried_.empty() && lost >= lost_) return;
    tried_ = orders;
    lost_ = lost;
  }

  // A signal leaves the order at hand its legs, where these are soon planned, without stops to
  // which, or from which, there is none.
  void join_soon(std::vector<std::vector<int>> orders) {
    const ProcessorTime processor;
    const TimeSource* const time = request_.stop.time ? request_.stop.time : &processor;
    const StopCondition soon{.deadline = deadline_in(kSoon, time->now()), .time = time};
    for (;;) {
      const std::vector<PosePair> legs = legs_of(orders);
      price(legs_.unknown(legs), soon, kManyStates);
      price(legs_.unknown(legs), {}, kFewStates);
      if (offer(orders, legs)) return;
      std::vector<PosePair> lost = legs;
      std::erase_if(lost, [&](const PosePair& leg) { return legs_.has_way(leg); });
      while (!lost.empty()) {
        const int pose = most_lost(legs_, places_, lost);
        if (pose < 0 || !leave_out_task(pose)) return;
        for (std::vector<int>& order : orders) std::erase(order, pose);
        std::erase_if(lost,
                      [&](const PosePair& leg) { return leg.first == pose || leg.second == pose; });
      }
    }
  }
  bool leave_out_task(int pose) {
    const int place = legs_.at(pose).place;
    for (std::size_t i = 0; problem_.size() > 1 && i < problem_.tasks.size(); ++i)
      if (std::count(problem_.tasks[i].begin(), problem_.tasks[i].end(), pose) > 0) {
        take_out(i, place, "no way was found in time to it, or from it");
        return true;
      }
    return false;
  }

  std::vector<PosePair> legs_of(const std::vector<std::vector<int>>& orders) const {
    return tour::legs_of(orders, request_.open);
  }

  // Takes orders all of whose legs are known, if they have ways and are cheaper.
  bool offer(const std::vector<std::vector<int>>& orders, const std::vector<PosePair>& legs) {
    std::int64_t cost = 0;
    for (const PosePair& leg : legs) {
      if (!legs_.has_way(leg)) return false;
      cost += legs_.costs()(leg.first, leg.second);
    }
    if (!best_.empty() && cost >= best_cost_) return false;
    best_ = orders;
    best_cost_ = cost;
    return true;
  }

  // False where the observer or the gap ends the search.
  bool tell() {
    if (observer_) {
      std::vector<int> told;
      for (const auto& order : best_)
        for (const int a : order) told.push_back(stops_.indices[legs_.at(a).place]);
      const double length = static_cast<double>(best_cost_) / legs_.scale();
      if (observer_(told, length) == Go::stop) {
        cause_ = StopCondition::Cause::token;
        return false;
      }
    }
    return request_.target_gap <= 0 || length() > bound() * (1 + request_.target_gap);
  }

  // Whether each tour over this place has a leg away from it (side 0), or to it.
  bool needs_leg(int place, int side) const {
    if (!request_.robots.empty() && is_end(place)) return false;  // a robot may stay there
    if (!request_.open) return true;
    const int stop = stops_.indices[place];
    if (side == 0) return request_.goal && request_.goal != stop;
    return !request_.robots.empty() || (request_.start && request_.start != stop);
  }
  bool is_end(int place) const {
    const std::vector<int> ends = ends_of(request_);
    return std::count(ends.begin(), ends.end(), stops_.indices[place]) > 0;
  }

  // False where the tour cannot be without it. Tasks that are done elsewhere keep it in the bound:
  // that no way was found proves nothing.
  bool leave_out(int place) {
    const auto here = [&](int a) { return legs_.at(a).place == place; };
    places_.left_out.insert(place);
    bound_.reset();
    for (const auto& order : best_)
      if (std::any_of(order.begin(), order.end(), here)) {
        best_.clear();
        break;
      }
    for (std::vector<int>& order : tried_) std::erase_if(order, here);
    if (is_end(place)) {
      tell_left_out(place, -1, kNoWay);
      tour_.status = Status::no_path;
      tour_.error = tour_.left_out.back().why;
    }
    for (std::size_t i = 0; i < problem_.tasks.size(); ++i) {
      std::erase_if(problem_.tasks[i], here);
      if (!problem_.tasks[i].empty()) continue;
      take_out(i, place, kNoWay);
      break;
    }
    return tour_.error.empty();
  }
  void take_out(std::size_t task, int place, std::string_view why) {
    tell_left_out(place, request_.group.empty() ? -1 : request_.group[stops_.indices[place]], why);
    const auto at = static_cast<std::ptrdiff_t>(task);
    problem_.tasks.erase(problem_.tasks.begin() + at);
    to_bound_.tasks.erase(to_bound_.tasks.begin() + at);
    std::sort(tour_.left_out.begin(), tour_.left_out.end(),
              [](const LeftOut& a, const LeftOut& b) { return a.stop < b.stop; });
  }
  void tell_left_out(int place, int group, std::string_view why) {
    const std::vector<int>& groups = request_.group;
    const bool of_group = group >= 0 && std::count(groups.begin(), groups.end(), group) > 1;
    LeftOut out{stops_.indices[place], {}};
    if (of_group)  // its first stop stands for it
      out.stop = static_cast<int>(std::find(groups.begin(), groups.end(), group) - groups.begin());
    const Point at = stops_.points[out.stop];
    out.why = "stop " + number_text(out.stop) + " at " + pair_text(at.x, at.y) + ": ";
    out.why += why;
    if (of_group) tell_of_group(out, group);
    tour_.left_out.push_back(std::move(out));
  }

  double bound() {
    if (!bound_) {
      Poller poller(request_.stop);
      bound_ = legs_.lower_bound(to_bound_, request_.open, length(), poller);
    }
    return *bound_;
  }
  // Of the best; over costs what it costs.
  double length() const {
    double sum = 0;
    for (const PosePair& leg : legs_of(best_)) sum += LegPrices::value(legs_.plan(leg));
    return sum;
  }

  void conclude() {
    tour_.status = status_after(cause_, request_.stop);
    if (best_.empty()) {
      if (tour_.status == Status::solved) tour_.status = Status::no_path;
      tour_.error = "no tour was found all of whose legs have plans";
      return;
    }
    Orders places;
    for (const std::vector<int>& order : best_) {
      std::vector<int>& told = places.orders.emplace_back();
      for (const int a : order) {
        told.push_back(legs_.at(a).place);
        tour_.poses.push_back(legs_.at(a).pose);
      }
    }
    set_orders(request_, stops_, places, tour_);
    const std::vector<PosePair> legs = legs_of(best_);
    for (std::size_t i = 0; i < legs.size(); ++i) {
      const Result& plan = tour_.plans.emplace_back(legs_.plan(legs[i]));
      TourLeg& leg = tour_.legs[i];
      leg.length = plan.length;
      leg.cost = plan.cost;
      for (const PathPose& along : vehicle::poses(plan.segments, kSpacing))
        leg.path.push_back({along.pose.x, along.pose.y});
    }
    if (planner_.over_costs()) tour_.cost = 0;
    sum_up(tour_);
    const double sum = tour_.cost.value_or(tour_.length);
    tour_.lower_bound = Bound::told(bound(), sum, tour_.cost.has_value());
    if (tour_.lower_bound && *tour_.lower_bound <= 0 && sum > 0) tour_.lower_bound.reset();
    settle_optimal(tour_);
  }

  const Planner& planner_;
  const TourRequest& request_;
  const TourObserver& observer_;
  TourStops stops_;
  TourResult& tour_;
  LegPrices legs_;
  TourPlaces places_;
  tour::RouteProblem problem_;   // over poses
  tour::RouteProblem to_bound_;  // the same tasks, with all their poses
  std::vector<std::vector<int>> best_, tried_;
  std::ptrdiff_t lost_ = 0;  // legs of tried_
  std::int64_t best_cost_ = 0;
  std::optional<double> bound_;
  StopCondition::Cause cause_ = StopCondition::Cause::none;
};

}  // namespace

TourResult plan_tour(const Planner& planner, const TourRequest& request,
                     const TourObserver& observer) {
  TourResult tour;
  const bool stopped = request.stop.token.stop_requested();
  const std::vector<Point> points = points_of(request);
  check_tour(request, static_cast<int>(points.size()));
  std::vector<std::vector<Pose>> poses;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    poses.push_back(free_poses(planner, points[i], yaw_of(request, static_cast<int>(i))));
    count += poses.back().size();
  }
  if (count > kMostPoses)
    throw invalid_parameter(number_text(count) + " poses are too many for a tour",
                            "give at most " + number_text(kMostPoses) +
                                "; a stop without a yaw has " + number_text(kTourHeadings));
  TourStops stops = stops_of(places_of(planner, points, poses, request.stop), request, tour);
  if (stops.size() > 0 && !is_routed(request)) add_routes(request, stops, tour);
  if (stops.size() == 0) return tour;
  tour.status = Status::interrupted;
  if (stopped) return tour;
  TourSearch(planner, request, observer, std::move(stops), poses, tour).run();
  return tour;
}

}  // namespace lasius::vehicle
