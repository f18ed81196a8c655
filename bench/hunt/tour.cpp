// Tours over few stops with every option, against all orders.
#include "lasius/tour.h"

#include <algorithm>
#include <array>
#include <limits>

#include "bench/hunt/drawing.h"
#include "tests/oracle/visibility_graph.h"

namespace lasius::bench {
namespace {

constexpr int kFew = 6;  // stops of which all orders are looked at
constexpr double kNever = std::numeric_limits<double>::infinity();

// The shortest of all tours: every order, every way to share it out and every stop of a task.
class AllTours {
 public:
  AllTours(const TourRequest& request, std::vector<double> legs)
      : request_(request), legs_(std::move(legs)), count_(request.stops.size()) {
    if (request.robots.empty()) starts_ = {request.start.value_or(-1)};
    for (const int start : request.robots) starts_.push_back(start);
  }

  double least() {
    visited_.assign(count_, false);
    for (const int start : request_.robots) visited_[static_cast<std::size_t>(start)] = true;
    robot(0, 0);
    return least_;
  }

  /// Whether the stops of a task are all visited, or one of them where it has several.
  bool done(int stop) const {
    const auto s = static_cast<std::size_t>(stop);
    if (visited_[s]) return true;
    if (request_.group.empty() || request_.group[s] < 0) return false;
    for (std::size_t i = 0; i < count_; ++i)
      if (request_.group[i] == request_.group[s] && visited_[i]) return true;
    return false;
  }

 private:
  double leg(int a, int b) const {
    return legs_[static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b)];
  }

  void robot(std::size_t r, double sum) {
    if (r == starts_.size()) {
      for (std::size_t i = 0; i < count_; ++i)
        if (!done(static_cast<int>(i))) return;
      least_ = std::min(least_, sum);
      return;
    }
    if (starts_[r] < 0) {  // any stop
      for (int first = 0; first < static_cast<int>(count_); ++first) begin(r, first, sum);
    } else {
      begin(r, starts_[r], sum);
    }
  }

  void begin(std::size_t r, int first, double sum) {
    const auto s = static_cast<std::size_t>(first);
    const bool before = visited_[s];
    visited_[s] = true;
    if (allowed(first, 0)) go_on(r, first, first, 0, load_of(first), sum);
    visited_[s] = before;
  }

  void go_on(std::size_t r, int first, int last, int driven, std::int64_t carried, double sum) {
    if (!request_.goal || last == *request_.goal)
      robot(r + 1, sum + (request_.open ? 0 : leg(last, first)));
    if (!request_.robots.empty() && request_.most_stops > 0 && driven == request_.most_stops)
      return;
    for (int next = 0; next < static_cast<int>(count_); ++next) {
      if (done(next) || !allowed(next, carried)) continue;
      visited_[static_cast<std::size_t>(next)] = true;
      go_on(r, first, next, driven + 1, carried + load_of(next), sum + leg(last, next));
      visited_[static_cast<std::size_t>(next)] = false;
    }
  }

  std::int64_t load_of(int stop) const {
    return request_.load.empty() ? 0 : request_.load[static_cast<std::size_t>(stop)];
  }

  bool allowed(int stop, std::int64_t carried) const {
    if (request_.capacity && carried + load_of(stop) > *request_.capacity) return false;
    if (request_.after.empty()) return true;
    return std::ranges::all_of(request_.after[static_cast<std::size_t>(stop)], [&](int before) {
      return bool{visited_[static_cast<std::size_t>(before)]};
    });
  }

