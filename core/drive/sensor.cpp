#include "core/drive/sensor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "lasius/path/path.h"

namespace lasius {
namespace {

bool sees(const Grid& world, Cell robot, Cell cell) noexcept {
  const auto in_sight = [&](Cell c) { return c == robot || visible(world, robot, c); };
  if (world.free(cell)) return in_sight(cell);
  const std::array<Cell, 4> beside{
      {{cell.x, cell.y - 1}, {cell.x - 1, cell.y}, {cell.x + 1, cell.y}, {cell.x, cell.y + 1}}};
  return std::ranges::any_of(beside, in_sight);
}

bool within(Cell robot, Cell cell, double range) noexcept {
  const double dx = cell.x - robot.x, dy = cell.y - robot.y;
  return dx * dx + dy * dy <= range * range;
}

/// Calls visit(cell) for the cells in range whose bits word_of(word, y) has.
template <class WordOf, class Visit>
void for_each_in_range(const Grid& world, Cell robot, double range, const WordOf& word_of,
                       const Visit& visit) {
  const int reach = static_cast<int>(std::min<double>(range, Grid::kMaxSide));
  const int left = std::max(robot.x - reach, 0);
  const int right = std::min(robot.x + reach, world.width() - 1);
  for (int y = std::max(robot.y - reach, 0); y <= std::min(robot.y + reach, world.height() - 1);
       ++y) {
    for (int word = left >> 6; word <= right >> 6; ++word) {
      for (std::uint64_t bits = word_of(word, y); bits != 0; bits &= bits - 1) {
        const Cell cell{word * 64 + std::countr_zero(bits), y};
        if (within(robot, cell, range)) visit(cell);
      }
    }
  }
}

}  // namespace

void mark_walls_in_sight(const Grid& world, Cell robot, double range, Grid& walls) {
  for_each_in_range(
      world, robot, range,
      [&](int word, int y) { return world.row(y)[word] & ~walls.row(y)[word]; },
      [&](Cell cell) {
        if (sees(world, robot, cell)) walls.set_blocked(cell);
      });
}

Grid walls_of_both(const Grid& a, const Grid& b) {
  Grid both = a;
  std::vector<std::uint64_t> words(static_cast<std::size_t>(a.words()));
  for (int y = 0; y < a.height(); ++y) {
    std::transform(a.row(y), a.row(y) + a.words(), b.row(y), words.begin(), std::bit_or<>());
    both.set_row(y, words.data());
  }
  return both;
}

std::vector<Cell> walls_without(const Grid& walls, const Grid& a, const Grid* b) {
  std::vector<Cell> cells;
  for (int y = 0; y < walls.height(); ++y) {
    for (int word = 0; word < walls.words(); ++word) {
      auto bits = walls.row(y)[word] & ~a.row(y)[word];
      if (b != nullptr) bits &= ~b->row(y)[word];
      for (; bits != 0; bits &= bits - 1) cells.push_back({word * 64 + std::countr_zero(bits), y});
    }
  }
  return cells;
}

void sense(const Grid& world, const Grid& known, Cell robot, double range, const Body& body,
           News& news) {
  news.blocked.clear();
  news.free.clear();
  for_each_in_range(
      world, robot, std::max(range, body.reach),
      [&](int word, int y) { return world.row(y)[word] ^ known.row(y)[word]; },
      [&](Cell cell) {
        const bool seen = within(robot, cell, range) && sees(world, robot, cell);
        if (!seen && !body.covers(cell)) return;
        (world.blocked(cell) ? news.blocked : news.free).push_back(cell);
      });
}

}  // namespace lasius
