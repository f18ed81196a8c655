#include "core/tour/routes/exact_routes.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace lasius::tour {

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kMostSteps = 5e8;

// The program over subsets of one route.
class SubsetWays {
 public:
  SubsetWays(const RouteProblem& problem, int stops, const std::vector<double>& lengths)
      : tasks_(problem.size()), stops_(stops), lengths_(lengths) {
    for (int task = 0; task < tasks_; ++task)
      for (const int stop : problem.tasks[task]) members_.push_back({stop, task});
  }

  unsigned subsets() const { return 1u << tasks_; }

  /// To each subset of tasks the least length of a way over them. `only`: the first stop, -1: any.
  /// False once stopped.
  bool run(const Ends& ends, int only, Poller& poller) {
    ends_ = ends;
    only_ = only;
    const std::size_t n = members_.size();
    least_.assign(subsets() * n, kNone);
    for (std::size_t v = 0; v < n; ++v)
      if (only < 0 || members_[v].stop == only)
        at(1u << members_[v].task, v) = ends.start < 0 ? 0 : leg(ends.start, members_[v].stop);
    for (unsigned subset = 1; subset < subsets(); ++subset) {
      for (std::size_t w = 0; w < n; ++w) {
        const unsigned bit = 1u << members_[w].task;
        if (subset & bit) continue;
        double& there = at(subset | bit, w);
        for (std::size_t v = 0; v < n; ++v)
          there = std::min(there, at(subset, v) + leg(members_[v].stop, members_[w].stop));
      }
      if (poller.stop_after(static_cast<std::int64_t>(n * n))) return false;
    }
    return true;
  }
  double least(unsigned subset) const { return last_of(subset).second; }
  /// With start and goal.
  std::vector<int> way(unsigned subset) const {
    std::vector<int> order;
    if (ends_.goal >= 0) order.push_back(ends_.goal);
    if (subset != 0) {
      std::size_t last = last_of(subset).first;
      for (;;) {
        order.push_back(members_[last].stop);
        const unsigned rest = subset & ~(1u << members_[last].task);
        if (rest == 0) break;
        std::size_t v = 0;
        while (v + 1 < members_.size() &&
               at(rest, v) + leg(members_[v].stop, members_[last].stop) != at(subset, last))
          ++v;
        subset = rest;
        last = v;
      }
    }
    if (ends_.start >= 0) order.push_back(ends_.start);
    std::reverse(order.begin(), order.end());
    return order;
  }

 private:
  struct Member {
    int stop, task;
  };
  double& at(unsigned subset, std::size_t v) { return least_[subset * members_.size() + v]; }
  double at(unsigned subset, std::size_t v) const { return least_[subset * members_.size() + v]; }
  double leg(int a, int b) const { return lengths_[static_cast<std::size_t>(a) * stops_ + b]; }
  // The last member of a shortest way, and its length with what follows.
  std::pair<std::size_t, double> last_of(unsigned subset) const {
    const int end = !ends_.open ? (ends_.start >= 0 ? ends_.start : only_) : ends_.goal;
    if (subset == 0) return {0, ends_.start >= 0 && end >= 0 ? leg(ends_.start, end) : 0};
    std::pair<std::size_t, double> best{0, kNone};
    for (std::size_t v = 0; v < members_.size(); ++v) {
      const double sum = at(subset, v) + (end >= 0 ? leg(members_[v].stop, end) : 0);
      if (sum < best.second) best = {v, sum};
    }
    return best;
  }

  int tasks_, stops_;
  const std::vector<double>& lengths_;
  std::vector<Member> members_;
  Ends ends_;
  int only_ = -1;
  std::vector<double> least_;  // of all ways over the subset that end at a member
};

// A task that has fewest stops.
const std::vector<int>& fewest(const RouteProblem& problem) {
  return *std::min_element(problem.tasks.begin(), problem.tasks.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
}

bool is_ring(const RouteProblem& problem) { return problem.size() > 0 && problem.ring(); }

// Whether it takes more steps than are worth it.
bool too_many(const RouteProblem& problem) {
  if (problem.size() > kMostTasksBySubsets) return true;
  double members = 0;
  for (const auto& task : problem.tasks) members += static_cast<double>(task.size());
  const double runs = is_ring(problem) ? static_cast<double>(fewest(problem).size())
                                       : 2 * static_cast<double>(problem.routes.size());
  return members * members * static_cast<double>(1u << problem.size()) * runs > kMostSteps;
}

// A closed way without a start: from each stop of the task that has fewest.
std::optional<std::vector<int>> exact_ring(const RouteProblem& problem, SubsetWays& ways,
                                           Poller& poller) {
  std::vector<int> best;
  double length = kNone;
  for (const int first : fewest(problem)) {
    if (!ways.run(problem.routes.front(), first, poller)) return std::nullopt;
    const unsigned all = ways.subsets() - 1;
    if (ways.least(all) >= length) continue;
    length = ways.least(all);
    best = ways.way(all);
  }
  return best;
}

}  // namespace

std::optional<std::vector<std::vector<int>>> exact_routes(const RouteProblem& problem, int stops,
                                                          const std::vector<double>& lengths,
                                                          Poller& poller) {
  const std::size_t count = problem.routes.size();
  if (too_many(problem)) return std::nullopt;
  SubsetWays ways(problem, stops, lengths);
  if (is_ring(problem)) {
    const auto order = exact_ring(problem, ways, poller);
    if (!order) return std::nullopt;
    return std::vector<std::vector<int>>{*order};
  }
  const unsigned subsets = ways.subsets();
  // shares[r * subsets + s]: what route r takes on of s, if those up to r do all of s.
  std::vector<double> least(subsets, kNone), before, own(subsets);
  std::vector<unsigned> shares(count * subsets, 0);
  least[0] = 0;
  for (std::size_t r = 0; r < count; ++r) {
    if (!ways.run(problem.routes[r], -1, poller)) return std::nullopt;
    before = least;
    std::fill(least.begin(), least.end(), kNone);
    for (unsigned s = 0; s < subsets; ++s)
      own[s] = std::popcount(s) <= problem.room() ? ways.least(s) : kNone;
    for (unsigned s = 0; s < subsets; ++s)
      for (unsigned share = s;; share = (share - 1) & s) {
        const double sum = before[s ^ share] + own[share];
        if (sum < least[s]) least[s] = sum, shares[r * subsets + s] = share;
        if (share == 0) break;
      }
  }
  std::vector<std::vector<int>> orders(count);
  unsigned left = subsets - 1;
  for (std::size_t r = count; r-- > 0;) {
    const unsigned share = shares[r * subsets + left];
    // The last route's ways are still there.
    if (r + 1 < count && !ways.run(problem.routes[r], -1, poller)) return std::nullopt;
    orders[r] = ways.way(share);
    left ^= share;
  }
  return orders;
}

std::optional<std::vector<std::vector<int>>> exact_routes(const RouteProblem& problem,
                                                          const Costs& costs, Poller& poller) {
  if (costs.priced_late() || too_many(problem)) return std::nullopt;
  const int n = costs.size();
  std::vector<double> lengths(static_cast<std::size_t>(n) * n);  // sums of so few are exact
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b)
      if (a != b) lengths[static_cast<std::size_t>(a) * n + b] = costs(a, b);
  return exact_routes(problem, n, lengths, poller);
}

}  // namespace lasius::tour
