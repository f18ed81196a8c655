#include <algorithm>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/polygon/route.h"

namespace lasius::polygon {
namespace {

/// A way through midpoints: regions and the links between them, one link fewer than regions.
struct Way {
  double length = 0;
  std::vector<int> links;
  std::vector<int> regions;
};

/// Dijkstra over links, each entered into one of its regions. Nodes: 2 l + 1 where link l is
/// crossed from the left to the right, 2 l the other way.
class MidpointSearch {
 public:
  MidpointSearch(const Regions& regions, const Place& goal) : regions_(regions), goal_(goal) {
    for (int l = 0; l < static_cast<int>(regions.links().size()); ++l) {
      const Point a = end(l, true), b = end(l, false);
      middles_.push_back({a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y)});
    }
    in_goal_.assign(regions.regions().size(), 0);
    for (const int r : goal.regions) in_goal_[r] = 1;
  }

  Point middle(int link) const { return middles_[link]; }

  /// The shortest way from a point in any of `sources`, none of its links in `closed`.
  std::optional<Way> search(Point from, const std::vector<int>& sources,
                            const std::set<int>& closed) {
    const std::size_t nodes = 2 * middles_.size();
    best_.assign(nodes, {kInfinity, 0});
    before_.assign(nodes, -1);
    Key reached{kInfinity, 0};
    int last = -1, last_region = -1;
    const auto finish = [&](Point p, Key so_far, int region, int node) {
      if (in_goal_[region] == 0) return;
      so_far.first += distance(p, goal_.given);
      if (!(so_far < reached)) return;
      reached = so_far;
      last = node;
      last_region = region;
    };
    for (const int r : sources) {
      finish(from, {0, 0}, r, -1);
      spread(from, {0, 0}, r, -1, closed);
    }
    while (!queue_.empty()) {
      const auto [key, node] = queue_.top();
      queue_.pop();
      if (best_[node] < key) continue;
      const int region = region_entered(node);
      finish(middle(node / 2), key, region, node);
      spread(middle(node / 2), key, region, node, closed);
    }
    if (last_region < 0) return std::nullopt;
    Way way{reached.first, {}, {last_region}};
    for (int node = last; node >= 0; node = before_[node]) {
      way.links.push_back(node / 2);
      way.regions.push_back(region_left(node));
    }
    std::ranges::reverse(way.links);
    std::ranges::reverse(way.regions);
    return way;
  }

 private:
  using Key = std::pair<double, int>;  // length, lines crossed

  Point end(int link, bool first) const {
    const Link& l = regions_.links()[link];
    return regions_.space().point(regions_.at(first ? l.a : l.b));
  }
  int region_entered(int node) const {
    const auto [left, right] = regions_.beside(node / 2);
    return node % 2 == 1 ? right : left;
  }
  int region_left(int node) const { return region_entered(node ^ 1); }

  /// Offers the links of a region, all but the one that was just crossed.
  void spread(Point from, Key key, int region, int node, const std::set<int>& closed) {
    for (const Side& side : regions_.regions()[region].sides) {
      if (side.link < 0 || (node >= 0 && side.link == node / 2) || closed.contains(side.link))
        continue;
      const int next = 2 * side.link + (regions_.beside(side.link).first == region ? 1 : 0);
      const Key offer{key.first + distance(from, middle(side.link)), key.second + 1};
      if (!(offer < best_[next])) continue;
      best_[next] = offer;
      before_[next] = node;
      queue_.emplace(offer, next);
    }
  }

  const Regions& regions_;
  const Place& goal_;
  std::vector<Point> middles_;
  std::vector<char> in_goal_;
  std::vector<Key> best_;
  std::vector<int> before_;
  std::priority_queue<std::pair<Key, int>, std::vector<std::pair<Key, int>>, std::greater<>> queue_;
};

Route make_route(const Regions& regions, const Place& start, const Place& goal, const Way& way) {
  Route route{start, goal, {}};
  for (std::size_t i = 0; i < way.links.size(); ++i) {
    const Link& link = regions.links()[way.links[i]];
    const LatticePoint a = regions.at(link.a), b = regions.at(link.b);
    // Left of the way from a to b lies the region that is left: then b is on the left hand.
    const bool to_right = regions.beside(way.links[i]).first == way.regions[i];
    route.gates.push_back({.link = way.links[i],
                           .a = regions.space().point(a),
                           .b = regions.space().point(b),
                           .left = to_right ? b : a,
                           .right = to_right ? a : b,
                           .a_is_left = !to_right});
  }
  return route;
}

/// Length of the start of a way, up to its link number `count`.
double head_length(const MidpointSearch& search, Point start, const Way& way, std::size_t count) {
  double sum = 0;
  Point at = start;
  for (std::size_t i = 0; i < count; ++i) {
    sum += distance(at, search.middle(way.links[i]));
    at = search.middle(way.links[i]);
  }
  return sum;
}

/// The shortest way that goes along with `base` for its first `spur` links, and from there by a
/// link that no way of `found` with the same head takes; nothing where there is none.
std::optional<Way> spur_way(MidpointSearch& search, const Place& start,
                            const std::vector<Way>& found, const Way& base, std::size_t spur) {
  const auto head = static_cast<std::ptrdiff_t>(spur);
  std::set<int> closed(base.links.begin(), base.links.begin() + head);
  for (const Way& other : found) {
    if (other.links.size() <= spur) continue;
    if (std::equal(other.links.begin(), other.links.begin() + head, base.links.begin()))
      closed.insert(other.links[spur]);
  }
  const Point from = spur == 0 ? start.given : search.middle(base.links[spur - 1]);
  const auto sources = spur == 0 ? start.regions : std::vector<int>{base.regions[spur]};
  const auto tail = search.search(from, sources, closed);
  if (!tail) return std::nullopt;
  Way way{head_length(search, start.given, base, spur) + tail->length,
          {base.links.begin(), base.links.begin() + head},
          {base.regions.begin(), base.regions.begin() + head}};
  way.links.insert(way.links.end(), tail->links.begin(), tail->links.end());
  way.regions.insert(way.regions.end(), tail->regions.begin(), tail->regions.end());
  return way;
}

}  // namespace

void midpoint_routes(const Regions& regions, const Place& start, const Place& goal, int count,
                     Poller& poller, const std::function<bool(const Route&)>& visit) {
  MidpointSearch search(regions, goal);
  std::vector<Way> found, candidates;
  std::set<std::vector<int>> known;  // links of both
  if (auto first = search.search(start.given, start.regions, {})) {
    known.insert(first->links);
    found.push_back(std::move(*first));
  }
  const auto lines = static_cast<std::int64_t>(regions.links().size());
  while (!found.empty()) {
    const Way base = found.back();
    if (!visit(make_route(regions, start, goal, base))) return;
    if (static_cast<int>(found.size()) == count) return;
    for (std::size_t spur = 0; spur <= base.links.size(); ++spur) {
      if (poller.stop_after(1 + lines)) return;
      auto way = spur_way(search, start, found, base, spur);
      if (way && known.insert(way->links).second) candidates.push_back(std::move(*way));
    }
    if (candidates.empty()) return;
    const auto best = std::ranges::min_element(candidates, [](const Way& a, const Way& b) {
      const auto rank = [](const Way& w) { return std::tuple(w.length, w.links.size()); };
      return rank(a) != rank(b) ? rank(a) < rank(b) : a.links < b.links;
    });
    found.push_back(std::move(*best));
    candidates.erase(best);
  }
}

}  // namespace lasius::polygon
