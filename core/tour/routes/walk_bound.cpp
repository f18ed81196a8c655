#include "core/tour/routes/walk_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/tour/order/ascend.h"

namespace lasius::tour {

namespace {

// Steps of all turns; more memory is worth more than more turns, down to these.
constexpr double kMostWalkSteps = 1.5e9, kFewestTurns = 20, kMostTurns = 200;
constexpr int kMostNear = 7;  // tasks that a walk remembers at a stop
constexpr std::size_t kMostBytes = 64'000'000;

class WalkAscent {
 public:
  WalkAscent(const RouteProblem& problem, const Costs& costs, Poller& poller) : poller_(poller) {
    // A ring is begun with the task of fewest stops, which is done at no other time.
    int first = -1;
    if (problem.ring())
      first = static_cast<int>(
          std::min_element(problem.tasks.begin(), problem.tasks.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); }) -
          problem.tasks.begin());
    for (int task = 0; task < problem.size(); ++task) {
      if (task == first) continue;
      for (const int stop : problem.tasks[task]) {
        stops_.push_back(stop);
        task_.push_back(tasks_);
      }
      ++tasks_;
    }
    n_ = static_cast<int>(stops_.size());
    choose_memory();
    if (near_ < 2) return;
    const Ends& ends = problem.routes.front();
    const int last = ends.open ? ends.goal : ends.start;
    if (first >= 0)
      set_ends(costs, problem.tasks[first], problem.tasks[first]);
    else
      set_ends(costs, {ends.start}, {last});
    for (const int a : stops_)
      for (const int b : stops_) matrix_.push_back(costs.lower(a, b) * kScale);
    price_.assign(static_cast<std::size_t>(tasks_), 0);
    shift_.assign(begins_, 0);
  }

  // The greatest bound, scaled: every value is one.
  Sum run(Sum upper) {
    if (near_ < 2) return 0;
    number_states();
    keep();
    const double turns = std::min(kMostWalkSteps / steps(), kMostTurns);
    return ascend(*this, upper, 0, {1, 1e-3, std::floor(turns / 16) + 1, turns});
  }

  // For ascend().
  // The cheapest walk's value; `times_`: how often it does each task. kFar once stopped.
  Sum value() {
    layers_.resize(static_cast<std::size_t>(tasks_));
    for (auto& layer : layers_) layer.assign(states(), kFar);
    for (int v = 0; v < n_; ++v)
      layers_[0][state(v, 1)] = nearest_end(from_, v, 1).first - price_[task_[v]];
    std::vector<Sum> leg(n_);
    for (int k = 0; k + 1 < tasks_; ++k) {
      std::vector<Sum>& next = layers_[k + 1];
      for (int v = 0; v < n_; ++v) {
        drop_dominated(layers_[k], v);
        for (int w = 0; w < n_; ++w) leg[w] = matrix_[at(v, w)] - price_[task_[w]];
        for (int done = 1; done < 1 << near_; done += 2) {
          const Sum cost = layers_[k][state(v, done)];
          if (cost >= kFar) continue;
          const std::uint16_t* const leads = leads_.data() + state(v, done) * n_;
          for (int w = 0; w < n_; ++w) {
            Sum& known = next[state(w, leads[w])];
            known = std::min(known, cost + leg[w]);
          }
        }
        // Where no leg leads is what has not done its own task: none reads it.
      }
      if (poller_.stop_after(static_cast<Sum>(states()) * n_ / 2)) return kFar;
    }
    Sum least = kFar;
    int v = -1, done = 0;
    for (int w = 0; w < n_; ++w)
      for (int d = 1; d < 1 << near_; d += 2) {
        const Sum cost = layers_.back()[state(w, d)];
        if (cost >= kFar) continue;
        const Sum all = cost + nearest_end(to_, w, -1).first;
        if (all < least) least = all, v = w, done = d;
      }
    if (v < 0) return kFar;
    trace(v, done);
    for (const Sum price : price_) least += price;
    return least;
  }
  void keep() {
    best_price_ = price_;
    best_shift_ = shift_;
  }
  void back() {
    price_ = best_price_;
    shift_ = best_shift_;
  }
  double squares() const {
    double sum = begin_ == end_ ? 0 : 2;
    for (const int times : times_) sum += (1 - times) * (1 - times);
    return sum;
  }
  bool move(double along) {
    const auto step = static_cast<Sum>(along);
    for (int task = 0; task < tasks_; ++task) price_[task] += step * (1 - times_[task]);
    if (begin_ == end_) return true;
    shift_[begin_] += step;
    shift_[end_] -= step;
    return true;
  }

 private:
  // Legs to and from where walks begin and end: one of `first`, and the same one of `last`.
  void set_ends(const Costs& costs, const std::vector<int>& first, const std::vector<int>& last) {
    begins_ = first.size();
    for (std::size_t i = 0; i < begins_; ++i)
      for (const int stop : stops_) {
        from_.push_back(first[i] < 0 ? 0 : costs.lower(first[i], stop) * kScale);
        to_.push_back(last[i] < 0 ? 0 : costs.lower(stop, last[i]) * kScale);
      }
  }

  std::size_t states() const { return static_cast<std::size_t>(n_) << near_; }
  double steps() const { return 0.5 * static_cast<double>(states()) * n_ * tasks_; }

