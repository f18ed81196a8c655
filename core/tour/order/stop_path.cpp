#include "core/tour/order/stop_path.h"

#include <algorithm>

namespace lasius::tour {

namespace {

constexpr int kArcs = 10;
constexpr int kMostKnown = 4000;  // nodes whose costs are kept: 64 MB

}  // namespace

StopPath::StopPath(const Costs& costs, const Ends& ends, const PartialOrder& given, Poller& poller)
    : costs_(costs), given_(given), closed_(!ends.open), symmetric_(true) {
  const int n = costs.size(), last = closed_ ? ends.start : ends.goal;
  stops_.push_back(ends.start);
  for (int v = 0; v < n; ++v)
    if (v != ends.start && v != last) stops_.push_back(v);
  stops_.push_back(last);
  if (!costs.priced_late())
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < a; ++b)  // what no order may take tells nothing
        symmetric_ =
            symmetric_ && (costs(a, b) == costs(b, a) || given.before(a, b) || given.before(b, a));
  if (size() <= kMostKnown) {
    std::vector<Cost> known(stops_.size() * stops_.size());
    for (int a = 0; a < size(); ++a)
      for (int b = 0; b < size(); ++b)
        known[a * stops_.size() + b] = costs.priced_late() ? -1 - std::max<Cost>(0, bound(a, b))
                                                           : std::max<Cost>(0, bound(a, b));
    known_ = std::move(known);
  }
  list_order();
  out_ = cheapest_arcs(false, poller);
  in_ = cheapest_arcs(true, poller);
}

bool StopPath::allowed(int a, int b) const noexcept {
  if (a == b || b == 0 || a + 1 == size()) return false;
  if (a == 0) return (b + 1 == size()) == (size() == 2) && previous(b).empty();
  if (b + 1 == size()) return next(a).empty();
  return !given_.parted(stops_[a], stops_[b]);
}

void StopPath::list_order() {
  std::vector<int> node_of(costs_.size(), -1);
  for (int node = 1; node + 1 < size(); ++node) node_of[stops_[node]] = node;
  const auto list = [&](bool later, Rows<int>& nodes) {
    for (int node = 0; node < size(); ++node) {
      if (node > 0 && node + 1 < size())
        for (const int stop : later ? given_.next(stops_[node]) : given_.previous(stops_[node]))
          if (node_of[stop] >= 0) nodes.push(node_of[stop]);
      nodes.end_row();
    }
  };
  list(true, next_);
  list(false, previous_);
}

Rows<StopPath::Arc> StopPath::cheapest_arcs(bool into, Poller& poller) const {
  const auto cheaper = [](const Arc& a, const Arc& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.node < b.node;
  };
  std::vector<Arc> row, kept;
  Rows<Arc> arcs;
  for (int node = 0; node < size(); ++node) {
    row.clear();
    kept.clear();
    for (int other = 0; other < size(); ++other) {
      const int a = into ? other : node, b = into ? node : other;
      if (allowed(a, b)) row.push_back({other, lower(a, b)});
    }
    std::sort(row.begin(), row.end(), cheaper);
    for (const Arc& arc : row) {  // by rising bounds: few are priced that are not kept
      if (kept.size() == kArcs && !cheaper(arc, kept.back())) break;
      const Arc priced{arc.node, into ? cost(arc.node, node) : cost(node, arc.node)};
      kept.insert(std::upper_bound(kept.begin(), kept.end(), priced, cheaper), priced);
      if (kept.size() > kArcs) kept.pop_back();
      if (poller.stop_after(size())) break;
    }
    for (const Arc& arc : kept) arcs.push(arc);
    arcs.end_row();
  }
  return arcs;
}

std::vector<int> StopPath::path_of(std::span<const int> order) const {
  std::vector<int> node_of(costs_.size(), 0), path = {0};
  for (int node = 1; node + 1 < size(); ++node) node_of[stops_[node]] = node;
  for (const int stop : order)
    if (stop != stops_.front() && stop != stops_.back()) path.push_back(node_of[stop]);
  path.push_back(size() - 1);
  return path;
}

std::vector<int> StopPath::order_of(std::span<const int> path) const {
  std::vector<int> order;
  for (const int node : path)
    if (stops_[node] >= 0 && !(closed_ && node + 1 == size())) order.push_back(stops_[node]);
  return order;
}

}  // namespace lasius::tour
