#include "core/tour/map_pricer.h"

#include <cmath>
#include <cstdlib>

#include "core/plan/lengths_near.h"

namespace lasius::tour {

Planner prepared_for(const Planner& planner, int stops, int threads, const StopCondition& stop) {
  constexpr int kPrepared = 30;
  const bool prepares = stops >= kPrepared && planner.robot().radius == 0 &&
                        planner.preparation().state == Preparation::State::none;
  return prepares ? planner.prepared({.threads = threads, .stop = stop}) : planner;
}

bool priced_at_once(const Planner& planner, int stops) {
  constexpr int kAtOnce = 100, kSearchedAtOnce = 1500;
  constexpr std::int64_t kVertices = 30'000;  // that one search reaches soon
  const Preparation& prepared = planner.preparation();
  return stops <= kAtOnce ||
         (prepared.state == Preparation::State::ready && planner.robot().radius == 0 &&
          stops <= kSearchedAtOnce && prepared.vertices <= kVertices);
}

Cost grains(double length, double scale) noexcept {
  return static_cast<Cost>(std::min<double>(kLargest, std::floor(length * (1 - 1e-9) * scale)));
}

double scale_of(std::span<const double> lengths) {
  double most = 0;
  for (const double length : lengths) most = std::max(most, length);
  if (most == 0) return 1;
  int exponent = 0;
  std::frexp(0.5 * kLargest / most, &exponent);
  return std::ldexp(1, exponent - 1);
}

MapPricer::MapPricer(const Planner& planner, std::span<const Point> stops,
                     const StopCondition& stop, Cost largest)
    : planner_(planner), stops_(stops), largest_(largest), stop_(stop) {
  const double width = planner.grid().width(), height = planner.grid().height();
  dear_ = largest - grains(std::sqrt(width * width + height * height));
  if (stops.size() <= kMostInMatrix) matrix_.assign(stops.size() * stops.size(), kNone);
}

Cost MapPricer::straight(int a, int b) const noexcept {
  const double dx = stops_[a].x - stops_[b].x, dy = stops_[a].y - stops_[b].y;
  return grains(std::sqrt(dx * dx + dy * dy));
}

Cost MapPricer::bound(int a, int b) const noexcept {
  constexpr Cost kRounded = 2;  // of a difference of two lengths
  Cost most = straight(a, b);
  if (beyond_.empty()) return most;
  most = std::max({most, beyond_[a], beyond_[b]});
  const Cost* const to_a = to_landmark_.data() + std::ptrdiff_t{kLandmarks} * a;
  const Cost* const to_b = to_landmark_.data() + std::ptrdiff_t{kLandmarks} * b;
  for (int i = 0; i < kLandmarks; ++i)
    most = std::max(most, std::abs(to_a[i] - to_b[i]) - kRounded);
  return most;
}

const Cost* MapPricer::known(int a, int b) const {
  if (!matrix_.empty()) {
    const Cost& cost = matrix_[a * stops_.size() + b];
    return cost != kNone ? &cost : nullptr;
  }
  const auto at = kept_.find(key(a, b));
  return at != kept_.end() ? &at->second : nullptr;
}

void MapPricer::set_known(int a, int b, Cost cost) {
  ++priced_;
  if (!matrix_.empty()) {
    matrix_[a * stops_.size() + b] = matrix_[b * stops_.size() + a] = cost;
    return;
  }
  if (kept_.size() == kMostKept) kept_.clear();
  kept_[key(a, b)] = cost;
}

void MapPricer::price_near(int threads) {
  const int n = static_cast<int>(stops_.size());
  if (matrix_.empty() || n <= kLandmarks) return;
  // As many as a search of about so many vertices comes to.
  constexpr std::int64_t kVertices = 15'000;
  const std::int64_t all_vertices = std::max<std::int64_t>(1, planner_.preparation().vertices);
  const auto near =
      static_cast<int>(std::clamp<std::int64_t>(n * kVertices / all_vertices, kNear, kMostNear));
  std::vector<int> nearest(stops_.size(), near);
  std::vector<int> landmarks{0};  // each far from those before it
  std::vector<Cost> away(stops_.size(), kLargest);
  while (static_cast<int>(landmarks.size()) < kLandmarks) {
    for (int v = 0; v < n; ++v) away[v] = std::min(away[v], straight(landmarks.back(), v));
    landmarks.push_back(
        static_cast<int>(std::max_element(away.begin(), away.end()) - away.begin()));
  }
  for (const int landmark : landmarks) nearest[landmark] = n;
  std::vector<Cost> beyond(stops_.size(), 0);
  const auto take = [&](int from, std::span<const double> lengths, double reach) {
    beyond[from] = std::isinf(reach) ? 0 : grains(reach);
    Cost* const row = matrix_.data() + static_cast<std::size_t>(from) * n;
    for (int to = 0; to < n; ++to)
      if (to != from && !std::isinf(lengths[to])) row[to] = cost_of(from, to, lengths[to]);
  };
  const bool all = lengths_near(planner_, stops_, nearest, threads, stop_, take);
  stopped_ = !all && stop_.poll() != StopCondition::Cause::none;
  // The same, to the last bit, from whichever end it was found: that of the lower stop counts.
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b) {
      Cost& one = matrix_[static_cast<std::size_t>(a) * n + b];
      Cost& other = matrix_[static_cast<std::size_t>(b) * n + a];
      one = other = one != kNone ? one : other;
      priced_ += one != kNone;
    }
  if (!all) return;
  beyond_ = std::move(beyond);
  to_landmark_.assign(stops_.size() * kLandmarks, 0);
  for (int v = 0; v < n; ++v)
    for (int i = 0; i < kLandmarks; ++i)
      if (v != landmarks[i]) to_landmark_[v * kLandmarks + i] = *known(v, landmarks[i]);
}

Cost MapPricer::lower(int a, int b) const {
  if (a == b) return 0;
  const Cost* const cost = known(a, b);
  return cost != nullptr ? *cost : bound(a, b);
}

Cost MapPricer::price(int a, int b) {
  if (a == b) return 0;
  if (const Cost* const cost = known(a, b)) return *cost;
  stopped_ = stopped_ || stop_.poll() != StopCondition::Cause::none;
  if (stopped_) return dear_ + straight(a, b);
  // From the lower stop: the same length, to the last bit, whoever asks first.
  const Result found = planner_.plan(
      {.stop = stop_, .start_point = stops_[std::min(a, b)], .goal_point = stops_[std::max(a, b)]},
      params_, {.workspace = &workspace_});
  stopped_ = found.status == Status::limit || found.status == Status::interrupted;
  if (stopped_ || found.path.empty()) return dear_ + straight(a, b);
  const Cost cost = cost_of(a, b, found.length);
  set_known(a, b, cost);
  return cost;
}

}  // namespace lasius::tour
