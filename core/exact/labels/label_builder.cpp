#include "core/exact/labels/label_builder.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/exact/labels/taut_tree.h"

namespace lasius::exact {
namespace {

constexpr std::uint32_t kTrees = 64;      // by which corners are ranked
constexpr std::uint32_t kFewestHubs = 8;  // searched from at once
constexpr std::uint32_t kMostHubs = 32;   // the same, once many are known
constexpr double kTie = 1 + 1e-14;        // sums in another order

/// One search of a batch: what it found, in the order of length.
struct Found {
  struct Corner {
    double length;
    std::uint32_t corner, next;
    bool kept;
  };
  std::vector<Corner> corners;
};

class HubFinder {
 public:
  HubFinder(const TautGraph& graph, int threads, const StopCondition& stop, Hubs& hubs)
      : graph_(graph), threads_(threads), hubs_(hubs) {
    for (int i = 0; i < threads; ++i) team_.push_back(std::make_unique<Worker>(graph, stop));
  }

  HubsEnd run(std::int64_t most, std::vector<std::uint32_t>&& order) {
    if (order.empty()) {
      rank_corners();
    } else {
      hubs_.by_rank = std::move(order);
      number_ranks();
    }
    hubs_.entries.resize(graph_.size());
    std::vector<Found> found(kMostHubs);
    for (std::uint32_t first = 0; first < graph_.size() && !stopped_;) {
      const std::uint32_t count =
          std::min({std::clamp(first / 8, kFewestHubs, kMostHubs), graph_.size() - first});
      parallel_for(static_cast<int>(count), threads_, [&](int i, int thread) {
        const auto number = static_cast<std::uint32_t>(i);
        search(first + number, *team_[static_cast<std::size_t>(thread)], found[number]);
      });
      if (stopped_) break;
      for (std::uint32_t i = 0; i < count; ++i) append(first, first + i, found[i]);
      first += count;
      if (count_ > most || hopeless(first, most)) return HubsEnd::too_many;
    }
    return stopped_ ? HubsEnd::stopped : HubsEnd::ready;
  }

 private:
  struct Worker {
    Worker(const TautGraph& graph, const StopCondition& stop)
        : tree(graph), poller(stop), known(graph.size(), kInfinity) {}
    TautTree tree;
    Poller poller;
    std::vector<double> known;  // by rank, lengths from the hub in hand
  };

  // By how many shortest ways of some trees lead over a corner.
  void rank_corners() {
    const std::uint32_t n = graph_.size();
    const std::uint32_t trees = std::min(kTrees, n);
    std::vector<std::vector<std::uint64_t>> sums(static_cast<std::size_t>(threads_));
    parallel_for(static_cast<int>(trees), threads_, [&](int i, int thread) {
      auto& sum = sums[static_cast<std::size_t>(thread)];
      if (sum.empty()) sum.resize(n);
      const auto root =
          static_cast<std::uint32_t>(std::uint64_t{n} * static_cast<unsigned>(i) / trees);
      std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // corner, the one before
      Worker& worker = *team_[static_cast<std::size_t>(thread)];
      worker.tree.grow(root, worker.poller, [&](std::uint32_t v, const TautTree::Node& node) {
        order.emplace_back(v, node.parent);
        return true;
      });
      if (worker.poller.stopped()) stopped_ = true;
      std::vector<std::uint32_t> below(n, 1);
      for (auto at = order.rbegin(); at != order.rend(); ++at) {
        below[at->second] += below[at->first];
        sum[at->first] += below[at->first];
      }
      sum[root] += below[root];
    });
    std::vector<std::uint64_t> sum(n);
    for (const auto& part : sums)
      for (std::size_t v = 0; v < part.size(); ++v) sum[v] += part[v];
    hubs_.by_rank.resize(n);
    std::iota(hubs_.by_rank.begin(), hubs_.by_rank.end(), 0U);
    const auto degree = [&](std::uint32_t v) {
      return graph_.edges(v, kColumn).size() + graph_.edges(v, kLine).size();
    };
    std::ranges::sort(hubs_.by_rank, [&](std::uint32_t a, std::uint32_t b) {
      if (sum[a] != sum[b]) return sum[a] > sum[b];
      const std::size_t of_a = degree(a), of_b = degree(b);
      return of_a != of_b ? of_a > of_b : a < b;
    });
    number_ranks();
  }

