#include "core/tour/map_pricer.h"

#include <algorithm>
#include <cmath>

namespace lasius::tour {

Planner prepared_for(const Planner& planner, int stops, int threads, const StopCondition& stop) {
  constexpr int kPrepared = 30;
  const bool prepares = stops >= kPrepared && planner.robot().radius == 0 &&
                        planner.preparation().state == Preparation::State::none;
  return prepares ? planner.prepared({.threads = threads, .stop = stop}) : planner;
}

bool priced_at_once(const Planner& planner, int stops) {
  constexpr int kAtOnce = 100, kSearchedAtOnce = 1500;
  constexpr std::int64_t kEdgesOfStop = 500;  // that one search looks at
  const Preparation& prepared = planner.preparation();
  return stops <= kAtOnce ||
         (prepared.state == Preparation::State::ready && planner.robot().radius == 0 &&
          stops <= kSearchedAtOnce && prepared.edges <= kEdgesOfStop * stops);
}

Cost grains(double length) noexcept {
  return static_cast<Cost>(std::min<double>(kLargest, std::floor(length * (1 - 1e-9) * kGrains)));
}

MapPricer::MapPricer(const Planner& planner, std::span<const Point> stops,
                     const StopCondition& stop)
    : planner_(planner), stops_(stops), stop_(stop) {
  const Grid& grid = planner.grid();
  dear_ -=
      grains(std::sqrt(1.0 * grid.width() * grid.width() + 1.0 * grid.height() * grid.height()));
}

Cost MapPricer::straight(int a, int b) const noexcept {
  const double dx = stops_[a].x - stops_[b].x, dy = stops_[a].y - stops_[b].y;
  return grains(std::sqrt(dx * dx + dy * dy));
}

Cost MapPricer::lower(int a, int b) const {
  const auto known = kept_.find(key(a, b));
  return known != kept_.end() ? known->second : straight(a, b);
}

Cost MapPricer::price(int a, int b) {
  if (a == b) return 0;
  const auto known = kept_.find(key(a, b));
  if (known != kept_.end()) return known->second;
  stopped_ = stopped_ || stop_.poll() != StopCondition::Cause::none;
  if (stopped_) return dear_ + straight(a, b);
  // From the lower stop: the same length, to the last bit, whoever asks first.
  const Result found = planner_.plan(
      {.stop = stop_, .start_point = stops_[std::min(a, b)], .goal_point = stops_[std::max(a, b)]},
      params_, &workspace_);
  stopped_ = found.status == Status::limit || found.status == Status::interrupted;
  if (stopped_ || found.path.empty()) return dear_ + straight(a, b);
  ++priced_;
  if (kept_.size() == kMostKept) kept_.clear();
  return kept_[key(a, b)] = std::max(straight(a, b), grains(found.length));
}

}  // namespace lasius::tour
