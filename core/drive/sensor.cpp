#include "core/drive/sensor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "lasius/path.h"

namespace lasius {

bool sees(const Grid& world, Cell robot, Cell cell) noexcept {
  const auto in_sight = [&](Cell c) { return c == robot || visible(world, robot, c); };
  if (world.free(cell)) return in_sight(cell);
  const std::array<Cell, 4> beside{
      {{cell.x, cell.y - 1}, {cell.x - 1, cell.y}, {cell.x + 1, cell.y}, {cell.x, cell.y + 1}}};
  return std::any_of(beside.begin(), beside.end(), in_sight);
}

void sense(const Grid& world, const Grid& known, Cell robot, double range, const Growth& robot_disc,
           News& news) {
  news.blocked.clear();
  news.free.clear();
  const int reach = static_cast<int>(std::min<double>(range, Grid::kMaxSide));
  const int left = std::max(robot.x - reach, 0);
  const int right = std::min(robot.x + reach, world.width() - 1);
  for (int y = std::max(robot.y - reach, 0); y <= std::min(robot.y + reach, world.height() - 1);
       ++y) {
    for (int word = left >> 6; word <= right >> 6; ++word) {
      for (std::uint64_t bits = world.row(y)[word] ^ known.row(y)[word]; bits != 0;
           bits &= bits - 1) {
        const Cell cell{word * 64 + std::countr_zero(bits), y};
        if (!in_range(robot, cell, range)) continue;
        if (!robot_disc.blocks(robot, cell) && !sees(world, robot, cell)) continue;
        (world.blocked(cell) ? news.blocked : news.free).push_back(cell);
      }
    }
  }
}

}  // namespace lasius