  void number_ranks() {
    rank_.resize(graph_.size());
    for (std::uint32_t i = 0; i < graph_.size(); ++i) rank_[hubs_.by_rank[i]] = i;
  }

  // Corners that the hub is to be known at, as far as hubs of earlier batches tell.
  void search(std::uint32_t rank, Worker& worker, Found& found) {
    found.corners.clear();
    if (stopped_) return;
    const std::uint32_t hub = hubs_.by_rank[rank];
    for (const HubEntry& entry : hubs_.entries[hub]) worker.known[entry.hub] = entry.length;
    worker.tree.grow(hub, worker.poller, [&](std::uint32_t v, const TautTree::Node& node) {
      const double most = node.length * kTie;
      if (worker.known[rank_[v]] <= most) return false;
      const std::span<const HubEntry> label = hubs_.entries[v];
      worker.poller.stop_after(static_cast<std::int64_t>(label.size()));
      for (const HubEntry& entry : label)
        if (worker.known[entry.hub] + entry.length <= most) return false;
      found.corners.push_back({node.length, v, node.parent, false});
      return true;
    });
    for (const HubEntry& entry : hubs_.entries[hub]) worker.known[entry.hub] = kInfinity;
    if (worker.poller.stopped()) stopped_ = true;
  }

  // Puts what a search found into the labels, but for corners that hubs before it of its own batch,
  // which it did not know, make needless; those that another one is reached over stay.
  void append(std::uint32_t first, std::uint32_t rank, Found& found) {
    const std::uint32_t hub = hubs_.by_rank[rank];
    auto& known = team_[0]->known;
    const auto of_batch = [&](std::uint32_t v) {
      const auto& label = hubs_.entries[v];
      auto from = label.end();
      while (from != label.begin() && (from - 1)->hub >= first) --from;
      return std::span(from, label.end());
    };
    for (const HubEntry& entry : of_batch(hub)) known[entry.hub] = entry.length;
    needed_.resize(graph_.size());
    for (auto at = found.corners.rbegin(); at != found.corners.rend(); ++at) {
      const double most = at->length * kTie;
      const std::uint32_t own = rank_[at->corner];
      bool kept = !(own >= first && own < rank && known[own] <= most);
      for (const HubEntry& entry : of_batch(at->corner))
        if (known[entry.hub] + entry.length <= most) kept = false;
      kept = kept || needed_[at->corner];
      needed_[at->corner] = false;
      at->kept = kept;
      if (kept && at->next != hub) needed_[at->next] = true;
    }
    for (const HubEntry& entry : of_batch(hub)) known[entry.hub] = kInfinity;
    for (const auto& at : found.corners) {
      if (!at.kept) continue;
      hubs_.entries[at.corner].push_back({at.length, rank, at.next});
      ++count_;
    }
  }

  // A few hubs tell: where they are known at most corners, as in noise and warehouses, others will
  // be, too. Each of these shares of what is allowed was passed on no map whose labels were within.
  bool hopeless(std::uint32_t hubs, std::int64_t most) const {
    if (hubs < 16 || graph_.size() < 64 * hubs) return false;
    const double share = 0.1 * (std::bit_width(hubs) - 4);
    return static_cast<double>(count_) > share * static_cast<double>(most);
  }

  const TautGraph& graph_;
  const int threads_;
  Hubs& hubs_;
  std::vector<std::uint32_t> rank_;  // by corner
  std::vector<std::unique_ptr<Worker>> team_;
  std::vector<char> needed_;  // by corner
  std::int64_t count_ = 0;
  std::atomic<bool> stopped_ = false;
};

}  // namespace

HubsEnd find_hubs(const TautGraph& graph, std::int64_t most, int threads, const StopCondition& stop,
                  Hubs& hubs, std::vector<std::uint32_t> order) {
  return HubFinder(graph, threads, stop, hubs).run(most, std::move(order));
}

}  // namespace lasius::exact
