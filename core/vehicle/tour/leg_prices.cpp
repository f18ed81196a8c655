#include "core/vehicle/tour/leg_prices.h"

#include <algorithm>
#include <numbers>

#include "core/base/parallel.h"
#include "core/tour/map_pricer.h"
#include "core/vehicle/bound.h"

namespace lasius::vehicle {

namespace {

constexpr tour::Cost kDead = tour::kLargest / 2;  // where no plan was found
constexpr tour::Cost kDearest = kDead / 8;        // of others, by far

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
  lower_.reserve(bounds_.size());
  for (const double bound : bounds_) lower_.push_back(tour::grains(bound, scale_));
  costs_ = lower_;
}

std::vector<tour::Cost> LegPrices::lower_both_ways() const {
  std::vector<tour::Cost> both = lower_;
  for (int a = 0; a < size(); ++a)
    for (int b = 0; b < size(); ++b)
      both[index({a, b})] = std::min(lower_[index({a, b})], lower_[index({b, a})]);
  return both;
}

void LegPrices::price(std::span<const PosePair> legs, int threads, const StopCondition& stop) {
  std::vector<Result> found(legs.size());
  parallel_for(static_cast<int>(legs.size()), thread_count(threads), [&](int i, int) {
    found[i] = planner_.plan({.start = at(legs[i].first).pose,
                              .goals = {at(legs[i].second).pose},
                              .bound = false,
                              .stop = stop});
  });
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const PosePair& leg = legs[i];
    Result& plan = found[i];
    if (plan.status == Status::limit || plan.status == Status::interrupted) continue;
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
