#include "core/tour/cover/near_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "core/tour/order/fragments.h"

namespace lasius::tour {

namespace {

bool shorter(const EndLink& one, const EndLink& other) {
  return std::tie(one.length, one.a, one.b) < std::tie(other.length, other.a, other.b);
}

// Keeps the shortest link of each pair.
void keep_shortest(std::vector<EndLink>& links) {
  std::sort(links.begin(), links.end(), [](const EndLink& one, const EndLink& other) {
    return std::tie(one.a, one.b, one.length) < std::tie(other.a, other.b, other.length);
  });
  links.erase(std::unique(links.begin(), links.end(),
                          [](const EndLink& one, const EndLink& other) {
                            return one.a == other.a && one.b == other.b;
                          }),
              links.end());
}

// Waves from all stops at once over the clear cells.
class Waves {
 public:
  Waves(const Grid& clear, const ToolLines& lines, std::span<const Point> stops)
      : clear_(clear),
        lines_(lines),
        stops_(stops),
        owner_(static_cast<std::size_t>(clear.width()) * clear.height(), kNone) {}

  std::vector<EndLink> run() {
    std::vector<Cell> front, next;
    for (int stop = 0; stop < static_cast<int>(stops_.size()); ++stop) {
      const Cell at = cell_of(stops_[stop]);
      if (at.x >= 0) enter(at, stop, 0, front);
    }
    for (int steps = 1; !front.empty(); ++steps) {
      next.clear();
      for (const Cell at : front)
        for (const Cell to : {Cell{at.x + 1, at.y}, Cell{at.x - 1, at.y}, Cell{at.x, at.y + 1},
                              Cell{at.x, at.y - 1}})
          if (clear_.free(to)) enter(to, owner(at), steps, next);
      front.swap(next);
    }
    keep_shortest(links_);
    return std::move(links_);
  }

 private:
  static constexpr std::int32_t kNone = -1;

  std::int32_t& owner(Cell at) {
    return owner_[static_cast<std::size_t>(at.y) * clear_.width() + at.x];
  }
  void enter(Cell at, std::int32_t stop, int steps, std::vector<Cell>& front) {
    std::int32_t& known = owner(at);
    if (known == kNone) {
      known = stop;
      front.push_back(at);
    } else if (known / 2 != stop / 2) {
      link(std::min(known, stop), std::max(known, stop), steps);
    }
  }
  // Between the straight way and the walk of both waves.
  void link(int a, int b, int steps) {
    constexpr double kWalk = 0.7071067811865476;  // of a way by moves at right angles, at least
    const double length = std::max(distance(stops_[a], stops_[b]), kWalk * (2 * steps - 1));
    if (!links_.empty() && links_.back().a == a && links_.back().b == b &&
        links_.back().length <= length)
      return;
    links_.push_back({a, b, length});
    if (links_.size() < most_) return;
    keep_shortest(links_);
    most_ = std::max(most_, 2 * links_.size());
  }
  // A clear cell whose middle a place can be left to, or gone to, straight; {-1, -1}: none.
  Cell cell_of(Point p) const {
    const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
    for (const auto& [dx, dy] :
         {std::pair(0, 0), {-1, 0}, {0, -1}, {-1, -1}, {1, 0}, {0, 1}, {1, -1}, {-1, 1}, {1, 1}}) {
      const Cell cell{x + dx, y + dy};
      if (!clear_.free(cell)) continue;
      const bool at_it = lines_.radius() == 0 && p.x >= cell.x && p.x <= cell.x + 1 &&
                         p.y >= cell.y && p.y <= cell.y + 1;
      if (at_it || lines_.straight_between(p, centre(cell))) return cell;
    }
    return {-1, -1};
  }

  const Grid& clear_;
  const ToolLines& lines_;
  std::span<const Point> stops_;
  std::vector<std::int32_t> owner_;
  std::vector<EndLink> links_;
  std::size_t most_ = 1 << 22;
};

// What chains of links and swaths make of links between stops that are still free.
class Chains {
 public:
  Chains(int swaths, std::span<const Point> stops, std::span<const EndLink> links)
      : near_(stops.size()) {
    const auto add = [&](int a, int b, double length) {
      near_[a].emplace_back(b, length);
      near_[b].emplace_back(a, length);
    };
    for (const EndLink& one : links) add(one.a, one.b, one.length);
    for (int end = 0; end < 2 * swaths; end += 2)
      add(end, end + 1, distance(stops[end], stops[end + 1]));
  }

  std::vector<EndLink> between(const Fragments& parts) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    using Reached = std::pair<double, int>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    std::vector<double> away(near_.size(), kFar);
    std::vector<int> from(near_.size(), -1);
    for (int v = 0; v < static_cast<int>(near_.size()); ++v)
      if (!parts.full(v)) {
        from[v] = v;
        away[v] = 0;
        open.emplace(0, v);
      }
    while (!open.empty()) {
      const auto [length, at] = open.top();
      open.pop();
      if (length > away[at]) continue;
      for (const auto& [to, step] : near_[at])
        if (length + step < away[to]) {
          away[to] = length + step;
          from[to] = from[at];
          open.emplace(away[to], to);
        }
    }
    std::vector<EndLink> links;
    for (int a = 0; a < static_cast<int>(near_.size()); ++a)
      for (const auto& [b, length] : near_[a])
        if (a < b && from[a] >= 0 && from[b] >= 0 && from[a] != from[b] &&
            parts.joins(from[a], from[b]))
          links.push_back(
              {std::min(from[a], from[b]), std::max(from[a], from[b]), away[a] + length + away[b]});
    std::sort(links.begin(), links.end(), shorter);
    return links;
  }

 private:
  std::vector<std::vector<std::pair<int, double>>> near_;
};

}  // namespace

std::vector<EndLink> near_ends(const Grid& clear, const ToolLines& lines,
                               std::span<const Point> stops) {
  return Waves(clear, lines, stops).run();
}

SwathChain chained(int swaths, std::span<const Point> stops, std::span<const EndLink> links) {
  constexpr int kMostRounds = 32;  // each leaves less than half of the paths, but for odd maps
  if (stops.empty()) return {};
  Fragments parts(static_cast<int>(stops.size()));
  for (int end = 0; end < 2 * swaths; end += 2) parts.join(end, end + 1);
  const Chains chains(swaths, stops, links);
  SwathChain chain;
  bool joins = true;
  for (int round = 0; joins && round < kMostRounds; ++round) {
    joins = false;
    for (const EndLink& one : chains.between(parts)) {
      if (!parts.joins(one.a, one.b)) continue;
      parts.join(one.a, one.b);
      chain.length += one.length;
      joins = true;
    }
  }
  const auto straight = [&](int a, int b) { return distance(stops[a], stops[b]); };
  chain.order = order_of(parts, straight);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const int a = chain.order[i], b = chain.order[(i + 1) % stops.size()];
    if (parts.side[a][0] != b && parts.side[a][1] != b) chain.length += straight(a, b);
  }
  return chain;
}

}  // namespace lasius::tour
