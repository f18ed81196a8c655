#include "core/colony/walk_cutter.h"

#include "core/base/held_bytes.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/grid/move_rule.h"

namespace lasius {

bool WalkCutter::collect(const kernels::Moves& moves, Cell start,
                         std::span<const std::uint8_t> tour,
                         std::span<const kernels::PackedCell> more, const StopCondition& stop) {
  Poller poller(stop, Poller::kSteps);
  cells_.reset(tour.size() + more.size() + 1);
  Cell c = start;
  cells_.add(c);
  for (const int k : tour) {
    c = c + moves[k].to;
    cells_.add(c);
    if (poller.stop_after(1)) return false;
  }
  for (const kernels::PackedCell packed : more) {
    cells_.add({kernels::packed_x(packed), kernels::packed_y(packed)});
    if (poller.stop_after(1)) return false;
  }
  around_.clear();
  nodes_.clear();
  for (const CellSet::Tile& tile : cells_.tiles()) {
    const Cell corner = tile.cell(0);
    Around& around = around_.emplace_back();
    for (int i = 0; i < 9; ++i) {
      const Cell to{corner.x + 8 * (i % 3 - 1), corner.y + 8 * (i / 3 - 1)};
      around[i] = cells_.find(CellSet::key_of(to));
    }
    nodes_.insert(nodes_.end(), 64, {kInfinity, 0, 0});
    if (poller.stop_after(32)) return false;
  }
  for (auto& bucket : buckets_) bucket.clear();
  return true;
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
    const std::int32_t tile = around_[from.tile][((y >> 3) + 1) * 3 + (x >> 3) + 1];
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
                             std::span<const kernels::PackedCell> more, const StopCondition& stop,
                             GrowingArray<std::uint8_t>& way) {
  if (!collect(moves, start, tour, more, stop)) return -1;
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
  std::int64_t bytes = cells_.bytes() + held_bytes(around_, nodes_);
  for (const auto& bucket : buckets_) bytes += held_bytes(bucket);
  return bytes;
}

}  // namespace lasius
