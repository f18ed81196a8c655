// A tour whose order is given in part as a path: from a first node to a last, over all stops.
#pragma once

#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/order/costs.h"
#include "core/tour/order/partial_order.h"

namespace lasius::tour {

/// The nodes of a path: the start first and the goal last, which of a closed tour is the start
/// again; ends that are not given are nodes without a stop, at no cost from any. The other nodes
/// are the other stops. Costs may differ with their direction. Holds neither costs nor order. Of
/// costs that are not priced late any number of threads may ask.
class StopPath {
 public:
  /// An arc to or from a node, and its cost.
  struct Arc {
    int node = 0;
    Cost cost = 0;
  };

  /// `ends` have a start where the tour is closed. Precondition: no stop is before the start or
  /// behind the goal. Stopped, it knows few arcs.
  StopPath(const Costs& costs, const Ends& ends, const PartialOrder& given, Poller& poller);

  int size() const noexcept { return static_cast<int>(stops_.size()); }
  bool symmetric() const noexcept { return symmetric_; }
  const PartialOrder& given() const noexcept { return given_; }
  /// -1: none.
  int stop(int node) const noexcept { return stops_[node]; }
  int load(int node) const noexcept {
    return stops_[node] < 0 || (closed_ && node + 1 == size()) ? 0 : given_.load(stops_[node]);
  }
  Cost cost(int a, int b) const {
    if (known_.empty()) return asked(a, b);
    Cost& known = known_[static_cast<std::size_t>(a) * stops_.size() + b];
    if (known < 0) known = asked(a, b);
    return known;
  }
  /// At most the cost.
  Cost lower(int a, int b) const {
    if (known_.empty()) return bound(a, b);
    const Cost known = known_[static_cast<std::size_t>(a) * stops_.size() + b];
    return known < 0 ? -known - 1 : known;
  }
  /// Nodes right behind and right before one in the order that is given, without the ends.
  std::span<const int> next(int node) const noexcept { return next_[node]; }
  std::span<const int> previous(int node) const noexcept { return previous_[node]; }
  /// The cheapest arcs that an order may take out of a node and into it.
  std::span<const Arc> out(int node) const noexcept { return out_[node]; }
  std::span<const Arc> in(int node) const noexcept { return in_[node]; }

  /// The path of an order of stops that begins and ends as the tour does, and back.
  std::vector<int> path_of(std::span<const int> order) const;
  std::vector<int> order_of(std::span<const int> path) const;

 private:
  Cost asked(int a, int b) const {
    return stops_[a] < 0 || stops_[b] < 0 ? 0 : costs_(stops_[a], stops_[b]);
  }
  Cost bound(int a, int b) const {
    return stops_[a] < 0 || stops_[b] < 0 ? 0 : costs_.lower(stops_[a], stops_[b]);
  }
  bool allowed(int a, int b) const noexcept;
  void list_order();
  Rows<Arc> cheapest_arcs(bool into, Poller& poller) const;

  const Costs& costs_;
  const PartialOrder& given_;
  bool closed_;
  bool symmetric_;
  std::vector<int> stops_;           // of the nodes
  mutable std::vector<Cost> known_;  // row by row: costs, or -1 - a bound; empty: too many
  Rows<int> next_, previous_;
  Rows<Arc> out_, in_;
};

}  // namespace lasius::tour
