#include "core/drive/retreat.h"

#include <unordered_set>

#include "core/grid/move_rule.h"
#include "kernels/base/random_stream.h"

namespace lasius {

std::vector<Cell> find_retreat(const Grid& passable, Corners corners, Cell from,
                               std::uint32_t word) {
  constexpr std::size_t kCells = 4096;
  struct Reached {
    Cell cell;
    std::size_t parent;
  };
  static const kernels::Moves moves = moves_of(Neighbours::eight);
  std::vector<Reached> reached{{from, 0}};
  std::unordered_set<std::int64_t> known{std::int64_t{from.y} * passable.width() + from.x};
  for (std::size_t i = 0; i < reached.size() && reached.size() < kCells; ++i) {
    for (int m = 0; m < moves.count; ++m) {
      const Cell to = reached[i].cell + moves.move[m].to;
      if (!move_exists(passable, corners, reached[i].cell, moves.move[m])) continue;
      if (known.insert(std::int64_t{to.y} * passable.width() + to.x).second) {
        reached.push_back({to, i});
      }
    }
  }
  std::vector<Cell> way;
  if (reached.size() == 1) return way;
  auto at =
      1 + static_cast<std::size_t>(kernels::below(static_cast<int>(reached.size()) - 1, word));
  for (; at != 0; at = reached[at].parent) way.push_back(reached[at].cell);
  return way;
}

}  // namespace lasius
