#include "core/drive/retreat.h"

#include <algorithm>
#include <unordered_set>

#include "core/grid/move_rule.h"
#include "kernels/base/random_stream.h"

namespace lasius {
namespace {

struct Reached {
  Cell cell;
  std::size_t parent;
};

/// Cells by the number of moves that lead there, `from` first; to the first that is wanted, or at
/// least `most`.
template <class Wanted>
std::vector<Reached> reach(const Grid& grid, Corners corners, const kernels::Moves& moves,
                           Cell from, std::size_t most, const Wanted& wanted) {
  std::vector<Reached> reached{{from, 0}};
  std::unordered_set<std::int64_t> known{std::int64_t{from.y} * grid.width() + from.x};
  for (std::size_t i = 0; i < reached.size() && reached.size() < most; ++i) {
    for (int m = 0; m < moves.count; ++m) {
      const Cell to = reached[i].cell + moves.move[m].to;
      if (!move_exists(grid, corners, reached[i].cell, moves.move[m])) continue;
      if (!known.insert(std::int64_t{to.y} * grid.width() + to.x).second) continue;
      reached.push_back({to, i});
      if (wanted(to)) return reached;
    }
  }
  return reached;
}

/// The walk to a cell, last cell first, without the first one.
std::vector<Cell> walk_back(const std::vector<Reached>& reached, std::size_t at) {
  std::vector<Cell> way;
  for (; at != 0; at = reached[at].parent) way.push_back(reached[at].cell);
  return way;
}

}  // namespace

std::vector<Cell> find_retreat(const Grid& passable, Corners corners, Cell from,
                               std::uint32_t word) {
  static const kernels::Moves moves = moves_of(Neighbours::eight);
  const auto reached = reach(passable, corners, moves, from, 4096, [](Cell) { return false; });
  if (reached.size() == 1) return {};
  return walk_back(reached, 1 + static_cast<std::size_t>(
                                    kernels::below(static_cast<int>(reached.size()) - 1, word)));
}

std::vector<Cell> find_way_out(const Grid& map, Corners corners, Cell from,
                               const std::function<bool(Cell)>& wanted) {
  static const kernels::Moves moves = [] {
    kernels::Moves straight_first = moves_of(Neighbours::eight);
    std::stable_sort(straight_first.move.begin(),
                     straight_first.move.begin() + straight_first.count,
                     [](const auto& a, const auto& b) { return a.length < b.length; });
    return straight_first;
  }();
  bool found = false;
  const auto reached =
      reach(map, corners, moves, from, 65536, [&](Cell c) { return found = wanted(c); });
  if (!found) return {};
  std::vector<Cell> way = walk_back(reached, reached.size() - 1);
  way.push_back(from);
  std::ranges::reverse(way);
  return way;
}

}  // namespace lasius
