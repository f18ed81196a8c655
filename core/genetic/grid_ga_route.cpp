#include "core/genetic/grid_ga_route.h"

#include "core/grid/move_rule.h"

namespace lasius {

void RouteMaker::reset(const Grid& grid, Neighbours neighbours, Corners corners,
                       const StopCondition& stop) {
  grid_ = &grid;
  moves_ = moves_of(neighbours);
  corners_ = corners;
  words_ = grid.words();
  Poller poller(stop);
  const std::int64_t room = std::int64_t{words_} * grid.height();
  if (entered_.renew(room, marked_count_ > 0, poller)) marked_count_ = 0;
}

void RouteMaker::mark(Cell c) {
  if (marked_count_ == marked_.size()) marked_.grow(2 * marked_count_ + 64);
  marked_.data()[marked_count_++] = c;
  entered_[word_of(c)] |= std::uint64_t{1} << (c.x & 63);
}

/// Leaves all as it is when stopped: then no other walk follows.
void RouteMaker::forget(Poller& poller) {
  for (std::size_t i = 0; i < marked_count_; ++i) {
    if (poller.stop_after(1)) return;
    entered_[word_of(marked_.data()[i])] = 0;
  }
  marked_count_ = 0;
}

Cell RouteMaker::nearest_open(Cell at, Cell to) const noexcept {
  Cell nearest = at;
  std::int64_t least = 0;
  for (int k = 0; k < moves_.count; ++k) {
    const Cell next = at + moves_[k].to;
    if (!move_exists(*grid_, corners_, at, moves_[k]) || entered(next)) continue;
    const std::int64_t x = to.x - next.x, y = to.y - next.y;
    if (nearest == at || x * x + y * y < least) {
      nearest = next;
      least = x * x + y * y;
    }
  }
  return nearest;
}

bool RouteMaker::extend(std::vector<Cell>& route, Cell to, Poller& poller) {
  constexpr int kStepsACell = 4;  // eight cells are looked at, each with those beside it
  const std::size_t first = route.size();
  mark(route.back());
  while (route.back() != to && !poller.stop_after(kStepsACell)) {
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
  forget(poller);
  if (route.back() == to) return true;
  route.resize(first);
  return false;
}

}  // namespace lasius
