#include "core/polygon/link_builder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lasius::polygon {
namespace {

double length_of(LatticePoint d) noexcept {
  const auto x = static_cast<double>(d.x), y = static_cast<double>(d.y);
  return std::sqrt(x * x + y * y);
}

}  // namespace

LinkBuilder::LinkBuilder(FreeSpace& space, Poller& poller)
    : space_(space),
      poller_(poller),
      fans_(space.corners.size()),
      edges_(space.corners.size()),
      corner_index_(empty_index()),
      edge_index_(corner_index_),
      link_index_(corner_index_) {
  double longest = 1;
  for (int c = 0; c < static_cast<int>(space.corners.size()); ++c) {
    set_edge(c);
    corner_index_.add(c, at(c), at(c));
    const Edge& e = edges_[c];
    longest = std::max(longest, length_of(e.to - e.from));
    if (!space.corners[c].wall || (e.from.x != e.to.x && e.from.y != e.to.y)) continue;
    walls_.push_back(c);
    wall_ends_.push_back(e.to);
  }
  draw(longest);
  // Feet are corners now, of regions that may have no other to be cut at.
  walls_.clear();
  draw(longest);
  if (poller.stopped()) return;
  remove_redundant();
  renumber();
}

/// A net over all corners, empty.
SpatialIndex LinkBuilder::empty_index() const {
  LatticePoint low, high;
  if (!space_.corners.empty()) low = high = at(0);
  for (const Corner& c : space_.corners) {
    low = {std::min(low.x, c.at.x), std::min(low.y, c.at.y)};
    high = {std::max(high.x, c.at.x), std::max(high.y, c.at.y)};
  }
  return {low, high, space_.corners.size()};
}

/// In shells of growing radius: most corners are convex before the long lines are even listed.
void LinkBuilder::draw(double longest) {
  const double farthest = std::ldexp(1.0, 46);
  double from = 0;
  for (double upto = longest / 64; from < farthest; upto *= 2) {
    for (const Candidate& c : candidates(from, upto)) {
      if (poller_.stopped()) return;
      c.wall ? try_wall(c.from, c.to) : try_corner(c.from, c.to);
    }
    from = upto;
  }
}

LatticePoint LinkBuilder::direction(int link, int corner) const {
  const Link& l = links_[link];
  return at(l.a == corner ? l.b : l.a) - at(corner);
}

bool LinkBuilder::reflex(int corner) const {
  const Corner& c = space_.corners[corner];
  LatticePoint before = at(c.next) - c.at;
  for (const int link : fans_[corner]) {
    const LatticePoint d = direction(link, corner);
    if (!convex_turn(before, d)) return true;
    before = d;
  }
  return !convex_turn(before, at(c.previous) - c.at);
}

/// The angle at a corner that a line in this direction would split; closed if it is no free one.
LinkBuilder::Sector LinkBuilder::sector(int corner, LatticePoint d) const {
  const Corner& c = space_.corners[corner];
  const LatticePoint first = at(c.next) - c.at, last = at(c.previous) - c.at;
  const bool full = same_direction(first, last);  // at the end of a wall
  if (!turns_after(first, first, d) || (!full && !turns_after(first, d, last)))
    return Sector::closed;
  LatticePoint before = first, after = last;
  for (const int link : fans_[corner]) {
    const LatticePoint other = direction(link, corner);
    if (turns_after(first, d, other)) {
      after = other;
      break;
    }
    before = other;
  }
  if (same_direction(before, d)) return Sector::closed;
  return convex_turn(before, after) ? Sector::convex : Sector::reflex;
}

/// Whether the segment meets an edge or a line, shared ends aside, which are left to `sector`.
bool LinkBuilder::crossed(LatticePoint from, LatticePoint to, const Edge& e) const {
  if (e.high.x < std::min(from.x, to.x) || e.low.x > std::max(from.x, to.x) ||
      e.high.y < std::min(from.y, to.y) || e.low.y > std::max(from.y, to.y)) {
    return false;
  }
  if (e.from == from || e.from == to || e.to == from || e.to == to) return false;
  return segments_meet(from, to, e.from, e.to);
}

/// Whether the open segment meets no edge and no line.
bool LinkBuilder::clear(LatticePoint from, LatticePoint to, const Edge* ignored) const {
  std::int64_t looked_at = 1;
  const auto passes = [&](const Edge& e) {
    ++looked_at;
    return &e == ignored || !crossed(from, to, e);
  };
  const bool free = edge_index_.near(from, to, [&](int corner) {
    return passes(edges_[corner]);
  }) && link_index_.near(from, to, [&](int link) {
    return passes(edge_between(at(links_[link].a), at(links_[link].b)));
  });
  return !poller_.stop_after(looked_at) && free;
}

