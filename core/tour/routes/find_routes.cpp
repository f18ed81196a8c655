#include "core/tour/routes/find_routes.h"

#include <algorithm>
#include <numeric>

#include "core/tour/order/search.h"
#include "core/tour/routes/best_members.h"
#include "core/tour/routes/exact_routes.h"
#include "core/tour/routes/route_state.h"
#include "kernels/base/power.h"
#include "kernels/base/random_stream.h"

namespace lasius::tour {

namespace {

constexpr std::uint32_t kUse = 0x726f7574;
constexpr int kNear = 10;       // tasks beside which a task is put
constexpr int kMostTaken = 30;  // tasks a step, a third of all at most
constexpr double kHot = 0.5;    // mean legs: the first temperature of a generation
constexpr double kLog2 = 0.69314718055994531;
constexpr int kGenerationsOfOne = 5;  // of the tour that robots share
constexpr int kStepsOfGeneration = 2000, kStepsOfTask = 20;

// The costs between some of the stops.
struct Among final : Pricer {
  Among(const Costs& all, const std::vector<int>& some) : costs(all), stops(some) {}
  Cost price(int a, int b) override { return costs(stops[a], stops[b]); }
  Cost lower(int a, int b) const override { return costs.lower(stops[a], stops[b]); }
  Cost largest() const override { return costs.largest(); }
  const Costs& costs;
  const std::vector<int>& stops;
};

class RouteSearch {
 public:
  RouteSearch(const RouteProblem& problem, const Costs& costs, const RouteOptions& options)
      : problem_(problem),
        costs_(costs),
        options_(options),
        poller_(options.stop, 1 << 12),
        random_(options.seed, 0, 0, kUse),
        now_(problem, costs),
        best_(now_),
        before_(now_) {}

  RoutesFound run() {
    const int n = problem_.size();
    list_near();
    std::vector<int> all(n);
    std::iota(all.begin(), all.end(), 0);
    put_in(all, false);
    best_ = now_;
    if (problem_.routes.size() > 1) share_one_tour();
    const bool polished = polish();
    bool more = offer() && polished;
    const std::int64_t steps = kStepsOfGeneration + std::int64_t{kStepsOfTask} * n;
    for (int generation = 0; more && n > 2 && generation < options_.generations; ++generation) {
      now_ = best_;
      const double hot = kHot * static_cast<double>(best_.cost()) / n;
      for (std::int64_t i = 0; more && i < steps; ++i)
        more = step(hot * (1 - static_cast<double>(i) / static_cast<double>(steps)));
      if (more) more = polish() && offer();
    }
    offer();
    found_.cause = poller_.cause();
    return std::move(found_);
  }

 private:
  // Tasks that are nearest, by their least costs.
  void list_near() {
    const int n = problem_.size();
    near_.resize(n);
    std::vector<std::pair<Cost, int>> row;
    for (int a = 0; a < n; ++a) {
      row.clear();
      for (int b = 0; b < n; ++b) {
        if (a == b) continue;
        Cost least = kLargest;
        for (const int v : problem_.tasks[a])
          for (const int w : problem_.tasks[b]) least = std::min(least, costs_.lower(v, w));
        row.emplace_back(least, b);
      }
      const auto count = std::min<std::size_t>(row.size(), kMostTaken);
      std::partial_sort(row.begin(), row.begin() + static_cast<long>(count), row.end());
      for (std::size_t i = 0; i < count; ++i) near_[a].push_back(row[i].second);
    }
  }

  // Each where it is cheapest beside near tasks; `loose`: not beside all of them. `wanted`: a route
  // that most of them join; -1: none.
  void put_in(std::vector<int>& out, bool loose, int wanted = -1) {
    for (int left = static_cast<int>(out.size()); left > 0; --left) {
      std::swap(out[random_.below(left)], out[left - 1]);
      const int task = out[left - 1];
      RouteState::Place best;
      const int only = wanted >= 0 && random_.below(4) > 0 ? wanted : -1;
      now_.try_ends(task, only, best);
      int tried = 0;
      for (const int other : near_[task]) {
        if (!now_.in(other) || (loose && random_.below(8) == 0)) continue;
        if (only >= 0 && now_.route(other) != only) continue;
        now_.try_beside(other, task, best);
        if (++tried == kNear) break;
      }
      if (!best.found()) now_.try_all(task, best);
      now_.insert(task, best);
    }
  }

