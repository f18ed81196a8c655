// The order of swaths, by the search for an order of stops: two a swath.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/tour/order/costs.h"
#include "core/tour/order/search.h"

namespace lasius::tour {

/// Stops 2 i and 2 i + 1 are the ends of swath i, others are alone. A swath costs nothing and any
/// other leg kApart more than it is, so that a cheap order takes every swath.
class SwathPricer final : public Pricer {
 public:
  static constexpr Cost kApart = kLargest / 2;

  /// Of `swaths` swaths; holds `legs`, whose costs above kApart count as that.
  SwathPricer(int swaths, const Costs& legs) : swaths_(swaths), legs_(legs) {}
  Cost price(int a, int b) override {
    return a == b || joined(a, b) ? 0 : kApart + std::min(kApart, legs_(a, b));
  }
  Cost lower(int a, int b) const override {
    return a == b || joined(a, b) ? 0 : kApart + std::min(kApart, legs_.lower(a, b));
  }
  Cost largest() const override { return 2 * kApart; }
  bool joined(int a, int b) const noexcept { return a / 2 == b / 2 && a / 2 < swaths_; }

 private:
  int swaths_;
  Costs legs_;
};

/// The same order with the ends of each swath side by side, where they are not; of a closed tour
/// it begins at an end, not between two.
std::vector<int> whole_swaths(std::vector<int> order, const SwathPricer& swaths, bool open);

}  // namespace lasius::tour
