#include "core/tour/order/path_exchange.h"

#include <algorithm>

namespace lasius::tour {

PathExchange::PathExchange(const StopPath& path) : path_(path), awake_(path.size(), 0) {
  woken_.reserve(path.size());
}

void PathExchange::set(std::vector<int> nodes) {
  now_ = {};
  now_.nodes = std::move(nodes);
  now_.position.resize(now_.nodes.size());
  now_.arcs.resize(now_.nodes.size() - 1);
  if (path_.given().limited()) now_.carried.resize(now_.nodes.size());
  written(0, path_.size() - 1);
}

// What follows from the nodes at these positions; arcs that lead there and on are written too.
void PathExchange::written(int from, int to) {
  const int last = path_.size() - 1;
  for (int p = from; p <= to; ++p) now_.position[now_.nodes[p]] = p;
  for (int p = std::max(0, from - 1); p <= std::min(to, last - 1); ++p) {
    const Cost cost = path_.cost(now_.nodes[p], now_.nodes[p + 1]);
    now_.cost += cost - now_.arcs[p];
    now_.arcs[p] = cost;
  }
  if (!now_.carried.empty())
    for (int p = from; p <= to; ++p)
      now_.carried[p] = (p > 0 ? now_.carried[p - 1] : 0) + path_.load(now_.nodes[p]);
  first_ = last_ < 0 ? from : std::min(first_, from);
  last_ = std::max(last_, to);
}

void PathExchange::rewrite(int from, const std::vector<int>& nodes) {
  std::copy(nodes.begin(), nodes.end(), now_.nodes.begin() + from);
  written(from, from + static_cast<int>(nodes.size()) - 1);
}

void PathExchange::copy(const PathState& from, PathState& to) {
  const auto part = [&](const auto& source, auto& target, int begin, int end) {
    std::copy(source.begin() + begin, source.begin() + end, target.begin() + begin);
  };
  if (last_ < 0) return;
  part(from.nodes, to.nodes, first_, last_ + 1);
  for (int p = first_; p <= last_; ++p) to.position[to.nodes[p]] = p;
  part(from.arcs, to.arcs, std::max(0, first_ - 1), std::min(last_ + 1, path_.size() - 1));
  if (!now_.carried.empty()) part(from.carried, to.carried, first_, last_ + 1);
  to.cost = from.cost;
  last_ = -1;
}

void PathExchange::keep(PathState& state) {
  if (state.nodes.size() == now_.nodes.size()) return copy(now_, state);
  state = now_;
  last_ = -1;
}

void PathExchange::restore(const PathState& state) { copy(state, now_); }

void PathExchange::wake(int node) {
  if (awake_[node]) return;
  awake_[node] = 1;
  woken_.push_back(node);
}

void PathExchange::wake_all() {
  for (int p = path_.size() - 1; p >= 0; --p) wake(now_.nodes[p]);
}

bool PathExchange::improve(Poller& poller) {
  while (!woken_.empty()) {
    const int node = woken_.back();
    woken_.pop_back();
    awake_[node] = 0;
    for (;;) {
      Exchange best;
      work_ = 1;
      const int at = now_.position[node];
      if (at + 1 < path_.size())
        for (const auto& arc : path_.out(node)) {
          if (arc.cost >= now_.arcs[at]) break;
          try_arc(node, arc.node, arc.cost, best);
        }
      if (at > 0)
        for (const auto& arc : path_.in(node)) {
          if (arc.cost >= now_.arcs[at - 1]) break;
          try_arc(arc.node, node, arc.cost, best);
        }
      if (best.gain > 0) apply(best);
      if (poller.stop_after(work_)) {
        for (const int left : woken_) awake_[left] = 0;
        woken_.clear();
        return false;
      }
      if (best.gain == 0) break;
    }
  }
  return true;
}

// An exchange that has cost `gone` less so far, and adds the arcs from a to b and, unless c is -1,
// from c to d.
void PathExchange::consider(const Exchange& exchange, std::int64_t gone, int a, int b, int c, int d,
                            Exchange& best) {
  if (gone - path_.lower(a, b) - (c < 0 ? 0 : path_.lower(c, d)) <= best.gain) return;
  const std::int64_t gain = gone - path_.cost(a, b) - (c < 0 ? 0 : path_.cost(c, d));
  if (gain <= best.gain) return;
  if (exchange.reversed && !may_reverse(exchange.h, exchange.j)) return;
  if (!now_.carried.empty() && !carries(exchange)) return;
  best = exchange;
  best.gain = gain;
}

void PathExchange::try_arc(int a, int b, Cost cost, Exchange& best) {
  const int at = now_.position[a], to = now_.position[b];
  if (to > at + 1) try_forward(at, to, cost, best);
  if (to < at) try_backward(at, to, cost, best);
}

void PathExchange::try_forward(int at, int to, Cost cost, Exchange& best) {
  const auto& t = now_.nodes;
  const auto& arcs = now_.arcs;
  const int last = path_.size() - 1;
  const std::int64_t gone = std::int64_t{arcs[at]} + arcs[to - 1] - cost;
  // The piece between the two goes behind others, up to j.
  for (int j = to; j < last; ++j, ++work_) {
    const auto held = [&](int v) { return now_.position[v] > at && now_.position[v] < to; };
    if (std::ranges::any_of(path_.previous(t[j]), held)) break;
    consider({0, false, at, to - 1, j}, gone + arcs[j], t[j], t[at + 1], t[to - 1], t[j + 1], best);
  }
  // The piece between the two goes before others, behind h.
  for (int h = at - 1; h >= 0; --h, ++work_) {
    const auto held = [&](int v) { return now_.position[v] > at && now_.position[v] < to; };
    if (std::ranges::any_of(path_.next(t[h + 1]), held)) break;
    consider({0, false, h, at, to - 1}, gone + arcs[h], t[h], t[at + 1], t[to - 1], t[h + 1], best);
  }
  if (!path_.symmetric()) return;
  if (to < last)
    consider({0, true, at, 0, to}, std::int64_t{arcs[at]} + arcs[to] - cost, t[at + 1], t[to + 1],
             -1, -1, best);
  if (at > 0)
    consider({0, true, at - 1, 0, to - 1}, std::int64_t{arcs[at - 1]} + arcs[to - 1] - cost,
             t[at - 1], t[to - 1], -1, -1, best);
}

void PathExchange::try_backward(int at, int to, Cost cost, Exchange& best) {
  const auto& t = now_.nodes;
  const int h = to - 1;
  const std::int64_t gone = std::int64_t{now_.arcs[h]} + now_.arcs[at] - cost;
  int needed = -1;  // the last that comes behind any of the piece that moves
  for (int i = to; i < at; ++i, ++work_) {
    for (const int v : path_.next(t[i]))
      if (now_.position[v] <= at) needed = std::max(needed, now_.position[v]);
    if (needed == at) break;
    if (needed > i) continue;
    consider({0, false, h, i, at}, gone + now_.arcs[i], t[h], t[i + 1], t[i], t[at + 1], best);
  }
}

bool PathExchange::carries(const Exchange& exchange) const {
  std::int64_t carried = now_.carried[exchange.h];
  const auto pass = [&](int p) {
    return (carried += path_.load(now_.nodes[p])) <= path_.given().capacity();
  };
  if (exchange.reversed) {
    for (int p = exchange.j; p > exchange.h; --p)
      if (!pass(p)) return false;
    return true;
  }
  // Each piece keeps its loads, but for what the other one adds before it.
  const auto& all = now_.carried;
  const std::int64_t first = all[exchange.i] - all[exchange.h],
                     second = all[exchange.j] - all[exchange.i];
  const auto fits = [&](int from, int to, std::int64_t more) {
    for (int p = from + 1; p <= to && more > 0; ++p)
      if (all[p] + more > path_.given().capacity()) return false;
    return true;
  };
  return fits(exchange.i, exchange.j, -first) && fits(exchange.h, exchange.i, second);
}

bool PathExchange::may_reverse(int h, int j) const {
  for (int p = h + 1; p < j; ++p)
    for (const int v : path_.next(now_.nodes[p]))
      if (now_.position[v] <= j) return false;
  return true;
}

bool PathExchange::may_swap(int h, int i, int j) const {
  for (int p = i + 1; p <= j; ++p)
    for (const int v : path_.previous(now_.nodes[p]))
      if (now_.position[v] > h && now_.position[v] <= i) return false;
  return now_.carried.empty() || carries({0, false, h, i, j});
}

void PathExchange::swap(int h, int i, int j) {
  const auto at = [&](int p) { return now_.nodes.begin() + p; };
  std::rotate(at(h + 1), at(i + 1), at(j + 1));
  written(h + 1, j);
}

void PathExchange::apply(const Exchange& exchange) {
  const auto& t = now_.nodes;
  const auto wake_ends = [&](int p) {
    wake(t[p + 1]);
    wake(t[p]);
  };
  const int h = exchange.h, j = exchange.j;
  if (exchange.reversed) {
    std::reverse(now_.nodes.begin() + h + 1, now_.nodes.begin() + j + 1);
    written(h + 1, j);
  } else {
    swap(h, exchange.i, j);
    wake_ends(h + j - exchange.i);  // where the pieces meet now
  }
  wake_ends(j);
  wake_ends(h);
  work_ += j - h;
}

}  // namespace lasius::tour
