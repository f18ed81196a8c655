#include <algorithm>
#include <limits>

#include "core/tour/order/bound.h"
#include "core/tour/routes/routes.h"

namespace lasius::tour {

namespace {

using Sum = std::int64_t;
constexpr Sum kScale = 256;  // of costs, so that prices of tasks have fractions
constexpr int kRounds = 10;

// Tasks, then the starts and goals that are stops, as nodes; costs are the least between them.
struct LeastCosts {
  LeastCosts(const RouteProblem& problem, const Costs& costs) : layers(problem.tasks) {
    const auto node_of = [&](int stop) {
      if (stop < 0) return -1;
      layers.push_back({stop});
      return static_cast<int>(layers.size()) - 1;
    };
    for (const Ends& ends : problem.routes) {
      const int start = node_of(ends.start);
      routes.push_back({ends.open, start, node_of(ends.goal)});
    }
    const std::size_t n = layers.size();
    matrix.assign(n * n, 0);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < a; ++b) {
        Cost least = kLargest;
        for (const int v : layers[a])
          for (const int w : layers[b]) least = std::min(least, costs.lower(v, w));
        matrix[a * n + b] = matrix[b * n + a] = least;
      }
  }
  Costs costs() const { return {static_cast<int>(layers.size()), matrix.data()}; }

  std::vector<std::vector<int>> layers;
  std::vector<Ends> routes;
  std::vector<Cost> matrix;
};

// The ascent over trees that join all tasks and the depot.
class RoutesAscent {
 public:
  RoutesAscent(const RouteProblem& problem, const LeastCosts& least)
      : n_(problem.size()), most_(static_cast<int>(problem.routes.size())), costs_(least.costs()) {
    fewest_ = (n_ + problem.room() - 1) / problem.room();
    most_ = std::min(most_, n_);
    from_depot_.assign(n_, kLargest);
    for (const Ends& ends : least.routes)
      for (int v = 0; v < n_; ++v) from_depot_[v] = std::min(from_depot_[v], costs_(ends.start, v));
    back_ = problem.routes.front().open ? std::vector<Cost>(n_, 0) : from_depot_;
    price_.assign(n_, 0);
    degree_.assign(n_, 0);
  }

  // The greatest valid bound, scaled: every value is one.
  Sum run(Sum upper, Poller& poller) {
    Sum greatest = 0;
    std::vector<Sum> best = price_;
    std::vector<int> last(n_, 0);
    const int patience = std::max(20, std::min(100, n_));
    int idle = 0;
    for (double lambda = 2; lambda > 1e-3;) {
      const Sum value = tree();
      if (value > greatest) {
        greatest = value;
        best = price_;
        idle = 0;
      } else if (++idle >= patience) {
        idle = 0;
        lambda /= 2;
        price_ = best;
      }
      double squares = 0;
      for (const int degree : degree_) squares += (degree - 2) * (degree - 2);
      if (squares == 0 || value >= upper) break;
      if (poller.stop_after(static_cast<Sum>(n_) * n_)) break;
      const double step = lambda * static_cast<double>(upper - value) / squares;
      for (int v = 0; v < n_; ++v) {
        const int g = degree_[v] - 2;
        price_[v] += static_cast<Sum>(step * (0.7 * g + 0.3 * last[v]));
        last[v] = g;
      }
    }
    return greatest;
  }

 private:
  // A least tree, and the cheapest returns of as many routes as are cheapest, less what tasks with
  // two legs pay. In each route all legs but the last make a part of the tree, and each last leg is
  // of another task.
  Sum tree() {
    std::vector<Sum> key(n_);
    std::vector<int> from(n_, -1);  // -1: the depot
    std::vector<char> in(n_, 0);
    for (int v = 0; v < n_; ++v) key[v] = from_depot_[v] * kScale + price_[v];
    std::fill(degree_.begin(), degree_.end(), 0);
    Sum value = 0;
    for (int count = 0; count < n_; ++count) {
      int now = -1;
      for (int v = 0; v < n_; ++v)
        if (!in[v] && (now < 0 || key[v] < key[now])) now = v;
      in[now] = 1;
      value += key[now];
      ++degree_[now];
      if (from[now] >= 0) ++degree_[from[now]];
      for (int v = 0; v < n_; ++v) {
        if (in[v]) continue;
        const Sum to = costs_(now, v) * kScale + price_[now] + price_[v];
        if (to < key[v]) key[v] = to, from[v] = now;
      }
    }
    std::vector<std::pair<Sum, int>> returns;
    for (int v = 0; v < n_; ++v) returns.emplace_back(back_[v] * kScale + price_[v], v);
    std::partial_sort(returns.begin(), returns.begin() + most_, returns.end());
    for (int i = 0; i < most_ && (i < fewest_ || returns[i].first < 0); ++i) {
      value += returns[i].first;
      ++degree_[returns[i].second];
    }
    for (const Sum price : price_) value -= 2 * price;
    return value;
  }

  int n_, most_, fewest_ = 1;
  Costs costs_;
  std::vector<Cost> from_depot_, back_;
  std::vector<Sum> price_;
  std::vector<int> degree_;
};

}  // namespace

std::int64_t routes_bound(const RouteProblem& problem, const Costs& costs, std::int64_t upper,
                          Poller& poller) {
  if (problem.size() == 0) return 0;
  const LeastCosts least(problem, costs);
  if (problem.routes.size() == 1)
    return tour_bound(least.costs(), least.routes.front(), {}, upper, kRounds, poller);
  const Sum bound = RoutesAscent(problem, least).run(upper * kScale, poller);
  return std::min(upper, (bound + kScale - 1) / kScale);
}

}  // namespace lasius::tour
