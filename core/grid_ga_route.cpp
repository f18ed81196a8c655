#include "grid_ga_route.h"

#include <cstdlib>
#include <new>

namespace lasius {

void RouteMaker::Free::operator()(std::uint64_t* p) const noexcept { std::free(p); }

RouteMaker::RouteMaker(const Grid& grid, const RouteMoves& moves) : grid_(grid), moves_(moves) {
  const auto words = static_cast<std::size_t>(grid.words()) * grid.height();
  entered_.reset(static_cast<std::uint64_t*>(std::calloc(words, sizeof(std::uint64_t))));
  if (entered_ == nullptr) throw std::bad_alloc();
}

bool RouteMaker::entered(Cell c) const noexcept {
  return (entered_[static_cast<std::size_t>(c.y) * grid_.words() + (c.x >> 6)] >> (c.x & 63) & 1) !=
         0;
}

void RouteMaker::mark(Cell c) {
  entered_[static_cast<std::size_t>(c.y) * grid_.words() + (c.x >> 6)] |= std::uint64_t{1}
                                                                          << (c.x & 63);
  marked_.push_back(c);
}

bool RouteMaker::legal(Cell at, int dx, int dy) const noexcept {
  if (grid_.blocked({at.x + dx, at.y + dy})) return false;
  if (dx == 0 || dy == 0) return true;
  if (moves_.neighbours == 4) return false;
  const int free_sides = grid_.free({at.x + dx, at.y}) + grid_.free({at.x, at.y + dy});
  return free_sides >=
         (moves_.corners == Corners::forbid ? 2 : moves_.corners == Corners::one_side);
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
  for (const Cell c : marked_)
    entered_[static_cast<std::size_t>(c.y) * grid_.words() + (c.x >> 6)] = 0;
  marked_.clear();
  if (route.back() == to) return true;
  route.resize(first);
  return false;
}

}  // namespace lasius
