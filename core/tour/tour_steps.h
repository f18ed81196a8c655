// What the plans of all tours have in common, whatever their legs cost.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/tour/order/partial_order.h"
#include "core/tour/order/search.h"
#include "core/tour/routes/routes.h"
#include "core/tour/visited.h"
#include "lasius/tour/tour.h"

namespace lasius {

inline bool by_ants(const TourRequest& request) { return request.ants.algorithm() != "exact"; }

/// Where the stops are.
std::vector<Point> points_of(const TourRequest& request);

constexpr double kOrderShare = 0.6;  ///< of the time to a deadline, for the order
/// A stop condition with this share of the time to its deadline.
StopCondition earlier(StopCondition stop, double share);

/// What only the token ends.
inline StopCondition without_deadline(StopCondition stop) {
  stop.deadline = Clock::time_point::max();
  return stop;
}

/// What is short enough for a target gap, where a bound is known.
std::int64_t target_of(std::int64_t bound, double gap);

/// What is given of the order of some of `all` stops, by their places among these.
tour::PartialOrder given_order(const TourRequest& request, const std::vector<int>& indices,
                               int all);

/// `cause`: what ended the search for the order.
Status status_after(StopCondition::Cause cause, const StopCondition& stop);

/// Of a tour that has no order: why.
void tell_no_order(const tour::PartialOrder& given, const tour::Ends& ends,
                   const tour::OrderFound& found, std::span<const int> named, bool ants,
                   TourResult& tour);

/// The paths of a tour's legs, but those that are there. Never cut short: once there is an order,
/// what stops the search leaves it its legs.
void plan_legs(const Planner& planner, std::span<const Point> points, int threads,
               TourResult& tour);

/// Tells an observer of each tour that is better than those before, until it says stop.
class BestTold {
 public:
  /// `named`: the stops' indices; `scale`: how many of a cost make a length.
  BestTold(const TourObserver& observer, std::span<const int> named, double scale)
      : observer_(observer), named_(named), scale_(scale) {}
  /// Whether to go on. `order`: places, of several robots one after the other.
  bool operator()(std::span<const int> order, std::int64_t cost) {
    if (stopped_ || cost >= least_) return !stopped_;
    least_ = cost;
    std::vector<int> stops;
    for (const int v : order) stops.push_back(named_[v]);
    stopped_ = observer_(stops, static_cast<double>(cost) / scale_) == Go::stop;
    return !stopped_;
  }
  bool stopped() const noexcept { return stopped_; }

 private:
  const TourObserver& observer_;
  std::span<const int> named_;
  double scale_;
  std::int64_t least_ = std::numeric_limits<std::int64_t>::max();
  bool stopped_ = false;
};

struct Ordered {
  tour::OrderFound found;
  std::int64_t bound = 0;
};

/// An order and its bound. `lower`: at most the costs, `costs` themselves where these are proven;
/// `scale` is how many of a cost make a length; `named` the stops' indices.
Ordered order_and_bound(const tour::Costs& costs, const tour::Costs& lower, const tour::Ends& ends,
                        std::span<const Point> places, const tour::PartialOrder& given,
                        const TourRequest& request, double scale, const TourObserver& observer,
                        std::span<const int> named, TourResult& tour, bool symmetric = true);

/// @throws Error(invalid_parameter) for a circle.
void check_circle(int n, const std::vector<tour::Before>& relation);
/// @throws Error(invalid_parameter), as plan_tour.
void check(const TourRequest& request, int n);

/// A tour's stops on a map.
struct TourStops {
  std::vector<Point> points = {};  ///< of all
  std::vector<int> indices = {};   ///< of those to visit; none where there is no tour
  std::vector<Point> places = {};  ///< of these
  tour::Ends ends = {};            ///< likewise
  tour::PartialOrder given = {};   ///< likewise
  tour::RouteProblem routes = {};  ///< of these, where is_routed(request)
  int size() const noexcept { return static_cast<int>(indices.size()); }
  /// Of a stop that is visited. They rise.
  int place_of(int stop) const {
    return static_cast<int>(std::lower_bound(indices.begin(), indices.end(), stop) -
                            indices.begin());
  }
};
/// Where there is none to visit, or an end cannot be, `tour` says why. @throws as check
TourStops stops_of(const StopPlaces& places, const TourRequest& request, TourResult& tour);
TourStops stops_of(const Planner& planner, const TourRequest& request, TourResult& tour);

}  // namespace lasius
