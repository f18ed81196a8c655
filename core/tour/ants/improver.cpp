#include "core/tour/ants/improver.h"

namespace lasius::tour {
namespace {

constexpr int kEdgeCandidates = 8;  // that edges are exchanged along
constexpr int kFewestForEdges = 8, kFewestForPieces = 4;

}  // namespace

Improver::Improver(const Costs& costs, const Ends& ends, const PartialOrder& given,
                   Improvement kind, bool symmetric, int threads, const StopCondition& stop)
    : edges_(kind == Improvement::two_edges ? 2 : 3) {
  if (kind == Improvement::none) return;
  if (kind == Improvement::pieces) {
    if (costs.size() < kFewestForPieces) return;
    Poller poller(stop);
    path_.emplace(costs, ends, given, poller);
    exchanges_.reserve(static_cast<std::size_t>(threads));
    for (int i = 0; i < threads; ++i) exchanges_.emplace_back(*path_);
    return;
  }
  if (!symmetric || !given.any_order() || costs.size() < kFewestForEdges) return;
  if (ends.open) more_.emplace(costs, ends);
  local_.emplace(more_ ? more_->costs() : costs);
  candidates_.emplace(*local_, std::span<const Point>(), kEdgeCandidates);
  if (more_) candidates_->add(*local_, more_->all_legs());
}

std::vector<int> Improver::improved(std::vector<int> order, std::span<const int> best, int thread,
                                    Poller& poller) {
  if (path_) {
    PathExchange& exchange = exchanges_[static_cast<std::size_t>(thread)];
    exchange.set(path_->path_of(order));
    if (best.empty())
      exchange.wake_all();
    else
      wake_differences(exchange, best);
    exchange.improve(poller);
    return path_->order_of(exchange.now().nodes);
  }
  if (more_) order.push_back(more_->costs().size() - 1);
  ArrayTour tour(*local_, order);
  LocalSearch search(*local_, *candidates_, edges_);
  search.improve(tour, poller);
  return more_ ? more_->opened(tour.order()) : tour.order();
}

void Improver::wake_differences(PathExchange& exchange, std::span<const int> best) const {
  const std::vector<int> nodes = path_->path_of(best);
  std::vector<int> behind(nodes.size(), -1);
  for (std::size_t p = 1; p < nodes.size(); ++p) behind[nodes[p - 1]] = nodes[p];
  for (int p = path_->size() - 1; p > 0; --p) {
    const int before = exchange.now().nodes[p - 1], node = exchange.now().nodes[p];
    if (behind[before] == node) continue;
    exchange.wake(node);
    exchange.wake(before);
  }
}

}  // namespace lasius::tour
