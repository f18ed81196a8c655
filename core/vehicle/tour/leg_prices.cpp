#include "core/vehicle/tour/leg_prices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "core/tour/map_pricer.h"
#include "core/tour/routes/exact_routes.h"
#include "core/tour/routes/route_bound.h"
#include "core/vehicle/bound.h"

namespace lasius::vehicle {

namespace {

constexpr tour::Cost kDead = tour::kLargest / 2;  // where no plan was found
constexpr tour::Cost kDearest = kDead / 8;        // of others, by far
constexpr double kHasty = 3;                      // weight of the estimate

}  // namespace

LegPrices::LegPrices(const Planner& planner, std::vector<TourPose> poses, int threads,
                     const StopCondition& stop)
    : planner_(planner), poses_(std::move(poses)) {
  const int n = size();
  std::vector<int> first;  // pose of each place
  for (int a = 0; a < n; ++a)
    if (a == 0 || at(a).place != at(a - 1).place) first.push_back(a);
  const int places = static_cast<int>(first.size());
  first.push_back(n);
  bounds_.assign(poses_.size() * poses_.size(), 0);
  std::vector<PosePair> pairs;
  for (int v = 0; v < places; ++v)
    for (int w = v + 1; w < places; ++w) pairs.emplace_back(v, w);
  parallel_for(static_cast<int>(pairs.size()), thread_count(threads), [&](int i, int) {
    const auto [v, w] = pairs[i];
    const StopCondition::Cause cause = stop.poll();
    const bool soon = cause == StopCondition::Cause::token;  // of any heading, then
    const double around = planner_.lower_bound({.start = at(first[v]).pose,
                                                .goals = {at(first[w]).pose},
                                                .heading_tolerance = std::numbers::pi,
                                                .stop = stop},
                                               cause == StopCondition::Cause::none);
    for (int a = first[v]; a < first[v + 1]; ++a)
      for (int b = first[w]; b < first[w + 1]; ++b)
        for (const PosePair& leg : {PosePair{a, b}, PosePair{b, a}})
          bounds_[index(leg)] =
              soon ? around
                   : std::max(around, planner_.lower_bound({.start = at(leg.first).pose,
                                                            .goals = {at(leg.second).pose}},
                                                           false));
  });
  constexpr tour::Cost kLongest = kDearest / 8;  // so that detours are below kDearest, too
  double most = 1;
  for (const double bound : bounds_) most = std::max(most, bound);
  scale_ = std::min(tour::kGrains, kLongest / most);
  costs_.reserve(bounds_.size());
  for (const double bound : bounds_) costs_.push_back(tour::grains(bound, scale_));
}

double LegPrices::lower_bound(const tour::RouteProblem& problem, bool open, double upper,
                              Poller& poller) const {
  constexpr double kRounding = 1e-13;  // of a sum of so few
  if (const auto orders = tour::exact_routes(problem, size(), bounds_, poller)) {
    double least = 0;
    for (const PosePair& leg : tour::legs_of(*orders, open)) least += bounds_[index(leg)];
    return least * (1 - kRounding);
  }
  const double scale = tour::scale_of(bounds_);
  std::vector<tour::Cost> either_way;
  either_way.reserve(bounds_.size());
  for (int a = 0; a < size(); ++a)
    for (int b = 0; b < size(); ++b)
      either_way.push_back(
          tour::grains(std::min(bounds_[index({a, b})], bounds_[index({b, a})]), scale));
  const auto most = static_cast<std::int64_t>(std::ceil(upper * scale));
  const std::int64_t least = tour::routes_bound(problem, {size(), either_way.data()}, most, poller);
  return static_cast<double>(least) / scale;
}

void LegPrices::price(std::span<const PosePair> legs, int threads, const StopCondition& stop,
                      int hasty_states) {
  const bool soon = hasty_states > 0;
  std::vector<Result> found(legs.size());
  parallel_for(static_cast<int>(legs.size()), thread_count(threads), [&](int i, int) {
    Request request{.start = at(legs[i].first).pose,
                    .goals = {at(legs[i].second).pose},
                    .smooth = !soon,
                    .bound = false,
                    .stop = stop};
    if (soon) {
      request.weight = kHasty;
      request.max_states = hasty_states;
    }
    found[i] = planner_.plan(request);
  });
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const PosePair& leg = legs[i];
    Result& plan = found[i];
    const bool stopped = plan.status == Status::limit || plan.status == Status::interrupted;
    const bool signalled = soon || plan.status == Status::interrupted;
    if (stopped && (plan.segments.empty() || !signalled)) continue;
    if (plan.segments.empty()) {
      costs_[index(leg)] = kDead;
    } else {
      costs_[index(leg)] = std::min(kDearest, tour::grains(value(plan), scale_));
      plan.lower_bound = Bound::told(bounds_[index(leg)], value(plan), plan.over_costs);
    }
    plans_.emplace(leg, std::move(plan));
  }
}

}  // namespace lasius::vehicle
