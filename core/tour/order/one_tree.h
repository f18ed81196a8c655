// Least 1-trees under prices: a spanning tree of all stops, and the second leg of the leaf that has
// the dearest one.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/order/ascend.h"
#include "core/tour/order/candidates.h"
#include "core/tour/order/costs.h"

namespace lasius::tour {

/// A leg costs what it costs and the prices of its two stops more; one of the candidates also its
/// `extra`. All values are scaled.
class OneTree {
 public:
  using Pairs = std::vector<std::pair<int, int>>;

  OneTree(const Costs& costs, std::span<const Point> places, int candidates, Poller& poller);

  std::vector<Sum> price;  ///< by stop
  std::vector<Sum> extra;  ///< by leg of the candidates
  const Candidates& candidates() const noexcept { return candidates_; }
  std::size_t index(const Candidates::Leg& leg) const {
    return static_cast<std::size_t>(&leg - candidates_.of(0).data());
  }
  /// Lets legs in, both ways; extra is then 0.
  void add(std::span<const std::pair<int, int>> more);

  /// The value of the tree over the candidates; kFar where these do not join all.
  Sum sparse();
  std::span<const std::size_t> tree() const noexcept { return tree_; }  ///< of sparse(): legs
  std::span<const int> degree() const noexcept { return degree_; }      ///< likewise, by stop
  /// The value over all legs, at their lower bounds. `more`: its legs that are no candidates.
  Sum dense(Pairs& more) const;
  /// Adds to `more` legs, no candidates, that are cheaper than one of the sparse tree's which they
  /// can replace, and of each stop the `count` that miss it by least.
  void near(int count, Poller& poller, Pairs& more);

 private:
  struct Waiting {
    Sum key;
    int to, from;
    std::size_t leg;
    bool operator<(const Waiting& o) const { return key != o.key ? key > o.key : to > o.to; }
  };
  Sum priced(Cost cost, int a, int b) const { return cost * kScale + price[a] + price[b]; }
  bool span();
  void let_in(int a, int b, Pairs& more) const;

  const Costs& costs_;
  Candidates candidates_;
  std::vector<int> parent_, reached_, degree_;  // reached_: stops, as the tree came to them
  std::vector<Sum> key_;
  std::vector<char> in_;
  std::vector<Waiting> heap_;
  std::vector<std::size_t> tree_;
};

}  // namespace lasius::tour
