#include "core/tour/routes/route_bound.h"

#include <algorithm>

#include "core/tour/order/ascend.h"
#include "core/tour/routes/exact_routes.h"
#include "core/tour/routes/walk_bound.h"

namespace lasius::tour {

namespace {

constexpr double kStepsOfPatience = 5e6;  // pairs of stops without gain

// The ascent over trees of tasks. In a solution all legs of a task are at one stop. So each stop
// has a price, which its legs pay, and a toll for each other task, which a leg there pays besides
// (as Fischetti, Salazar & Toth 1997 bound a leg by its stop); refunded are, to one stop of each
// task, where that is most, two prices and all tolls: a solution pays no more than is refunded to
// it.
class Ascent {
 public:
  Ascent(const RouteProblem& problem, const Costs& costs, Poller& poller)
      : poller_(poller), tasks_(problem.size()), ring_(problem.ring()) {
    for (int task = 0; task < tasks_; ++task) {
      first_.push_back(static_cast<int>(stops_.size()));
      stops_.insert(stops_.end(), problem.tasks[task].begin(), problem.tasks[task].end());
    }
    n_ = static_cast<int>(stops_.size());
    first_.push_back(n_);
    matrix_.resize(static_cast<std::size_t>(n_) * n_);
    for (int a = 0; a < n_; ++a)
      for (int b = 0; b < a; ++b)
        matrix_[index(a, b)] = matrix_[index(b, a)] = costs.lower(stops_[a], stops_[b]);
    set_depot(problem, costs);
    if (n_ > tasks_) now_.toll.assign(static_cast<std::size_t>(n_) * tasks_, 0);
    now_.tolls.assign(n_, 0);
    for (int task = 0; task < tasks_; ++task)
      task_of_.insert(task_of_.end(), problem.tasks[task].size(), task);
    now_.price.assign(n_, 0);
    degree_.assign(n_, 0);
  }

  bool has_choices() const { return n_ > tasks_; }
  // The greatest bound, scaled: every value is one.
  Sum run(Sum upper) {
    keep();
    last_.assign(n_, 0);
    return ascend(*this, upper, 0, {2, 1e-3, std::clamp(kStepsOfPatience / n_ / n_, 10.0, 100.0)});
  }

  // For ascend().
  Sum value() {
    const Sum value = tree();
    list_moves();
    return value;
  }
  void keep() { best_ = now_; }
  void back() { now_ = best_; }
  double squares() const {
    auto sum = static_cast<double>(moves_.size());
    for (const int degree : degree_) sum += degree * degree;
    return sum;
  }
  bool move(double step) {
    if (poller_.stop_after(static_cast<Sum>(n_) * n_)) return false;
    for (const auto& [at, by] : moves_) {
      const Sum more = std::max(-now_.toll[at], static_cast<Sum>(step * by));
      now_.toll[at] += more;
      now_.tolls[at / tasks_] += more;
    }
    for (int v = 0; v < n_; ++v) {
      now_.price[v] += static_cast<Sum>(step * (0.7 * degree_[v] + 0.3 * last_[v]));
      last_[v] = degree_[v];
    }
    return true;
  }

 private:
  struct Prices {
    std::vector<Sum> price, tolls;  // of each stop, and the sum of its tolls
    std::vector<Sum> toll;          // stop by stop, of each task; none where each task is one stop
  };
  struct Leg {
    Sum key = kFar;
    int from = -1, to = -1;  // places of stops; from -1: the depot
  };

  std::size_t index(int a, int b) const { return static_cast<std::size_t>(a) * n_ + b; }

  // Legs from the depot to where routes begin and back, each the least of all routes.
  void set_depot(const RouteProblem& problem, const Costs& costs) {
    if (ring_) return;
    const auto least = [&](int stop, const auto& end_of) {
      Cost cost = kLargest;
      for (const Ends& ends : problem.routes) {
        const int end = end_of(ends);
        cost = std::min(cost, end < 0 ? 0 : costs.lower(end, stop));
      }
      return cost;
    };
    for (const int stop : stops_) {
      from_depot_.push_back(least(stop, [](const Ends& ends) { return ends.start; }));
      to_depot_.push_back(
          least(stop, [](const Ends& ends) { return ends.open ? ends.goal : ends.start; }));
    }
    fewest_ = (tasks_ + problem.room() - 1) / problem.room();
    most_ = std::min(static_cast<int>(problem.routes.size()), tasks_);
  }

  // The cheapest leg between two tasks.
  void better(int a, int b, Leg& best) const {
    for (int v = first_[a]; v < first_[a + 1]; ++v)
      for (int w = first_[b]; w < first_[b + 1]; ++w) {
        const Sum key =
            matrix_[index(v, w)] * kScale + now_.price[v] + now_.price[w] + toll(v, b) + toll(w, a);
        if (key < best.key) best = {key, v, w};
      }
  }
  Leg of_depot(int task, const std::vector<Cost>& costs) const {
    Leg best;
    for (int v = first_[task]; v < first_[task + 1]; ++v) {
      const Sum key = costs[v] * kScale + now_.price[v];
      if (key < best.key) best = {key, -1, v};
    }
    return best;
  }
  std::size_t pair_of(int v, int task) const { return static_cast<std::size_t>(v) * tasks_ + task; }
  Sum toll(int v, int task) const { return now_.toll.empty() ? 0 : now_.toll[pair_of(v, task)]; }
  // Tolls rise for a leg at a stop that is refunded nothing, and fall of one that is and has none.
  void list_moves() {
    moves_.clear();
    if (now_.toll.empty()) return;
    std::sort(pairs_.begin(), pairs_.end());
    for (const std::size_t at : pairs_) {
      const int v = static_cast<int>(at / tasks_);
      if (chosen_[task_of_[v]] != v) moves_.emplace_back(at, 1);
    }
    for (const int v : chosen_)
      for (int task = 0; task < tasks_; ++task)
        if (toll(v, task) > 0 &&
            !std::binary_search(pairs_.begin(), pairs_.end(), pair_of(v, task)))
          moves_.emplace_back(pair_of(v, task), -1);
  }
  Sum refund(int v) const { return 2 * now_.price[v] + now_.tolls[v]; }
  Sum take(const Leg& leg) {
    if (leg.from >= 0) {
      ++degree_[leg.from];
      pairs_.push_back(pair_of(leg.from, task_of_[leg.to]));
      pairs_.push_back(pair_of(leg.to, task_of_[leg.from]));
    }
    ++degree_[leg.to];
    return leg.key;
  }