  std::vector<int> taken_out() {
    const int n = problem_.size();
    const int most = std::min(kMostTaken, n - 1);
    const int count = 1 + random_.below(1 + random_.below(most));
    const int kind = random_.below(problem_.routes.size() > 1 ? 4 : 3), first = random_.below(n);
    std::vector<int> out{first};
    if (kind == 0) {
      int at = now_.next(first);
      for (; static_cast<int>(out.size()) < count && now_.is_task(at) && at != first;
           at = now_.next(at))
        out.push_back(at);
    } else if (kind == 1) {
      for (const int other : near_[first]) {
        if (static_cast<int>(out.size()) >= count) break;
        if (random_.below(4) > 0) out.push_back(other);
      }
    } else if (kind == 3 && now_.count(now_.route(first)) <= kMostTaken) {
      out = now_.tasks(now_.route(first));
    } else {
      while (static_cast<int>(out.size()) < count) {
        const int other = random_.below(n);
        if (std::find(out.begin(), out.end(), other) == out.end()) out.push_back(other);
      }
    }
    for (const int task : out) now_.remove(task);
    return out;
  }

  bool step(double temperature) {
    before_ = now_;
    std::vector<int> out = taken_out();
    const bool loose = random_.below(2) == 0;
    const int routes = static_cast<int>(problem_.routes.size());
    const bool wants = routes > 1 && random_.below(4) == 0;
    put_in(out, loose, wants ? random_.below(routes) : -1);
    if (now_.cost() < best_.cost()) {
      choose_members();
      best_ = now_;
      if (!offer()) return false;
    } else if (static_cast<double>(now_.cost() - before_.cost()) >=
               -temperature * kLog2 * kernels::log2_of((random_.next() + 0.5) * 0x1p-32)) {
      std::swap(now_, before_);
    }
    return !poller_.stop_after(64 + 40 * static_cast<std::int64_t>(out.size()));
  }

  // The cheapest stops of the order that is.
  void choose_members() {
    for (int r = 0; r < static_cast<int>(problem_.routes.size()); ++r) {
      const std::vector<int> tasks = now_.tasks(r);
      set_members(r, tasks);
    }
  }
  void set_members(int route, const std::vector<int>& tasks) {
    std::vector<const std::vector<int>*> layers;
    bool any = false;
    for (const int task : tasks) {
      layers.push_back(&problem_.tasks[task]);
      any = any || layers.back()->size() > 1;
    }
    if (!any) return;
    const Ends& ends = problem_.routes[route];
    now_.set(route, tasks,
             best_members(costs_, layers, problem_.ring(), ends.start,
                          ends.open ? ends.goal : ends.start));
  }

  // Orders the stops of each route of the best anew, and chooses them anew, as long as that helps.
  bool polish() {
    for (bool better = true; better && !poller_.stopped();) {
      now_ = best_;
      for (int r = 0; r < static_cast<int>(problem_.routes.size()); ++r) order_anew(r);
      better = now_.cost() < best_.cost();
      if (better) best_ = now_;
      if (poller_.stop_after(Poller::kSteps)) return false;
    }
    now_ = best_;
    return true;
  }
  void order_anew(int route) {
    const std::vector<int> tasks = now_.tasks(route);
    if (tasks.size() < 3) return set_members(route, tasks);
    Ends ends = problem_.routes[route];
    std::vector<int> stops, order, done_by;
    for (const int task : tasks) stops.push_back(now_.stop(task));
    for (int* const end : {&ends.start, &ends.goal}) {
      if (*end < 0) continue;
      stops.push_back(*end);
      *end = static_cast<int>(stops.size()) - 1;
    }
    const std::vector<int> found = ordered(stops, ends, 0);
    if (found.size() != stops.size()) return;
    RouteState before = now_;
    for (const int i : found)
      if (i < static_cast<int>(tasks.size())) {
        order.push_back(tasks[i]);
        done_by.push_back(stops[i]);
      }
    now_.set(route, order, done_by);
    set_members(route, order);
    if (now_.cost() >= before.cost()) {
      now_ = std::move(before);
      set_members(route, tasks);
    }
  }

