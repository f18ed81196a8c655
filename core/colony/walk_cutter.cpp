#include "core/colony/walk_cutter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/held_bytes.h"
#include "core/base/poller.h"
#include "core/grid/move_rule.h"

namespace lasius {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

bool WalkCutter::collect(const kernels::Moves& moves, Cell start,
                         std::span<const std::uint8_t> tour, const StopCondition& stop) {
  Poller poller(stop, Poller::kSteps);
  cells_.reset(tour.size() + 1);
  Cell c = start;
  cells_.add(c);
  for (const int k : tour) {
    c = c + moves[k].to;
    cells_.add(c);
    if (poller.stop_after(1)) return false;
  }
  tiles_.clear();
  std::int32_t first = 0;
  for (const CellSet::Tile& from : cells_.tiles()) {
    Tile& tile = tiles_.emplace_back();
    tile.first = first;
    first += std::popcount(from.cells);
    const Cell corner = from.cell(0);
    for (int i = 0; i < 9; ++i) {
      const Cell to{corner.x + 8 * (i % 3 - 1), corner.y + 8 * (i / 3 - 1)};
      tile.around[i] = cells_.find(CellSet::key_of(to));
    }
    if (poller.stop_after(9)) return false;
  }
  nodes_.assign(static_cast<std::size_t>(first), {kInfinity, 0, 0});
  for (auto& bucket : buckets_) bucket.clear();
  return true;
}

std::int32_t WalkCutter::number(Entry e) const noexcept {
  const std::uint64_t below = (std::uint64_t{1} << e.bit) - 1;
  return tiles_[e.tile].first + std::popcount(cells_.tiles()[e.tile].cells & below);
}

WalkCutter::Entry WalkCutter::entry(Cell c) const noexcept {
  return {0, cells_.find(CellSet::key_of(c)), CellSet::bit_of(c)};
}

void WalkCutter::expand(const Grid& grid, Corners corners, const kernels::Moves& moves,
                        Entry from) {
  const std::int32_t at = number(from);
  if (from.length > nodes_[at].length) return;  // reached by a shorter way since
  const Cell c = cells_.tiles()[from.tile].cell(from.bit);
  for (int k = 0; k < moves.count; ++k) {
    const int x = (from.bit & 7) + moves[k].to.dx, y = (from.bit >> 3) + moves[k].to.dy;
    const std::int32_t tile = tiles_[from.tile].around[((y >> 3) + 1) * 3 + (x >> 3) + 1];
    if (tile == CellSet::kNone) continue;
    const Entry to{from.length + moves[k].length, tile, (y & 7) * 8 + (x & 7)};
    if ((cells_.tiles()[tile].cells >> to.bit & 1) == 0) continue;
    Node& node = nodes_[number(to)];
    if (!(to.length < node.length) || !move_exists(grid, corners, c, moves[k])) continue;
    node = {to.length, at, static_cast<std::uint8_t>(k)};
    buckets_[static_cast<std::int64_t>(to.length) % kBuckets].push_back(to);
  }
}

std::int64_t WalkCutter::cut(const Grid& grid, Corners corners, const kernels::Moves& moves,
                             Cell start, std::span<const std::uint8_t> tour,
                             const StopCondition& stop, GrowingArray<std::uint8_t>& way) {
  if (!collect(moves, start, tour, stop)) return -1;
  Cell end = start;
  for (const int k : tour) end = end + moves[k].to;
  const std::int32_t first = number(entry(start)), last = number(entry(end));
  nodes_[first].length = 0;
  buckets_[0].push_back(entry(start));
  Poller poller(stop, Poller::kSteps);
  for (std::int64_t b = 0; static_cast<double>(b) <= nodes_[last].length; ++b) {
    auto& bucket = buckets_[b % kBuckets];
    for (const Entry e : bucket) {
      expand(grid, corners, moves, e);
      if (poller.stop_after(1)) return -1;
    }
    bucket.clear();
  }
  std::int64_t count = 0;
  for (std::int32_t n = last; n != first; n = nodes_[n].before) ++count;
  way.grow(static_cast<std::size_t>(count));
  std::int64_t i = count;
  for (std::int32_t n = last; n != first; n = nodes_[n].before) way.data()[--i] = nodes_[n].move;
  return count;
}

std::int64_t WalkCutter::bytes() const noexcept {
  std::int64_t bytes = cells_.bytes() + held_bytes(tiles_, nodes_);
  for (const auto& bucket : buckets_) bytes += held_bytes(bucket);
  return bytes;
}

}  // namespace lasius