  // The value of a least tree with its legs more, less the refunds; `degree_`: legs at each stop,
  // less two where these are refunded.
  Sum tree() {
    std::fill(degree_.begin(), degree_.end(), 0);
    pairs_.clear();
    chosen_.clear();
    std::vector<Leg> leg(tasks_);
    std::vector<int> parent(tasks_, -1), legs(tasks_, 0);
    std::vector<char> in(tasks_, 0);
    for (int task = 0; task < tasks_ && !ring_; ++task) leg[task] = of_depot(task, from_depot_);
    Sum value = 0;
    for (int count = 0; count < tasks_; ++count) {
      int now = -1;
      for (int task = 0; task < tasks_; ++task)
        if (!in[task] && (now < 0 || leg[task].key < leg[now].key)) now = task;
      in[now] = 1;
      if (leg[now].to >= 0) value += take(leg[now]);
      if (parent[now] >= 0) ++legs[parent[now]], ++legs[now];
      for (int task = 0; task < tasks_; ++task) {
        if (in[task]) continue;
        const Sum before = leg[task].key;
        better(now, task, leg[task]);
        if (leg[task].key < before) parent[task] = now;
      }
    }
    value += ring_ ? closing_leg(parent, legs) : returns();
    for (int task = 0; task < tasks_; ++task) {
      int dearest = first_[task];
      for (int v = dearest + 1; v < first_[task + 1]; ++v)
        if (refund(v) > refund(dearest) ||
            (refund(v) == refund(dearest) && degree_[v] > degree_[dearest]))
          dearest = v;
      value -= refund(dearest);
      chosen_.push_back(dearest);
      degree_[dearest] -= 2;
    }
    return value;
  }

  // Of the leaf whose second leg is dearest.
  Sum closing_leg(const std::vector<int>& parent, const std::vector<int>& legs) {
    Leg dearest{-kFar, -1, -1};
    for (int task = 0; task < tasks_; ++task) {
      if (legs[task] != 1) continue;
      Leg second;
      for (int other = 0; other < tasks_; ++other)
        if (other != task && parent[task] != other && parent[other] != task)
          better(task, other, second);
      if (second.to >= 0 && second.key > dearest.key) dearest = second;
    }
    return take(dearest);
  }

  // In each route all legs but the last make a part of the tree, and each last leg is of another
  // task: the cheapest, of as many routes as is cheapest.
  Sum returns() {
    std::vector<Leg> back;
    back.reserve(static_cast<std::size_t>(tasks_));
    for (int task = 0; task < tasks_; ++task) back.push_back(of_depot(task, to_depot_));
    std::partial_sort(
        back.begin(), back.begin() + most_, back.end(),
        [](const Leg& a, const Leg& b) { return a.key != b.key ? a.key < b.key : a.to < b.to; });
    Sum value = 0;
    for (int i = 0; i < most_ && (i < fewest_ || back[i].key < 0); ++i) value += take(back[i]);
    return value;
  }

  Poller& poller_;
  int tasks_, n_ = 0;
  bool ring_;
  int most_ = 1, fewest_ = 1;
  std::vector<int> stops_, first_;  // task by task, and where each begins
  std::vector<Cost> matrix_, from_depot_, to_depot_;
  Prices now_, best_;
  std::vector<int> task_of_, chosen_;  // of each stop; of each task what is refunded
  std::vector<std::size_t> pairs_;     // of stops and tasks that a leg of the tree joins
  std::vector<std::pair<std::size_t, int>> moves_;  // of tolls
  std::vector<int> degree_, last_;                  // and of the tree before
};

}  // namespace

std::int64_t routes_bound(const RouteProblem& problem, const Costs& costs, std::int64_t upper,
                          Poller& poller) {
  const int n = problem.size();
  if (n == 0 || (problem.ring() && n < 3)) return 0;
  Ascent ascent(problem, costs, poller);
  const Sum scaled = ascent.run(upper * kScale);
  const Sum bound = std::min(upper, (scaled + kScale - 1) / kScale);
  if (bound == upper || !ascent.has_choices()) return bound;
  return std::max(bound, walk_bound(problem, costs, upper, poller));
}

std::int64_t least_cost(const RouteProblem& problem, const Costs& costs, bool open,
                        std::int64_t upper, Poller& poller) {
  if (const auto orders = exact_routes(problem, costs, poller))
    return cost_of(costs, *orders, open);
  return routes_bound(problem, costs, upper, poller);
}

}  // namespace lasius::tour