  // An order of these stops, by their places.
  std::vector<int> ordered(const std::vector<int>& stops, const Ends& ends, int generations) const {
    const int n = static_cast<int>(stops.size());
    const OrderOptions options{
        .seed = options_.seed, .generations = generations, .stop = options_.stop};
    if (costs_.priced_late()) {  // a matrix would price all legs
      Among among(costs_, stops);
      return find_order({n, among}, ends, {}, options).order;
    }
    std::vector<Cost> matrix(static_cast<std::size_t>(n) * n, 0);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < a; ++b)
        matrix[a * n + b] = matrix[b * n + a] = costs_(stops[a], stops[b]);
    return find_order({n, matrix.data()}, ends, {}, options).order;
  }

  // One tour over all tasks and starts, as another beginning: open ones are cut before each start;
  // of closed ones one robot goes it alone.
  void share_one_tour() {
    const int n = problem_.size(), routes = static_cast<int>(problem_.routes.size());
    std::vector<int> stops;
    stops.reserve(static_cast<std::size_t>(n) + problem_.routes.size());
    for (int task = 0; task < n; ++task) stops.push_back(best_.stop(task));
    for (const Ends& ends : problem_.routes) stops.push_back(ends.start);
    std::vector<int> tour = ordered(stops, {}, std::min(options_.generations, kGenerationsOfOne));
    if (tour.size() != stops.size()) return;
    const bool open = problem_.routes.front().open;
    for (int turn = 0; turn < (open ? 2 : routes); ++turn) {
      std::vector<std::vector<int>> shares(routes);
      const int first = n + (open ? 0 : turn);
      std::rotate(tour.begin(), std::find(tour.begin(), tour.end(), first), tour.end());
      int robot = first - n;
      for (const int v : tour) {
        if (v < n)
          shares[robot].push_back(v);
        else if (open)
          robot = v - n;
      }
      const auto full = [&](const auto& share) {
        return static_cast<int>(share.size()) > problem_.room();
      };
      if (open) std::reverse(tour.begin(), tour.end());
      if (std::any_of(shares.begin(), shares.end(), full)) continue;
      now_ = RouteState(problem_, costs_);
      for (int r = 0; r < routes; ++r) {
        std::vector<int> own;
        for (const int task : shares[r]) own.push_back(stops[task]);
        now_.set(r, shares[r], own);
      }
      if (now_.cost() < best_.cost()) best_ = now_;
    }
    now_ = best_;
  }

  bool offer() {
    if (!found_.orders.empty() && best_.cost() >= found_.cost) return true;
    found_.orders = best_.orders();
    found_.cost = best_.cost();
    return (!options_.observer || options_.observer(found_)) && found_.cost > options_.target;
  }

  const RouteProblem& problem_;
  const Costs& costs_;
  const RouteOptions& options_;
  Poller poller_;
  kernels::RandomStream random_;
  RouteState now_, best_, before_;
  std::vector<std::vector<int>> near_;
  RoutesFound found_;
};

}  // namespace

RoutesFound find_routes(const RouteProblem& problem, const Costs& costs,
                        const RouteOptions& options) {
  Poller poller(options.stop);
  if (auto orders = exact_routes(problem, costs, poller)) {
    RoutesFound found{.orders = std::move(*orders), .optimal = true};
    found.cost = cost_of(costs, found.orders, problem.routes.front().open);
    if (options.observer) options.observer(found);
    return found;
  }
  return RouteSearch(problem, costs, options).run();
}

}  // namespace lasius::tour
