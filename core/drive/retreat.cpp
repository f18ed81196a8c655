#include "core/drive/retreat.h"

#include <unordered_set>

#include "core/grid/move_rule.h"

namespace lasius {
namespace {

/// splitmix64 (Steele, Lea & Flood 2014): neighbouring numbers give unlike ones.
std::uint64_t mixed(std::uint64_t x) noexcept {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

}  // namespace

std::vector<Cell> find_retreat(const Grid& passable, Corners corners, Cell from,
                               std::uint64_t draw) {
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
  std::size_t at = 1 + mixed(draw) % (reached.size() - 1);
  for (; at != 0; at = reached[at].parent) way.push_back(reached[at].cell);
  return way;
}

}  // namespace lasius
