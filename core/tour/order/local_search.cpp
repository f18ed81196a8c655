#include "core/tour/order/local_search.h"

#include <algorithm>
#include <initializer_list>

namespace lasius::tour {

namespace {

constexpr int kLongestKicked = 30;

}  // namespace

LocalSearch::LocalSearch(const Costs& costs, const Candidates& candidates, int depth)
    : depth_(depth), costs_(&costs), candidates_(&candidates), waits_(costs.size(), 0) {}

void LocalSearch::queue(int stop) {
  if (waits_[stop]) return;
  waits_[stop] = 1;
  waiting_.push_back(stop);
}

bool LocalSearch::run(ArrayTour& tour, Poller& poller, bool keeps) {
  while (!waiting_.empty()) {
    const int stop = waiting_.back();
    waiting_.pop_back();
    waits_[stop] = 0;
    work_ = 0;
    while (improve_at(tour, stop))
      if (keeps) tour.keep();
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
  return run(tour, poller, true);
}

bool LocalSearch::improve_at(ArrayTour& tour, int stop) {
  return improve_behind<true>(tour, stop) || improve_behind<false>(tour, stop);
}

// The cheapest exchange that takes out the edge from `stop` to the next, or the one before it, and
// then all is mirrored: edges t0 t1, t2 t3 and t4 t5 go, t1 t2, t3 t4 and the last stop t0 come.
template <bool kForward>
bool LocalSearch::improve_behind(ArrayTour& tour, int stop) {
  const auto next = [&](int v) { return kForward ? tour.next(v) : tour.previous(v); };
  const auto previous = [&](int v) { return kForward ? tour.previous(v) : tour.next(v); };
  const auto to_next = [&](int v) { return kForward ? tour.to_next(v) : tour.to_previous(v); };
  const auto to_previous = [&](int v) { return kForward ? tour.to_previous(v) : tour.to_next(v); };
  const int t0 = stop, t1 = next(t0), first = tour.place(t1);
  const auto steps_to = [&](int v) {  // from t1
    const int steps = kForward ? tour.place(v) - first : first - tour.place(v);
    return steps < 0 ? steps + tour.size() : steps;
  };
  std::int64_t best = 0;
  int edges = 0;
  const auto offer = [&](std::int64_t gain, std::initializer_list<int> ends) {
    const int last = *(ends.end() - 1);
    // The bound first: a leg that it rules out need not be priced.
    if (gain - costs_->lower(t0, last) <= best || gain - (*costs_)(t0, last) <= best) return;
    best = gain - (*costs_)(t0, last);
    edges = static_cast<int>(ends.size()) / 2;
    std::copy(ends.begin(), ends.end(), t_);
  };
  for (const auto& [t2, cost2] : candidates_->of(t1)) {
    const std::int64_t gain2 = to_next(t0) - cost2;
    if (gain2 <= 0) break;
    ++work_;
    const int steps2 = steps_to(t2);
    if (t2 == t0) continue;
    if (steps2 > 1) {  // t1 .. t3 is passed backward
      const int t3 = previous(t2);
      const std::int64_t gain3 = gain2 + to_previous(t2);
      offer(gain3, {t0, t1, t2, t3});
      for (const auto& [t4, cost4] : candidates_->of(t3)) {
        const std::int64_t gain4 = gain3 - cost4;
        if (gain4 <= best || depth_ < 3) break;
        ++work_;
        const int steps4 = steps_to(t4);
        if (steps4 < steps2 - 2)
          offer(gain4 + to_next(t4), {t0, t1, t2, t3, t4, next(t4)});
        else if (steps4 > steps2)
          offer(gain4 + to_previous(t4), {t0, t1, t2, t3, t4, previous(t4)});
      }
    }
    if (depth_ < 3) continue;
    const int t3 = next(t2);  // t1 .. t2 is a circle, which the third edge opens
    const std::int64_t gain3 = gain2 + to_next(t2);
    for (const auto& [t4, cost4] : candidates_->of(t3)) {
      const std::int64_t gain4 = gain3 - cost4;
      if (gain4 <= best) break;
      ++work_;
      const int steps4 = steps_to(t4);
      if (steps4 >= steps2) continue;
      offer(gain4 + to_next(t4), {t0, t1, t2, t3, t4, next(t4)});
      if (steps4 > 0) offer(gain4 + to_previous(t4), {t0, t1, t2, t3, t4, previous(t4)});
    }
  }
  if (edges > 0) exchange(tour, edges);
  return edges > 0;
}

void LocalSearch::exchange(ArrayTour& tour, int edges) {
  Exchange exchange;
  exchange.cuts = edges;
  int by_place[kDepth], end_of[2 * kDepth];
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
  tour.apply(exchange);
  for (int i = 2 * edges; i-- > 0;) queue(t_[i]);
}

bool LocalSearch::kick(ArrayTour& tour, std::int64_t times, kernels::RandomStream& random,
                       Poller& poller) {
  const int n = tour.size();
  if (n < 8) return true;
  const int longest = std::min(kLongestKicked, (n - 1) / 3);
  tour.keep();
  for (std::int64_t i = 0; i < times; ++i) {
    // A B C becomes A C B, or A B C D becomes A D C B, in each its own direction.
    const int cuts = random.chance(0.5) ? 3 : 4;
    int places[4] = {random.below(n)};
    for (int j = 1; j < cuts; ++j) places[j] = (places[j - 1] + 1 + random.below(longest)) % n;
    int first = 0;  // of the places as they rise
    while (first + 1 < cuts && places[first + 1] > places[first]) ++first;
    first = first + 1 == cuts ? 0 : first + 1;
    Exchange exchange;
    exchange.cuts = cuts;
    for (int j = 0; j < cuts; ++j) {
      exchange.cut[j] = places[(first + j) % cuts];
      // What ends at a cut goes on with the segment that began two cuts before it, of four; of
      // three with the one that begins at the next.
      const int behind = 2 * ((j + (cuts == 4 ? 2 : 1)) % cuts) + 1;
      const int end = 2 * j;
      exchange.partner[end] = behind;
      exchange.partner[behind] = end;
    }
    const std::int64_t before = tour.cost();
    for (const int place : exchange.cut_span())
      queue(tour.at(place)), queue(tour.at(tour.after(place)));
    tour.apply(exchange);
    const bool done = run(tour, poller, false);
    if (tour.cost() > before)
      tour.undo();
    else
      tour.keep();
    if (!done) return false;
  }
  return true;
}

}  // namespace lasius::tour
