#include "core/genetic/grid_ga_route.h"

#include <algorithm>

#include "core/base/poller.h"
#include "core/grid/move_rule.h"

namespace lasius {

void RouteMaker::reset(const Grid& grid, const RouteMoves& moves) {
  forget();
  grid_ = &grid;
  moves_ = moves;
  words_ = grid.words();
  const std::int64_t room = std::int64_t{words_} * grid.height();
  if (room > room_) entered_ = ZeroArray<std::uint64_t>(room);
  room_ = std::max(room, room_);
}

void RouteMaker::mark(Cell c) {
  marked_.push_back(c);
  word_of(c) |= std::uint64_t{1} << (c.x & 63);
}

void RouteMaker::forget() noexcept {
  for (const Cell c : marked_) word_of(c) = 0;
  marked_.clear();
}

bool RouteMaker::legal(Cell at, int dx, int dy) const noexcept {
  if (grid_->blocked({at.x + dx, at.y + dy})) return false;
  if (dx == 0 || dy == 0) return true;
  return moves_.neighbours > 4 &&
         diagonal_allowed(*grid_, moves_.corners, {at.x + dx, at.y}, {at.x, at.y + dy});
}

Cell RouteMaker::nearest_open(Cell at, Cell to) const noexcept {
  Cell nearest = at;
  std::int64_t least = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Cell next{at.x + dx, at.y + dy};
      if (next == at || !legal(at, dx, dy) || entered(next)) continue;
      const std::int64_t x = to.x - next.x, y = to.y - next.y;
      if (nearest == at || x * x + y * y < least) {
        nearest = next;
        least = x * x + y * y;
      }
    }
  }
  return nearest;
}

bool RouteMaker::extend(std::vector<Cell>& route, Cell to, Poller& poller) {
  const std::size_t first = route.size();
  mark(route.back());
  while (route.back() != to && !poller.stop_after(1)) {
    const Cell at = route.back();
    const Cell next = nearest_open(at, to);
    if (next == at) {
      if (route.size() == first) break;
      route.pop_back();
      continue;
    }
    mark(next);
    route.push_back(next);
  }
  forget();
  if (route.back() == to) return true;
  route.resize(first);
  return false;
}

}  // namespace lasius
