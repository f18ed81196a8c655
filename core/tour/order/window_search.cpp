#include "core/tour/order/window_search.h"

#include <algorithm>
#include <chrono>

#include "core/base/poller.h"
#include "core/tour/order/path_exchange.h"
#include "core/tour/order/stop_path.h"
#include "kernels/base/power.h"
#include "kernels/base/random_stream.h"

namespace lasius::tour {

namespace {

constexpr std::uint32_t kUse = 0x77696e64;
constexpr int kShortestWindow = 8;
constexpr int kPieces = 10;           // of a kick: nodes of the longest, and how far off they are
constexpr double kDrawn = 3;          // of a window, in the mean
constexpr std::size_t kFewOpen = 10;  // nodes, of which all are drawn from
constexpr int kRoots = 8;             // that closed tours without a start try, in half of the time
constexpr int kStepsOfGeneration = 1000, kStepsOfStop = 10;

double unit(kernels::RandomStream& random) { return (random.next() + 0.5) * 0x1p-32; }

// The share of the horizon that has passed.
class Horizon {
 public:
  Horizon(const OrderOptions& options, int stops)
      : stop_(options.stop),
        steps_(options.generations * std::int64_t{kStepsOfGeneration + kStepsOfStop * stops}),
        begin_(stop_.now()),
        timed_(stop_.deadline != Clock::time_point::max()) {}

  bool timed() const noexcept { return timed_; }
  /// 1 or more: over.
  double passed(std::int64_t step) const {
    if (!timed_) return steps_ > 0 ? static_cast<double>(step) / static_cast<double>(steps_) : 1;
    const std::chrono::duration<double> gone = stop_.now() - begin_, all = stop_.deadline - begin_;
    return all.count() > 0 ? gone / all : 1;
  }

 private:
  const StopCondition& stop_;
  std::int64_t steps_;
  Clock::time_point begin_;
  bool timed_;
};

// The search of one path.
class WindowSearch {
 public:
  WindowSearch(const StopPath& path, kernels::RandomStream& random, Poller& poller)
      : path_(path),
        random_(random),
        poller_(poller),
        exchange_(path),
        waits_(path.size(), 0),
        window_(path.size(), 0) {}

  /// The first local optimum; false once stopped.
  bool begin(std::vector<int> nodes) {
    exchange_.set(std::move(nodes));
    exchange_.wake_all();
    const bool done = exchange_.improve(poller_);
    mean_arc_ = static_cast<double>(exchange_.now().cost) / path_.size();
    exchange_.keep(current_);
    return done;
  }
  const PathState& current() const noexcept { return current_; }

  /// One step at a share of the first temperature; false once stopped, and then no step.
  bool step(double temperature) {
    const bool changed = random_.chance(0.5) ? swap_pieces() : build_window();
    if (changed) {
      for (int p = std::max(0, exchange_.first_written() - 1); p <= exchange_.last_written(); ++p)
        if (p + 1 < path_.size()) wake_new(p);
      if (!exchange_.improve(poller_)) {
        exchange_.restore(current_);
        return false;
      }
    }
    constexpr double kLog2 = 0.69314718055994530942;
    const double more = -temperature * mean_arc_ * (kLog2 * kernels::log2_of(unit(random_)));
    if (static_cast<double>(exchange_.now().cost - current_.cost) <= more)
      exchange_.keep(current_);
    else
      exchange_.restore(current_);
    return !poller_.stop_after(1);
  }

 private:
  void wake_new(int p) {
    const auto& t = exchange_.now().nodes;
    const int before = current_.position[t[p]];
    if (before + 1 < path_.size() && current_.nodes[before + 1] == t[p + 1]) return;
    exchange_.wake(t[p + 1]);
    exchange_.wake(t[p]);
  }

