// An open tour as a closed one, by one stop more between its ends.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/tour/order/costs.h"

namespace lasius::tour {

/// The stop more, the last, costs nothing to the ends that are given and more than twice the
/// largest cost to all others (nothing to any where no end is given): a tour without a given end
/// beside it is dearer than the one with that end put there, so a cheapest closed tour is a
/// cheapest open one and the stop more. Not to be moved; holds `costs`, not a copy of them.
class OneMore {
 public:
  OneMore(const Costs& costs, const Ends& ends)
      : ends_(ends),
        free_(ends.start < 0 && ends.goal < 0),
        far_(free_ ? 0 : 2 * costs.largest() + 1),
        late_(*this, costs),
        costs_(costs.size() + 1, late_) {
    if (costs.priced_late()) return;
    const int n = costs.size(), m = n + 1;
    matrix_.resize(static_cast<std::size_t>(m) * m);
    for (int a = 0; a < m; ++a)
      for (int b = 0; b < m; ++b)
        matrix_[static_cast<std::size_t>(a) * m + b] = a == b   ? 0
                                                       : a == n ? to(b)
                                                       : b == n ? to(a)
                                                                : costs(a, b);
    costs_ = Costs(m, matrix_.data());
  }
  OneMore(const OneMore&) = delete;
  OneMore& operator=(const OneMore&) = delete;

  const Costs& costs() const noexcept { return costs_; }
  /// What a closed tour costs more than the open one.
  std::int64_t surplus() const noexcept {
    return !free_ && (ends_.start < 0 || ends_.goal < 0) ? far_ : 0;
  }
  std::vector<std::pair<int, int>> all_legs() const {
    std::vector<std::pair<int, int>> legs;
    for (int v = 0; v + 1 < costs_.size(); ++v) legs.emplace_back(v, costs_.size() - 1);
    return legs;
  }
  /// The open tour, from the start or to the goal where that is given.
  std::vector<int> opened(const std::vector<int>& closed) const {
    const auto cut = std::find(closed.begin(), closed.end(), costs_.size() - 1);
    std::vector<int> order(cut + 1, closed.end());
    order.insert(order.end(), closed.begin(), cut);
    if ((ends_.start >= 0 && order.front() != ends_.start) ||
        (ends_.goal >= 0 && order.back() != ends_.goal))
      std::reverse(order.begin(), order.end());
    return order;
  }

 private:
  struct Late final : Pricer {
    Late(const OneMore& more, const Costs& of) : owner(&more), costs(of) {}
    Cost price(int a, int b) override {
      return std::max(a, b) == costs.size() ? owner->to(std::min(a, b)) : costs(a, b);
    }
    Cost lower(int a, int b) const override {
      return std::max(a, b) == costs.size() ? owner->to(std::min(a, b)) : costs.lower(a, b);
    }
    Cost largest() const override { return std::max(owner->far_, costs.largest()); }
    const OneMore* owner;
    Costs costs;
  };
  Cost to(int stop) const noexcept { return stop == ends_.start || stop == ends_.goal ? 0 : far_; }

  Ends ends_;
  bool free_;
  Cost far_;
  Late late_;
  Costs costs_;
  std::vector<Cost> matrix_;
};

}  // namespace lasius::tour
