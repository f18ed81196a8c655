#include "core/tour/order/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace lasius::tour {

namespace {

using Leg = Candidates::Leg;

bool cheaper(const Leg& a, const Leg& b) {
  return a.cost != b.cost ? a.cost < b.cost : a.to < b.to;
}

// Keeps the cheapest few of what it is shown.
struct Nearest {
  std::vector<Leg> kept;
  std::size_t most = 0;

  bool wants(Leg leg) const {
    return most > 0 && (kept.size() < most || cheaper(leg, kept.back()));
  }
  void take(Leg leg) {
    if (!wants(leg)) return;
    if (kept.size() == most) kept.pop_back();
    kept.insert(std::upper_bound(kept.begin(), kept.end(), leg, cheaper), leg);
  }
};

int quadrant(const Point& from, const Point& to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  if (dx > 0 && dy >= 0) return 0;
  if (dx <= 0 && dy > 0) return 1;
  return dx < 0 ? 2 : 3;
}

}  // namespace

Candidates::Candidates(const Costs& costs, std::span<const Point> places, int count,
                       const StopCondition& stop) {
  Poller poller(stop);
  *this = Candidates(costs, places, count, poller, kMany);
}

Candidates::Candidates(const Costs& costs, std::span<const Point> places, int count, Poller& poller,
                       int many) {
  const int n = costs.size();
  std::array<Nearest, 5> sets;  // of the quadrants, and of all
  for (int q = 0; q < 4; ++q) sets[q].most = places.empty() ? 0 : count / 4;
  sets[4].most = count;
  std::vector<Leg> row, chosen;
  std::vector<int> line(n), at(n);  // once cut, the stops by x and where each is
  std::iota(line.begin(), line.end(), 0);
  std::iota(at.begin(), at.end(), 0);
  bool cut = false;
  begin_.push_back(0);
  for (int v = 0; v < n; ++v) {
    for (Nearest& set : sets) set.kept.clear();
    row.clear();
    if (!cut && n > many && poller.stop_after(n)) {
      cut = true;
      std::stable_sort(line.begin(), line.begin() + static_cast<int>(places.size()),
                       [&](int a, int b) { return places[a].x < places[b].x; });
      for (int i = 0; i < n; ++i) at[line[i]] = i;
    }
    // So wide a strip of a square holds most of the nearest; of very many stops a narrower one, as
    // nothing polls any more.
    constexpr int kUnpolled = 2000000;  // bounds on either side, of all stops
    const int strip = std::min(4 * static_cast<int>(std::sqrt(n)), std::max(count, kUnpolled / n));
    const int near = !cut ? n : many > 0 ? strip : count;
    for (int i = std::max(0, at[v] - near); i < std::min(n, at[v] + near + 1); ++i)
      if (line[i] != v) row.push_back({line[i], costs.lower(v, line[i])});
    // By rising bound: then few are priced that are not kept.
    if (costs.priced_late()) std::sort(row.begin(), row.end(), cheaper);
    for (Leg leg : row) {
      const bool placed = !places.empty() && static_cast<std::size_t>(leg.to) < places.size() &&
                          static_cast<std::size_t>(v) < places.size();
      Nearest* const own = placed ? &sets[quadrant(places[v], places[leg.to])] : nullptr;
      if (!sets[4].wants(leg) && (own == nullptr || !own->wants(leg))) continue;
      if (costs.priced_late()) leg.cost = costs(v, leg.to);
      sets[4].take(leg);
      if (own != nullptr) own->take(leg);
    }
    chosen.clear();
    for (const Nearest& set : sets)
      for (const Leg& leg : set.kept) {
        if (static_cast<int>(chosen.size()) == std::min(count, n - 1)) break;
        if (std::none_of(chosen.begin(), chosen.end(),
                         [&](const Leg& c) { return c.to == leg.to; }))
          chosen.push_back(leg);
      }
    std::sort(chosen.begin(), chosen.end(), cheaper);
    legs_.insert(legs_.end(), chosen.begin(), chosen.end());
    begin_.push_back(static_cast<int>(legs_.size()));
  }
}

void Candidates::add(const Costs& costs, std::span<const std::pair<int, int>> more) {
  std::vector<std::vector<Leg>> rows(size());
  const auto let_in = [&](int a, int b, Cost cost) {
    rows[a].push_back({b, cost});
    rows[b].push_back({a, cost});
  };
  for (int v = 0; v < size(); ++v)
    for (const Leg& leg : of(v)) let_in(v, leg.to, leg.cost);
  for (const auto& [a, b] : more) let_in(a, b, costs(a, b));
  legs_.clear();
  for (int v = 0; v < size(); ++v) {
    auto& row = rows[v];
    std::sort(row.begin(), row.end(), cheaper);
    row.erase(std::unique(row.begin(), row.end(),
                          [](const Leg& a, const Leg& b) { return a.to == b.to; }),
              row.end());
    begin_[v] = static_cast<int>(legs_.size());
    legs_.insert(legs_.end(), row.begin(), row.end());
  }
  begin_.back() = static_cast<int>(legs_.size());
}

}  // namespace lasius::tour
