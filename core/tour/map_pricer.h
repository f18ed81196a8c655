// The legs of a map, priced when they are first asked for.
#pragma once

#include <algorithm>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/tour/order/costs.h"
#include "lasius/plan/planner.h"

namespace lasius::tour {

constexpr double kGrains = 1000;  ///< a cell

/// A length in whole grains: rounded down, by what lengths may be off too, so that sums bound
/// tours.
Cost grains(double length, double scale = kGrains) noexcept;
/// As many grains of a length as the longest allows, a power of two: what is planned does not
/// depend on the world's unit.
double scale_of(std::span<const double> lengths);

/// The planner, prepared where that pays for so many stops: for a point, 30 and more.
Planner prepared_for(const Planner& planner, int stops, int threads, const StopCondition& stop);
/// Are all lengths between so many stops planned at once? Few are; on a prepared map more, by one
/// search a stop, where the legs that a search for an order asks for would take as long.
bool priced_at_once(const Planner& planner, int stops);

/// Costs are lengths of shortest paths between cells that are joined, in grains; bounds are
/// straight distances. Once stopped, legs that are not priced are dear, the longer the dearer: no
/// search takes one in place of a priced leg. None costs more than `largest`. Keeps all costs of up
/// to kMostInMatrix stops, in 4 bytes a pair of them and direction, of more up to kMostKept costs.
class MapPricer final : public Pricer {
 public:
  static constexpr int kMostInMatrix = 5000;
  static constexpr std::size_t kMostKept = 1'200'000;

  MapPricer(const Planner& planner, std::span<const Point> stops, const StopCondition& stop,
            Cost largest = kLargest);
  /// On a map that is prepared for a point, with at most kMostInMatrix stops: prices the legs to
  /// the stops that are nearest to each, and all of a few stops, by which bounds are better (of a
  /// triangle of stops no side is shorter than the others' difference). Never changes a cost.
  void price_near(int threads);
  Cost price(int a, int b) override;
  Cost lower(int a, int b) const override;
  Cost largest() const override { return largest_; }
  std::int64_t priced() const noexcept { return priced_; }
  /// Prices again, until another condition holds.
  void price_until(const StopCondition& stop) {
    stop_ = stop;
    stopped_ = false;
  }

 private:
  static constexpr Cost kNone = -1;
  static constexpr int kNear = 48, kMostNear = 512, kLandmarks = 16;
  static std::uint64_t key(int a, int b) noexcept {
    return std::uint64_t{static_cast<std::uint32_t>(std::min(a, b))} << 32 |
           static_cast<std::uint32_t>(std::max(a, b));
  }
  Cost straight(int a, int b) const noexcept;
  Cost cost_of(int a, int b, double length) const noexcept {
    return std::min(largest_, std::max(straight(a, b), grains(length)));
  }
  const Cost* known(int a, int b) const;
  Cost bound(int a, int b) const noexcept;
  void set_known(int a, int b, Cost cost);

  const Planner& planner_;
  std::span<const Point> stops_;
  Cost largest_, dear_;  // dear_ and a straight distance: at most largest_
  StopCondition stop_;
  Workspace workspace_;
  const Params params_{"exact"};
  std::vector<Cost> matrix_;  // kNone: not priced; empty of many stops
  std::unordered_map<std::uint64_t, Cost> kept_;
  std::vector<Cost> beyond_;       // by stop: what is not known from there is at least so much
  std::vector<Cost> to_landmark_;  // kLandmarks by stop
  std::int64_t priced_ = 0;
  bool stopped_ = false;
};

}  // namespace lasius::tour