  const TourRequest& request_;
  std::vector<double> legs_;
  std::size_t count_;
  std::vector<int> starts_;
  std::vector<bool> visited_;
  double least_ = kNever;
};

// The same of one robot, without tasks of several stops, by a program over subsets: for more stops.
double least_by_subsets(const TourRequest& request, const std::vector<double>& legs) {
  const auto n = request.stops.size();
  const std::size_t all = std::size_t{1} << n;
  std::vector<std::size_t> before(n, 0);
  for (std::size_t i = 0; i < request.after.size(); ++i)
    for (const int b : request.after[i]) before[i] |= std::size_t{1} << b;
  const auto allowed = [&](std::size_t visited, std::size_t next) {
    if ((before[next] & ~visited) != 0) return false;
    if (!request.capacity) return true;
    std::int64_t carried = request.load[next];
    for (std::size_t i = 0; i < n; ++i)
      if ((visited >> i & 1) != 0) carried += request.load[i];
    return carried <= *request.capacity;
  };
  const bool any_first = request.after.empty() && !request.capacity;  // of a closed tour
  double least = kNever;
  std::vector<double> cost;
  for (std::size_t first = 0; first < n; ++first) {
    if (request.start && static_cast<std::size_t>(*request.start) != first) continue;
    if (!request.open && !request.start && any_first && first > 0) break;
    if (!allowed(0, first)) continue;
    cost.assign(all * n, kNever);
    cost[(std::size_t{1} << first) * n + first] = 0;
    for (std::size_t visited = 1; visited < all; ++visited)
      for (std::size_t last = 0; last < n; ++last) {
        const double so_far = cost[visited * n + last];
        for (std::size_t next = 0; so_far < kNever && next < n; ++next) {
          const std::size_t with = visited | std::size_t{1} << next;
          if (with == visited || !allowed(visited, next)) continue;
          double& known = cost[with * n + next];
          known = std::min(known, so_far + legs[last * n + next]);
        }
      }
    for (std::size_t last = 0; last < n; ++last) {
      if (request.goal && static_cast<std::size_t>(*request.goal) != last) continue;
      const double back = request.open ? 0 : legs[last * n + first];
      least = std::min(least, cost[(all - 1) * n + last] + back);
    }
  }
  return least;
}

// Whether an order of one robot keeps what is given of it, and visits all.
bool keeps_order(const TourRequest& request, const TourResult& got) {
  std::vector<bool> visited(request.stops.size(), false);
  std::int64_t carried = 0;
  for (const int stop : got.order) {
    const auto s = static_cast<std::size_t>(stop);
    if (visited[s]) return false;
    for (std::size_t b = 0; !request.after.empty() && b < request.after[s].size(); ++b)
      if (!visited[static_cast<std::size_t>(request.after[s][b])]) return false;
    if (request.capacity && (carried += request.load[s]) > *request.capacity) return false;
    visited[s] = true;
  }
  return std::ranges::all_of(visited, [](bool v) { return v; }) &&
         (!request.start || got.order.front() == *request.start) &&
         (!request.goal || got.order.back() == *request.goal);
}

tour::AntParams draw_ants(HuntDraw& draw) {
  constexpr std::array kFamilies{"as", "eas", "ras", "mmas", "acs", "has-sop", "eacs"};
  tour::AntParams ants(draw.pick(kFamilies));
  ants.iterations = draw.between(1, 5);
  if (draw.one_in(2)) ants.local_search = tour::Improvement::pieces;
  return ants;
}

TourRequest draw_tour(HuntDraw& draw, const std::vector<Cell>& stops) {
  const int count = static_cast<int>(stops.size());
  TourRequest request;
  request.stops = stops;
  request.seed = draw.any() >> 12;
  request.open = draw.one_in(2);
  // Plain, order given in part, tasks, robots.
  const int kind = draw.between(0, count > kFew ? 1 : 3);
  if (kind < 3 && draw.one_in(2)) request.start = draw.between(0, count - 1);
  if (kind < 3 && request.open && draw.one_in(2)) {
    request.goal = draw.between(0, count - 1);
    if (request.start == request.goal) request.goal.reset();
  }
  if (kind == 1) {
    request.after.resize(stops.size());
    for (int i = draw.between(0, 3); i > 0; --i) {
      const int a = draw.between(0, count - 1), b = draw.between(0, count - 1);
      if (a < b) request.after[static_cast<std::size_t>(b)].push_back(a);  // hence no cycle
    }
    if (draw.one_in(2)) {
      for (int i = 0; i < count; ++i) request.load.push_back(draw.between(-2, 2));
      request.capacity = draw.between(1, 4);
    }
  }
  if (kind >= 2) {
    for (int i = 0; i < count; ++i)
      request.group.push_back(draw.one_in(2) ? draw.between(0, 1) : -1);
    if (kind == 3) {
      request.robots = {0};
      if (count > 3 && draw.one_in(2)) request.robots.push_back(1);
      if (draw.one_in(3)) request.most_stops = draw.between(1, 4);
    }
    // Whoever is there in any case is a task of its own.
    for (const int stop : request.robots) request.group[static_cast<std::size_t>(stop)] = -1;
    for (const auto& end : {request.start, request.goal})
      if (end) request.group[static_cast<std::size_t>(*end)] = -1;
  }
  return request;
}

}  // namespace

HuntVerdict judge_tour(const HuntCase& problem) {
  HuntVerdict verdict;
  if (!well_posed(problem)) return verdict;
  HuntDraw draw(problem.seed);
  const Planner planner(Grid(problem.grid));
  const oracle::VisibilityGraph oracle(problem.grid);
  std::vector<Cell> stops;  // those that are joined to the first
  for (const Cell place : problem.places)
    if (oracle.shortest(problem.places[0], place)) stops.push_back(place);
  if (stops.size() < 2) return verdict;
  std::vector<double> legs;
  for (const Cell a : stops)
    for (const Cell b : stops) legs.push_back(oracle.shortest(a, b)->length);

  for (int i = 0; i < (stops.size() > kFew ? 2 : 8); ++i) {
    TourRequest request = draw_tour(draw, stops);
    const bool one = request.group.empty() && request.robots.empty();
    const double best =
        stops.size() > kFew ? least_by_subsets(request, legs) : AllTours(request, legs).least();
    const bool ants = one && draw.one_in(4);
    if (ants) request.ants = draw_ants(draw);
    if (stops.size() > kFew) request.generations = draw.between(0, 2);
    const TourResult got = plan_tour(planner, request);
    double sum = 0;
    std::string fault;
    for (const TourLeg& leg : got.legs) {
      sum += leg.length;
      if (fault.empty())
        fault =
            path_fault(problem.grid, leg.path, centre(stops[static_cast<std::size_t>(leg.from)]),
                       centre(stops[static_cast<std::size_t>(leg.to)]), leg.length);
    }
    const auto right = [&] {
      // Where an order is given in part, a search and ants may find none.
      const bool may_fail =
          (ants || stops.size() > 12) && !(request.after.empty() && !request.capacity);
      if (got.order.empty())
        return std::isinf(best) ? got.status == Status::unreachable || may_fail
                                : may_fail && got.status == Status::no_path;
      if (got.status != Status::solved || !fault.empty() || !same_length(sum, got.length))
        return false;
      if (one && !keeps_order(request, got)) return false;
      const bool exact = !ants && stops.size() <= 12;
      return got.length >= best - 1e-9 * (1 + best) && (!exact || got.optimal) &&
             (!got.optimal || same_length(got.length, best)) &&
             got.lower_bound.value_or(0) <= best * (1 + 1e-9);
    };
    verdict.expect(right(), [&] {
      return sentence("tour ", i, " by ", request.ants.algorithm(), ": ", to_string(got.status),
                      got.optimal ? ", optimal, " : ", ", got.length, " above ",
                      got.lower_bound.value_or(-1), " in place of ", best, ' ', got.error, fault);
    });
  }
  return verdict;
}

}  // namespace lasius::bench
