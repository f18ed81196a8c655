#include "core/tour/routes/exact_routes.h"

#include <algorithm>
#include <bit>
#include <cstdint>
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
    for (int task = 0; task < tasks_; ++task) {
      first_.push_back(members_.size());
      for (const int stop : problem.tasks[task]) members_.push_back({stop, task});
    }
    first_.push_back(members_.size());
    between_.reserve(members_.size() * members_.size());
    for (const Member& v : members_)
      for (const Member& w : members_) between_.push_back(leg(v.stop, w.stop));
  }

  unsigned subsets() const { return 1u << tasks_; }

  /// To each subset of tasks the least length of a way over them. `only`: the first stop, -1: any.
  /// Of a ring that is as long as `most` none needs to be told, by what `home` has of the way back.
  /// False once stopped.
  bool run(const Ends& ends, int only, Poller& poller, double most = kNone,
           const SubsetWays* home = nullptr) {
    ends_ = ends;
    only_ = only;
    const std::size_t n = members_.size();
    least_.assign(subsets() * n, kNone);
    for (std::size_t v = 0; v < n; ++v)
      if (only < 0 || members_[v].stop == only)
        at(1u << members_[v].task, v) = ends.start < 0 ? 0 : leg(ends.start, members_[v].stop);
    for (unsigned subset = 1; subset < subsets(); ++subset) {
      std::int64_t steps = tasks_;
      for (int task = 0; task < tasks_; ++task) {
        if ((subset >> task & 1) == 0) continue;
        const double left = home != nullptr ? home->back_from(subset, task) : 0;
        for (std::size_t v = first_[task]; v < first_[task + 1]; ++v)
          if (at(subset, v) + left < most) steps += go_on(subset, v);
      }
      if (poller.stop_after(steps)) return false;
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
  // From a member over each task that is left; how many legs that are.
  std::int64_t go_on(unsigned subset, std::size_t v) {
    const std::size_t n = members_.size();
    const double length = at(subset, v);
    const double* const legs = between_.data() + v * n;
    std::int64_t steps = 0;
    for (int task = 0; task < tasks_; ++task) {
      if ((subset >> task & 1) != 0) continue;
      double* const there = least_.data() + (subset | 1u << task) * n;
      const std::size_t end = first_[task + 1];
      for (std::size_t w = first_[task]; w < end; ++w)
        there[w] = std::min(there[w], length + legs[w]);
      steps += static_cast<std::int64_t>(end - first_[task]);
    }
    return steps;
  }
  // Of one member a task and all legs turned round: from a task, over all that are not in a subset,
  // to the first.
  double back_from(unsigned subset, int task) const {
    const unsigned first = 1u << only_;
    if (subset == first) return 0;
    return at(((subsets() - 1) ^ subset) | first | 1u << task, static_cast<std::size_t>(task));
  }
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
  std::vector<Member> members_;     // task by task
  std::vector<std::size_t> first_;  // member of each task, and the end
  std::vector<double> between_;     // members, row by row
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

// From each task back to each other by the least leg between any of their stops.
std::vector<double> least_legs_back(const RouteProblem& problem, int stops,
                                    const std::vector<double>& lengths) {
  std::vector<double> least;
  least.reserve(problem.tasks.size() * problem.tasks.size());
  for (const std::vector<int>& to : problem.tasks)
    for (const std::vector<int>& from : problem.tasks) {
      least.push_back(kNone);
      for (const int a : from)
        for (const int b : to)
          least.back() = std::min(least.back(), lengths[static_cast<std::size_t>(a) * stops + b]);
    }
  return least;
}

// A closed way without a start: from each stop of the task that has fewest. Ways that are longer
// than a guess are left out, as the least legs between tasks have it (a relaxation of the state
// space: Christofides, Mingozzi & Toth 1981); where it was too small a greater one is made.
std::optional<std::vector<int>> exact_ring(const RouteProblem& problem, int stops,
                                           const std::vector<double>& lengths, Poller& poller) {
  const Ends& ends = problem.routes.front();
  const std::vector<int>& firsts = fewest(problem);
  const std::vector<double> least_back = least_legs_back(problem, stops, lengths);
  RouteProblem tasks{{}, problem.routes, 0};
  tasks.tasks.reserve(problem.tasks.size());
  for (int task = 0; task < problem.size(); ++task) tasks.tasks.push_back({task});
  SubsetWays home(tasks, problem.size(), least_back);
  const auto at = std::find(problem.tasks.begin(), problem.tasks.end(), firsts);
  if (!home.run(ends, static_cast<int>(at - problem.tasks.begin()), poller)) return std::nullopt;

  SubsetWays ways(problem, stops, lengths);
  const unsigned all = ways.subsets() - 1;
  const double least = home.least(all);
  std::vector<int> best;
  for (double beyond = least / 256 + 1; best.empty(); beyond *= 4) {
    double most = beyond < least ? least + beyond : kNone;
    for (const int first : firsts) {
      if (!ways.run(ends, first, poller, most, &home)) return std::nullopt;
      if (ways.least(all) >= most) continue;
      most = ways.least(all);
      best = ways.way(all);
    }
    if (most == kNone) break;
  }
  return best;
}

}  // namespace

std::optional<std::vector<std::vector<int>>> exact_routes(const RouteProblem& problem, int stops,
                                                          const std::vector<double>& lengths,
                                                          Poller& poller) {
  const std::size_t count = problem.routes.size();
  if (too_many(problem)) return std::nullopt;
  if (is_ring(problem)) {
    const auto order = exact_ring(problem, stops, lengths, poller);
    if (!order) return std::nullopt;
    return std::vector<std::vector<int>>{*order};
  }
  SubsetWays ways(problem, stops, lengths);
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
