#include "core/polygon/regions.h"

#include <algorithm>
#include <utility>

namespace lasius::polygon {

Regions::Regions(FreeSpace space, Poller& poller) : space_(std::move(space)) {
  const LinkBuilder builder(space_, poller);
  if (poller.stopped()) return;
  links_ = builder.links();
  cut(builder);
  join_pieces();
  for (const Corner& c : space_.corners)
    reflex_.push_back(convex_turn(at(c.next) - c.at, at(c.previous) - c.at) ? 0 : 1);
}

/// Walks around every region: at a corner always the first way out, clockwise from where it came.
void Regions::cut(const LinkBuilder& builder) {
  const auto& fans = builder.fans();
  const int corners = static_cast<int>(space_.corners.size());
  // Ways out of corners: the edge to next, and each link from a (2 l) and from b (2 l + 1).
  std::vector<int> of_edge(corners, -1), of_link(2 * links_.size(), -1);
  const auto leaves_a = [&](int link, int corner) { return links_[link].a == corner; };
  const auto region_of = [&](int corner, int link) -> int& {
    return link < 0 ? of_edge[corner] : of_link[2 * link + (leaves_a(link, corner) ? 0 : 1)];
  };
  const auto walk = [&](int corner, int link) {
    if (region_of(corner, link) >= 0) return;
    const int number = static_cast<int>(regions_.size());
    Region& region = regions_.emplace_back();
    while (region_of(corner, link) < 0) {
      region_of(corner, link) = number;
      region.sides.push_back({corner, link, -1});
      if (link < 0) {
        corner = space_.corners[corner].next;
        link = fans[corner].empty() ? -1 : fans[corner].back();
      } else {
        corner = leaves_a(link, corner) ? links_[link].b : links_[link].a;
        const auto& fan = fans[corner];
        const auto came = std::ranges::find(fan, link);
        link = came == fan.begin() ? -1 : *(came - 1);
      }
    }
  };
  for (int c = 0; c < corners; ++c) {
    walk(c, -1);
    for (const int link : fans[c]) walk(c, link);
  }
  for (std::size_t l = 0; l < links_.size(); ++l)
    beside_.emplace_back(of_link[2 * l], of_link[2 * l + 1]);
  around_.resize(corners);
  for (int r = 0; r < static_cast<int>(regions_.size()); ++r) {
    for (Side& side : regions_[r].sides) {
      around_[side.corner].push_back(r);
      if (side.link < 0) continue;
      const auto [left, right] = beside_[side.link];
      side.across = leaves_a(side.link, side.corner) ? right : left;
    }
  }
}

void Regions::join_pieces() {
  piece_.assign(regions_.size(), -1);
  std::vector<int> open;
  for (int r = 0; r < static_cast<int>(regions_.size()); ++r) {
    if (piece_[r] >= 0) continue;
    piece_[r] = pieces_;
    open.push_back(r);
    while (!open.empty()) {
      const int one = open.back();
      open.pop_back();
      for (const Side& side : regions_[one].sides) {
        if (side.across < 0 || piece_[side.across] >= 0) continue;
        piece_[side.across] = pieces_;
        open.push_back(side.across);
      }
    }
    ++pieces_;
  }
}

std::vector<int> Regions::holding(LatticePoint p) const {
  std::vector<int> list;
  for (int r = 0; r < static_cast<int>(regions_.size()); ++r) {
    const auto& sides = regions_[r].sides;
    const auto outside = [&](std::size_t i) {
      const std::size_t next = i + 1 < sides.size() ? i + 1 : 0;
      return side(at(sides[i].corner), at(sides[next].corner), p) < 0;
    };
    bool inside = true;
    for (std::size_t i = 0; i < sides.size() && inside; ++i) inside = !outside(i);
    if (inside) list.push_back(r);
  }
  return list;
}

}  // namespace lasius::polygon
