#include "core/tour/order/local_search.h"

#include <algorithm>

namespace lasius::tour {

namespace {

constexpr int kBreadth[] = {5, 3, 1};
constexpr int kLongestKicked = 30;

struct Step {
  int to, end;  // the candidate, and which of its neighbours it leaves
  std::int64_t gain;
};

}  // namespace

LocalSearch::LocalSearch(const Costs& costs, const Candidates& candidates, int depth)
    : depth_(depth), costs_(&costs), candidates_(&candidates), waits_(costs.size(), 0) {}

void LocalSearch::queue(int stop) {
  if (waits_[stop]) return;
  waits_[stop] = 1;
  waiting_.push_back(stop);
}

bool LocalSearch::run(ArrayTour& tour, Poller& poller) {
  while (!waiting_.empty()) {
    const int stop = waiting_.back();
    waiting_.pop_back();
    waits_[stop] = 0;
    work_ = 0;
    while (improve_at(tour, stop)) {
    }
    if (poller.stop_after(work_ + 1)) {
      for (const int left : waiting_) waits_[left] = 0;
      waiting_.clear();
      return false;
    }
  }
  return true;
}

bool LocalSearch::improve(ArrayTour& tour, Poller& poller) {
  for (int p = tour.size(); p-- > 0;) queue(tour.at(p));
  return run(tour, poller);
}

bool LocalSearch::improve_at(ArrayTour& tour, int stop) {
  t_[0] = stop;
  for (const bool forward : {true, false}) {
    t_[1] = forward ? tour.next(stop) : tour.previous(stop);
    if (deepen(tour, 1, forward ? tour.to_next(stop) : tour.to_previous(stop))) return true;
  }
  return false;
}

// t_[0 .. 2 level) are ends of `level` edges taken out; `gain` is theirs less that of those put in.
bool LocalSearch::deepen(ArrayTour& tour, int level, std::int64_t gain) {
  const int from = t_[2 * level - 1];
  Step steps[2 * kBreadth[0] + 2];
  int count = 0;
  const int breadth = kBreadth[level - 1];
  for (const auto& [to, cost] : candidates_->of(from)) {
    const std::int64_t left = gain - cost;
    if (left <= 0) break;
    ++work_;
    const int next = tour.next(to), previous = tour.previous(to);
    if (next == from || previous == from) continue;
    for (const int end : {next, previous}) {
      bool out = false;  // is that edge taken out already?
      for (std::ptrdiff_t i = 0; i < level && !out; ++i)
        out =
            (t_[2 * i] == to && t_[2 * i + 1] == end) || (t_[2 * i] == end && t_[2 * i + 1] == to);
      if (out) continue;
      const Step step{to, end, left + (end == next ? tour.to_next(to) : tour.to_previous(to))};
      if (count == breadth && step.gain <= steps[count - 1].gain) continue;
      int at = count < breadth ? count++ : count - 1;
      for (; at > 0 && steps[at - 1].gain < step.gain; --at) steps[at] = steps[at - 1];
      steps[at] = step;
    }
  }
  for (int i = 0; i < count; ++i) {
    int* const taken = t_ + std::ptrdiff_t{2} * level;
    taken[0] = steps[i].to;
    taken[1] = steps[i].end;
    const int end = steps[i].end;
    // The bound first: a leg that it rules out need not be priced.
    if (end != t_[0] && steps[i].gain > costs_->lower(end, t_[0]) &&
        steps[i].gain > (*costs_)(end, t_[0]) && close(tour, level + 1))
      return true;
    if (level + 1 < kDepth && level + 1 < depth_ && deepen(tour, level + 1, steps[i].gain))
      return true;
  }
  return false;
}

bool LocalSearch::close(ArrayTour& tour, int edges) {
  Exchange exchange;
  exchange.cuts = edges;
  int by_place[kDepth + 1], end_of[2 * kDepth + 2];
  for (int i = 0; i < edges; ++i) {
    const int* const taken = t_ + std::ptrdiff_t{2} * i;
    const int a = taken[0], b = taken[1];
    const int place = tour.place(tour.next(a) == b ? a : b);
    int at = i;
    for (; at > 0 && exchange.cut[at - 1] > place; --at) {
      exchange.cut[at] = exchange.cut[at - 1];
      by_place[at] = by_place[at - 1];
    }
    exchange.cut[at] = place;
    by_place[at] = i;
  }
  for (int j = 0; j < edges; ++j) {
    const int a = 2 * by_place[j];
    const bool forward = tour.at(exchange.cut[j]) == t_[a];
    end_of[a] = 2 * j + !forward;
    end_of[a + 1] = 2 * j + forward;
  }
  for (int i = 0; i < edges; ++i) {
    const int a = end_of[2 * i + 1], b = end_of[i + 1 == edges ? 0 : 2 * i + 2];
    exchange.partner[a] = b;
    exchange.partner[b] = a;
  }
  work_ += 4;
  if (!ArrayTour::whole(exchange)) return false;
  tour.apply(exchange);
  for (int i = 2 * edges; i-- > 0;) queue(t_[i]);
  return true;
}

bool LocalSearch::kick(ArrayTour& tour, std::int64_t times, kernels::RandomStream& random,
                       Poller& poller) {
  const int n = tour.size();
  if (n < 8) return true;
  const int longest = std::min(kLongestKicked, (n - 1) / 3);
  tour.keep();
  for (std::int64_t i = 0; i < times; ++i) {
    int places[4];
    places[0] = random.below(n);
    for (int j = 1; j < 4; ++j) places[j] = (places[j - 1] + 1 + random.below(longest)) % n;
    int first = 0;
    while (first < 3 && places[first + 1] > places[first]) ++first;
    first = first == 3 ? 0 : first + 1;
    Exchange exchange;
    exchange.cuts = 4;
    int number[4];
    for (int j = 0; j < 4; ++j) {
      number[(first + j) % 4] = j;
      exchange.cut[j] = places[(first + j) % 4];
    }
    // A B C D A becomes A D C B A, in each its own direction: the ends are those at a cut's left
    // (2j) and right (2j + 1); B, C, D begin behind cuts 0, 1, 2.
    const auto join = [&](int left, int right) {
      const int behind = 2 * number[left], before = 2 * number[right] + 1;
      exchange.partner[behind] = before;
      exchange.partner[before] = behind;
    };
    join(0, 2), join(3, 1), join(2, 0), join(1, 3);
    const std::int64_t before = tour.cost();
    for (const int place : exchange.cut_span())
      queue(tour.at(place)), queue(tour.at(tour.after(place)));
    tour.apply(exchange);
    const bool done = run(tour, poller);
    if (tour.cost() > before)
      tour.undo();
    else
      tour.keep();
    if (!done) return false;
  }
  return true;
}

}  // namespace lasius::tour