  bool swap_pieces() {
    const int inner = path_.size() - 2, at = random_.below(path_.size() - 1);
    bool changed = false;
    int swapped = 0;
    for (int tries = 0; tries < 10 && swapped < 2; ++tries) {
      const int h = std::max(0, at - kPieces + random_.below(2 * kPieces));
      const int i = h + 1 + random_.below(kPieces), j = i + 1 + random_.below(kPieces);
      if (j > inner || !exchange_.may_swap(h, i, j)) continue;
      exchange_.swap(h, i, j);
      changed = true;
      ++swapped;
    }
    return changed;
  }

  bool fits(int node) const { return carried_ + path_.load(node) <= path_.given().capacity(); }

  // False, and nothing is changed, where the capacity lets nothing follow.
  bool build_window() {
    const int inner = path_.size() - 2;
    const double longest = std::max(1.0, static_cast<double>(inner) / kShortestWindow);
    const int length =
        inner <= kShortestWindow
            ? inner
            : static_cast<int>(kShortestWindow * kernels::power(longest, unit(random_)));
    const int from = 1 + random_.below(inner - length + 1);
    const auto& t = exchange_.now().nodes;
    for (int p = from; p < from + length; ++p) window_[t[p]] = 1;
    open_.clear();
    for (int p = from; p < from + length; ++p) {
      waits_[t[p]] = static_cast<int>(
          std::ranges::count_if(path_.previous(t[p]), [&](int v) { return window_[v] != 0; }));
      if (waits_[t[p]] == 0) open_.push_back(t[p]);
    }
    carried_ = exchange_.now().carried.empty() ? 0 : exchange_.now().carried[from - 1];
    built_.clear();
    for (int last = t[from - 1]; static_cast<int>(built_.size()) < length;) {
      const int follows = current_.nodes[current_.position[last] + 1];
      const bool as_it_was = window_[follows] && waits_[follows] == 0 && fits(follows) &&
                             random_.chance(1 - kDrawn / length);
      last = as_it_was ? follows : draw(last);
      if (last < 0) break;
      built_.push_back(last);
      carried_ += path_.load(last);
      window_[last] = 0;
      open_.erase(std::find(open_.begin(), open_.end(), last));
      for (const int v : path_.next(last))
        if (window_[v] && --waits_[v] == 0) open_.push_back(v);
    }
    const bool whole = static_cast<int>(built_.size()) == length;
    for (int p = from; p < from + length; ++p) window_[t[p]] = 0;
    if (whole) exchange_.rewrite(from, built_);
    return whole;
  }

  // A node that may follow; -1: none.
  int draw(int last) {
    drawn_.clear();
    if (open_.size() <= kFewOpen) {
      for (const int v : open_)
        if (fits(v)) drawn_.emplace_back(v, path_.cost(last, v));
    } else {
      for (const auto& arc : path_.out(last))
        if (window_[arc.node] && waits_[arc.node] == 0 && fits(arc.node))
          drawn_.emplace_back(arc.node, arc.cost);
    }
    if (drawn_.empty()) {
      int nearest = -1;
      for (const int v : open_)
        if (fits(v) && (nearest < 0 || path_.lower(last, v) < path_.lower(last, nearest)))
          nearest = v;
      return nearest;
    }
    const auto weight = [&](Cost cost) { return 1 / (cost + 1 + 0.1 * mean_arc_); };
    double sum = 0;
    for (const auto& [v, cost] : drawn_) sum += weight(cost);
    double left = sum * unit(random_);
    for (const auto& [v, cost] : drawn_)
      if ((left -= weight(cost)) < 0) return v;
    return drawn_.back().first;
  }

