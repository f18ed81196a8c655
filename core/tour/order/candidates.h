// Which stops are worth going to next: the nearest few, some in each quadrant.
#pragma once

#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/order/costs.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"

namespace lasius::tour {

/// For each stop some others, cheapest first.
class Candidates {
 public:
  struct Leg {
    int to;
    Cost cost;
  };

  /// The `count` cheapest each; where places are given (of the first stops, or none) first the
  /// count / 4 cheapest in each quadrant around the stop. Of a pricer's costs only those are priced
  /// of which the lower bound does not show that they are dearer. Of more than kMany stops, once
  /// stopped, of those beside it by x; of stops without places by number.
  Candidates(const Costs& costs, std::span<const Point> places, int count,
             const StopCondition& stop = {});
  /// The same, but once stopped, of more than `many`, of fewer beside it.
  Candidates(const Costs& costs, std::span<const Point> places, int count, Poller& poller,
             int many = 0);
  static constexpr int kMany = 4000;

  std::span<const Leg> of(int stop) const noexcept {
    return {legs_.data() + begin_[stop], legs_.data() + begin_[stop + 1]};
  }
  std::size_t count() const noexcept { return legs_.size(); }  ///< of legs
  int size() const noexcept { return static_cast<int>(begin_.size()) - 1; }
  /// Lets the legs of both directions in, and of `more` (pairs of stops) too.
  void add(const Costs& costs, std::span<const std::pair<int, int>> more);

 private:
  std::vector<int> begin_;
  std::vector<Leg> legs_;
};

}  // namespace lasius::tour