LinkBuilder::Edge LinkBuilder::edge_between(LatticePoint a, LatticePoint b) {
  return {a, b, {std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

void LinkBuilder::set_edge(int corner) {
  edges_[corner] = edge_between(at(corner), at(space_.corners[corner].next));
  edge_index_.add(corner, edges_[corner].from, edges_[corner].to);
}

LatticePoint LinkBuilder::foot(int corner, int wall) const {
  const LatticePoint a = at(walls_[wall]), p = at(corner);
  return a.x == wall_ends_[wall].x ? LatticePoint{a.x, p.y} : LatticePoint{p.x, a.y};
}

std::vector<LinkBuilder::Candidate> LinkBuilder::candidates(double above, double upto) const {
  std::vector<Candidate> list;
  const int count = static_cast<int>(space_.corners.size());
  for (int i = 0; i < count; ++i) {
    if (!reflex(i)) continue;
    std::int64_t looked_at = 1 + static_cast<std::int64_t>(walls_.size());
    const auto consider = [&](LatticePoint target, int to, bool wall) {
      const double length = length_of(target - at(i));
      if (length > above && length <= upto) list.push_back({length, i, to, wall});
    };
    corner_index_.within(at(i), upto, [&](int j) {
      ++looked_at;
      if (j != i) consider(at(j), j, false);
    });
    for (int w = 0; w < static_cast<int>(walls_.size()); ++w) {
      const LatticePoint f = foot(i, w), a = at(walls_[w]), b = wall_ends_[w];
      if (f != a && f != b && f != at(i) && between(a.x, b.x, f.x) && between(a.y, b.y, f.y))
        consider(f, w, true);
    }
    if (poller_.stop_after(looked_at)) return list;
  }
  std::ranges::sort(list, [](const Candidate& a, const Candidate& b) {
    if (a.length != b.length) return a.length < b.length;
    if (a.wall != b.wall) return b.wall;
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  return list;
}

void LinkBuilder::try_corner(int from, int to) {
  const LatticePoint d = at(to) - at(from);
  const Sector here = sector(from, d);
  if (here == Sector::closed) return;
  const Sector there = sector(to, at(from) - at(to));
  if (there == Sector::closed || (here == Sector::convex && there == Sector::convex)) return;
  if (clear(at(from), at(to), nullptr)) add(from, to);
}

void LinkBuilder::try_wall(int from, int wall) {
  const LatticePoint f = foot(from, wall);
  if (sector(from, f - at(from)) != Sector::reflex) return;
  // Feet that came before have cut the wall.
  int corner = walls_[wall];
  while (!on_segment(edges_[corner].from, edges_[corner].to, f))
    corner = space_.corners[corner].next;
  const int next = space_.corners[corner].next;
  if (at(corner) == f || at(next) == f) return try_corner(from, at(corner) == f ? corner : next);
  if (side(at(corner), at(next), at(from)) <= 0) return;
  if (!clear(at(from), f, &edges_[corner])) return;
  const int fresh = static_cast<int>(space_.corners.size());
  space_.corners.push_back({f, next, corner, true});
  space_.corners[corner].next = fresh;
  space_.corners[next].previous = fresh;
  fans_.emplace_back();
  edges_.emplace_back();
  corner_index_.add(fresh, f, f);
  set_edge(corner);
  set_edge(fresh);
  add(from, fresh);
}

void LinkBuilder::add(int a, int b) {
  const int link = static_cast<int>(links_.size());
  links_.push_back({a, b});
  link_index_.add(link, at(a), at(b));
  for (const int corner : {a, b}) {
    auto& fan = fans_[corner];
    const LatticePoint first = at(space_.corners[corner].next) - at(corner);
    const LatticePoint d = direction(link, corner);
    const auto place = std::ranges::find_if(
        fan, [&](int other) { return turns_after(first, d, direction(other, corner)); });
    fan.insert(place, link);
  }
}

bool LinkBuilder::removable(int link, int corner) const {
  const Corner& c = space_.corners[corner];
  const auto& fan = fans_[corner];
  const auto place = std::ranges::find(fan, link);
  const LatticePoint before =
      place == fan.begin() ? at(c.next) - c.at : direction(*(place - 1), corner);
  const LatticePoint after =
      place + 1 == fan.end() ? at(c.previous) - c.at : direction(*(place + 1), corner);
  return convex_turn(before, after);
}

void LinkBuilder::remove_redundant() {
  std::vector<int> order(links_.size());
  std::iota(order.begin(), order.end(), 0);
  const auto length = [this](int link) { return length_of(direction(link, links_[link].a)); };
  std::ranges::sort(
      order, [&](int a, int b) { return length(a) != length(b) ? length(a) > length(b) : a > b; });
  for (const int link : order) {
    const Link l = links_[link];
    if (!removable(link, l.a) || !removable(link, l.b)) continue;
    std::erase(fans_[l.a], link);
    std::erase(fans_[l.b], link);
  }
}

/// Numbers the links that are left from 0.
void LinkBuilder::renumber() {
  std::vector<int> place(links_.size(), -1);
  std::vector<Link> kept;
  for (int link = 0; link < static_cast<int>(links_.size()); ++link) {
    const auto& fan = fans_[links_[link].a];
    if (std::ranges::find(fan, link) == fan.end()) continue;
    place[link] = static_cast<int>(kept.size());
    kept.push_back(links_[link]);
  }
  links_ = std::move(kept);
  for (auto& fan : fans_) {
    for (int& link : fan) link = place[link];
  }
}

}  // namespace lasius::polygon