  const StopPath& path_;
  kernels::RandomStream& random_;
  Poller& poller_;
  PathExchange exchange_;
  PathState current_;
  double mean_arc_ = 0;
  std::vector<int> waits_;    // of the window's nodes: those before them that are not built
  std::vector<char> window_;  // that are not built yet
  std::vector<int> open_, built_;
  std::vector<std::pair<int, Cost>> drawn_;
  std::int64_t carried_ = 0;
};

// The same closed tour, begun at another stop where what is given allows it; else empty.
std::vector<int> begun_elsewhere(const std::vector<int>& order, const PartialOrder& given,
                                 kernels::RandomStream& random) {
  const int n = static_cast<int>(order.size());
  std::vector<int> position(n), cuts;
  for (int p = 0; p < n; ++p) position[order[p]] = p;
  int reach = 0;  // of what comes behind any stop so far
  for (int p = 0; p < n; ++p) {
    if (p > 0 && reach < p) cuts.push_back(p);
    for (const int v : given.next(order[p])) reach = std::max(reach, position[v]);
  }
  for (int left = static_cast<int>(cuts.size()); left > 0; --left) {
    std::swap(cuts[random.below(left)], cuts[left - 1]);
    std::vector<int> turned = order;
    std::rotate(turned.begin(), turned.begin() + cuts[left - 1], turned.end());
    if (given.carries(turned)) return turned;
  }
  return {};
}

// The stop is put first, where what is given allows it; else empty.
std::vector<int> begun_with(int stop, std::vector<int> order, const PartialOrder& given) {
  if (!given.previous(stop).empty()) return {};
  const auto at = std::find(order.begin(), order.end(), stop);
  std::rotate(order.begin(), at, at + 1);
  return given.carries(order) ? order : std::vector<int>{};
}

// Where another round may begin: at a stop where none began yet.
std::vector<int> next_root(const std::vector<int>& best, const PartialOrder& given, bool as_it_is,
                           std::vector<char>& tried, kernels::RandomStream& random) {
  if (as_it_is) {
    std::vector<int> turned = begun_elsewhere(best, given, random);
    if (!turned.empty() && !tried[turned.front()]) return turned;
  }
  const int n = static_cast<int>(best.size()), from = random.below(n);
  for (int i = 0; i < n; ++i) {
    const int stop = (from + i) % n;
    if (tried[stop]) continue;
    std::vector<int> order = begun_with(stop, best, given);
    if (!order.empty()) return order;
  }
  return best;
}

}  // namespace

OrderFound find_partial_order(const Costs& costs, const Ends& ends, const PartialOrder& given,
                              const OrderOptions& options) {
  OrderFound found;
  FirstOrder first = first_order(costs, ends, given);
  found.optimal = first.proven;
  if (first.order.empty()) return found;
  const int roots = ends.open || ends.start >= 0 ? 1 : kRoots + 1;
  std::vector<char> tried(costs.size(), 0);
  const Horizon horizon(options, costs.size());
  Poller poller(options.stop, 1 << 12);
  bool more = true;
  const auto offer = [&](const StopPath& path, const PathState& state) {
    if (!found.order.empty() && state.cost >= found.cost) return true;
    found.order = path.order_of(state.nodes);
    found.cost = state.cost;
    return (!options.observer || options.observer(found.order, found.cost)) &&
           found.cost > options.target;
  };
  std::int64_t step = 0;
  bool over = false;
  for (int root = 0; root < roots && more; ++root) {
    kernels::RandomStream random(options.seed, static_cast<std::uint32_t>(root), 0, kUse);
    if (root > 0 && root < kRoots)
      first.order = next_root(found.order, given, root % 2 == 1, tried, random);
    else if (root == kRoots)
      first.order = found.order;
    tried[first.order.front()] = 1;
    Ends fixed = ends;
    if (!ends.open) fixed.start = first.order.front();
    const StopPath path(costs, fixed, given, poller);
    WindowSearch search(path, random, poller);
    more = search.begin(path.path_of(first.order));
    more = offer(path, search.current()) && more && path.size() > 3;
    const double share = roots == 1 ? 1 : root < kRoots ? 0.5 / kRoots : 0.5;
    while (more) {
      const double passed = (horizon.passed(step++) - std::min(0.5, root * share)) / share;
      over = passed >= 1;
      if (over) break;
      more = search.step(1 - passed);
      more = offer(path, search.current()) && more;
    }
  }
  found.cause = over && horizon.timed() ? StopCondition::Cause::deadline : poller.cause();
  return found;
}

}  // namespace lasius::tour