  // How many tasks a walk remembers; below 2 where stops are too many.
  void choose_memory() {
    for (near_ = std::min(kMostNear, tasks_); near_ > 1; --near_)
      if (steps() * kFewestTurns <= kMostWalkSteps &&
          states() * n_ * sizeof(leads_[0]) <= kMostBytes)
        break;
  }

  // At each stop a walk remembers its task and the nearest others: of each state of a stop, which
  // are such tasks done, the state that a leg to each other stop leads to.
  void number_states() {
    std::vector<std::vector<int>> remembered(n_);
    std::vector<int> bit(static_cast<std::size_t>(n_) * tasks_, -1);
    for (int v = 0; v < n_; ++v) {
      std::vector<std::pair<Sum, int>> near(tasks_, {kFar, 0});
      for (int task = 0; task < tasks_; ++task) near[task].second = task;
      for (int w = 0; w < n_; ++w)
        near[task_[w]].first = std::min(near[task_[w]].first, matrix_[at(v, w)]);
      near[task_[v]].first = -1;
      std::partial_sort(near.begin(), near.begin() + near_, near.end());
      for (int i = 0; i < near_; ++i) {
        remembered[v].push_back(near[i].second);
        bit[static_cast<std::size_t>(v) * tasks_ + near[i].second] = i;
      }
    }
    leads_.assign(states() * n_, kNowhere);
    for (int v = 0; v < n_; ++v)
      for (int done = 1; done < 1 << near_; done += 2)  // its own task is the first
        for (int w = 0; w < n_; ++w) {
          const int own = bit[static_cast<std::size_t>(v) * tasks_ + task_[w]];
          if (own >= 0 && (done >> own & 1) != 0) continue;
          int after = 1;
          for (int i = 1; i < near_; ++i) {
            const int still = bit[static_cast<std::size_t>(w) * tasks_ + remembered[v][i]];
            if ((done >> i & 1) != 0 && still > 0) after |= 1 << still;
          }
          const int before = bit[static_cast<std::size_t>(w) * tasks_ + task_[v]];
          if (before > 0) after |= 1 << before;
          leads_[(state(v, done)) * n_ + w] = static_cast<std::uint16_t>(after);
        }
  }

  std::size_t at(int v, int w) const { return static_cast<std::size_t>(v) * n_ + w; }
  std::size_t state(int v, int done) const {
    return (static_cast<std::size_t>(v) << near_) + static_cast<std::size_t>(done);
  }

  // What has done less for less is the better one.
  void drop_dominated(std::vector<Sum>& layer, int v) const {
    for (int done = 1; done < 1 << near_; done += 2) {
      Sum& cost = layer[state(v, done)];
      for (int less = (done - 1) & done; less > 0 && cost < kFar; less = (less - 1) & done)
        if ((less & 1) != 0 && layer[state(v, less)] <= cost) cost = kFar;
    }
  }

  // The leg from where a walk begins to a stop, or to where it ends, and which of these that is.
  std::pair<Sum, std::size_t> nearest_end(const std::vector<Sum>& legs, int v, int sign) const {
    std::pair<Sum, std::size_t> least{kFar, 0};
    for (std::size_t i = 0; i < begins_; ++i)
      least = std::min(least, {legs[i * n_ + v] + sign * shift_[i], i});
    return least;
  }

  // How often the walk that ends in a state does each task, and where it begins and ends.
  void trace(int v, int done) {
    times_.assign(static_cast<std::size_t>(tasks_), 0);
    end_ = nearest_end(to_, v, -1).second;
    for (int k = tasks_ - 1;; --k) {
      ++times_[task_[v]];
      if (k == 0) break;
      const Sum cost = layers_[k][state(v, done)] + price_[task_[v]];
      const auto [w, d] = before(layers_[k - 1], v, done, cost);
      v = w;
      done = d;
    }
    begin_ = nearest_end(from_, v, 1).second;
  }
  std::pair<int, int> before(const std::vector<Sum>& layer, int v, int done, Sum cost) const {
    for (int w = 0; w < n_; ++w)
      for (int d = 1; d < 1 << near_; d += 2)
        if (layer[state(w, d)] < kFar && leads_[state(w, d) * n_ + v] == done &&
            layer[state(w, d)] + matrix_[at(w, v)] == cost)
          return {w, d};
    return {v, done};  // not reached
  }

  static constexpr std::uint16_t kNowhere = 0;

  Poller& poller_;
  int tasks_ = 0, n_ = 0;
  std::vector<int> stops_, task_;  // of the stops: their numbers, and the tasks they do
  std::size_t begins_ = 0;         // of how many stops one is where the walk begins and ends
  std::vector<Sum> matrix_, from_, to_;
  // Of tasks; of where walks begin, and taken off where they end; and those of the best walk.
  std::vector<Sum> price_, shift_, best_price_, best_shift_;
  int near_ = 0;
  std::vector<std::uint16_t> leads_;
  std::vector<std::vector<Sum>> layers_;
  std::vector<int> times_;
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace

std::int64_t walk_bound(const RouteProblem& problem, const Costs& costs, std::int64_t upper,
                        Poller& poller) {
  if (problem.routes.size() != 1 || problem.size() < 3) return 0;
  const Sum bound = WalkAscent(problem, costs, poller).run(upper * kScale);
  return std::min(upper, (bound + kScale - 1) / kScale);
}

}  // namespace lasius::tour
