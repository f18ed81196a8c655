#include "core/exact/labels/tile_views.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/exact/labels/cell_raster.h"
#include "core/grid/grid_view.h"

namespace lasius::exact {
namespace {

/// The map seen in a mirror: column x is column width - 1 - x. Incomplete when stopped.
class MirroredMap {
 public:
  MirroredMap(const kernels::BitmapView& map, Poller poller)
      : stride_((map.width >> 6) + 3),
        words_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(map.height + 2),
               ~std::uint64_t{0}) {
    view_ = {words_.data() + stride_ + 1, stride_, map.width, map.height};
    for (int y = 0; y < map.height && !poller.stop_after(map.width); ++y) {
      std::uint64_t* row = words_.data() + (y + 1) * stride_ + 1;
      for (int x = 0; x < map.width; ++x)
        if (!map.blocked(x, y))
          row[(map.width - 1 - x) >> 6] ^= std::uint64_t{1} << ((map.width - 1 - x) & 63);
    }
  }
  const kernels::BitmapView& view() const noexcept { return view_; }

 private:
  std::ptrdiff_t stride_;
  std::vector<std::uint64_t> words_;
  kernels::BitmapView view_{};
};

/// That cells of a tile see a corner.
struct Seen {
  std::uint32_t tile, corner;
  std::uint64_t cells;
};

class TileLister {
 public:
  TileLister(const Grid& grid, const TautGraph& graph, std::int64_t most, int threads,
             const StopCondition& stop, LabelArrays& labels)
      : map_(view_of(grid)),
        mirrored_(map_, Poller(stop)),
        graph_(graph),
        most_(most),
        threads_(threads),
        stop_(stop),
        labels_(labels),
        tiles_across_((map_.width + 7) >> 3),
        tiles_(tiles_across_ * ((map_.height + 7) >> 3)) {}

  HubsEnd run() {
    const std::uint32_t n = graph_.size();
    Poller poller(stop_);
    free_.reserve(static_cast<std::size_t>(tiles_));
    for (std::int64_t t = 0; t < tiles_; ++t) {
      if (poller.stop_after(8)) return HubsEnd::stopped;
      free_.push_back(free_cells(t));
    }
    const auto blocks = static_cast<int>((n + kBlock - 1) / kBlock);
    std::vector<std::vector<Seen>> seen(static_cast<std::size_t>(blocks));
    std::vector<std::unique_ptr<Worker>> team;
    team.reserve(static_cast<std::size_t>(threads_));
    for (int i = 0; i < threads_; ++i) team.push_back(std::make_unique<Worker>(tiles_, stop_));
    parallel_for(blocks, threads_, [&](int block, int thread) {
      const auto begin = static_cast<std::uint32_t>(block) * kBlock;
      Worker& worker = *team[static_cast<std::size_t>(thread)];
      auto& part = seen[static_cast<std::size_t>(block)];
      for (std::uint32_t v = begin; v < std::min(begin + kBlock, n) && !stopped_; ++v)
        if (bytes_ <= most_) bytes_ += look(v, worker, part);
      if (worker.poller.stopped()) stopped_ = true;
    });
    team.clear();
    if (!stopped_ && bytes_ > most_) return HubsEnd::too_many;
    if (!stopped_) deal_out(seen);
    return stopped_ ? HubsEnd::stopped : HubsEnd::ready;
  }

 private:
  static constexpr std::uint32_t kBlock = 64;      // corners that one thread looks from in turn
  static constexpr std::uint32_t kTiles = 64;      // that one lists in turn
  static constexpr std::size_t kWordsPerSeen = 4;  // of work, for a corner that a tile sees
  struct alignas(64) Worker {
    Worker(std::int64_t tiles, const StopCondition& stop)
        : poller(stop), cells(static_cast<std::size_t>(tiles)) {}
    Poller poller;
    CellRaster raster;
    std::vector<std::uint64_t> cells;  // by tile
    std::vector<std::uint32_t> touched;
  };

  // Returns the bytes that what it found takes at most.
  std::int64_t look(std::uint32_t v, Worker& worker, std::vector<Seen>& seen) {
    const GraphCorner& corner = graph_.corner(v);
    if (!is_corner(corner)) return 0;
    for (const Side side : {kColumn, kLine}) {
      const Quadrant q = corner.quadrant(side);
      const bool mirror = q.right < 0;
      const auto span = [&](int row, int first, int last) {
        if (mirror) {
          const int other = map_.width - 1 - last;
          last = map_.width - 1 - first;
          first = other;
        }
        mark(row, first, last, worker);
      };
      worker.poller.stop_after(worker.raster.run(
          mirror ? mirrored_.view() : map_, mirror ? map_.width - q.x : q.x, q.y, q.down, span));
    }
    std::size_t bytes = 0;
    for (const std::uint32_t tile : worker.touched) {
      const std::uint64_t cells = std::exchange(worker.cells[tile], 0);
      seen.push_back({tile, v, cells});
      bytes += sizeof(TileCorner) + (cells == free_[tile] ? 0 : sizeof cells);
    }
    worker.touched.clear();
    return static_cast<std::int64_t>(bytes);
  }

  // Numbers of no corner, after edits, have no block there.
  bool is_corner(const GraphCorner& c) const noexcept {
    return c.x() > 0 && c.y() > 0 &&
           map_.blocked(c.block_x() > 0 ? c.x() : c.x() - 1, c.block_y() > 0 ? c.y() : c.y() - 1);
  }

  void mark(int row, int first, int last, Worker& worker) const {
    for (int tx = first >> 3; tx <= last >> 3; ++tx) {
      const int from = std::max(first - 8 * tx, 0), to = std::min(last - 8 * tx, 7);
      const auto bits = static_cast<std::uint64_t>((0xff >> (7 - to)) & (0xff << from) & 0xff);
      const auto tile = static_cast<std::uint32_t>((row >> 3) * tiles_across_ + tx);
      if (worker.cells[tile] == 0) worker.touched.push_back(tile);
      worker.cells[tile] |= bits << ((row & 7) << 3);
    }
  }

  // Can a way over the corner go on from some of these cells? Those of a row lie on one side of it,
  // and the first or the last of them bends the most.
  bool is_live(const Seen& seen) const noexcept {
    const GraphCorner& corner = graph_.corner(seen.corner);
    const int x0 = static_cast<int>(seen.tile % tiles_across_) * 16 + 1;
    const int y0 = static_cast<int>(seen.tile / tiles_across_) * 16 + 1;
    for (int row = 0; row < 8; ++row) {
      const auto cells = static_cast<std::uint8_t>(seen.cells >> (8 * row));
      if (cells == 0) continue;
      const int first = x0 + 2 * std::countr_zero(cells), y = y0 + 2 * row;
      const Side side = corner.side_from(first, y);
      const auto edges = graph_.edges(seen.corner, side);
      if (edges.empty()) continue;
      const int along = edges.front().x - corner.x(), away = edges.front().y - corner.y();
      const int bend = corner.bend(side);
      const int x =
          away * bend > 0 ? first : x0 + 2 * (static_cast<int>(std::bit_width(cells)) - 1);
      const std::int64_t turn =
          std::int64_t{2 * corner.x() - x} * away - std::int64_t{2 * corner.y() - y} * along;
      if (turn * bend >= 0) return true;
    }
    return false;
  }

  std::uint64_t free_cells(std::int64_t tile) const noexcept {
    const int x0 = static_cast<int>(tile % tiles_across_) * 8;
    const int y0 = static_cast<int>(tile / tiles_across_) * 8;
    std::uint64_t free = 0;
    for (int y = 0; y < 8; ++y) {
      if (y0 + y >= map_.height) break;
      const std::uint64_t row = ~map_.row(y0 + y)[x0 >> 6] >> (x0 & 63) & 0xff;
      free |= row << (8 * y);
    }
    return free;
  }

  // Into the order of tiles; within one that of the corners.
  void deal_out(std::vector<std::vector<Seen>>& seen) {
    std::vector<std::uint32_t> first(static_cast<std::size_t>(tiles_) + 1);
    for (const auto& part : seen)
      for (const Seen& s : part) ++first[s.tile + 1];
    for (std::size_t t = 0; t + 1 < first.size(); ++t) first[t + 1] += first[t];
    std::vector<Seen> sorted(first.back());
    auto at = first;
    std::vector<Poller> pollers(static_cast<std::size_t>(threads_), Poller(stop_));
    const auto go_on = [&](std::size_t work, int thread) {
      if (pollers[static_cast<std::size_t>(thread)].stop_after(static_cast<std::int64_t>(work)))
        stopped_ = true;
      return !stopped_;
    };
    for (auto& part : seen) {
      if (!go_on(part.size(), 0)) return;
      for (const Seen& s : part) sorted[at[s.tile]++] = s;
      part = {};
    }
    std::vector<LabelArrays> parts(static_cast<std::size_t>((tiles_ + kTiles - 1) / kTiles));
    std::vector<ByKind> kinds(static_cast<std::size_t>(threads_));
    parallel_for(static_cast<int>(parts.size()), threads_, [&](int part, int thread) {
      const auto begin = static_cast<std::uint32_t>(part) * kTiles;
      for (std::uint32_t t = begin; t < std::min<std::int64_t>(begin + kTiles, tiles_); ++t) {
        if (!go_on(1 + kWordsPerSeen * (first[t + 1] - first[t]), thread)) return;
        list(t, std::span(sorted).subspan(first[t], first[t + 1] - first[t]),
             kinds[static_cast<std::size_t>(thread)], parts[static_cast<std::size_t>(part)]);
      }
    });
    if (stopped_) return;
    std::size_t live = 0, dead = 0, masks = 0;
    for (const LabelArrays& part : parts) {
      live += part.live.size();
      dead += part.dead.size();
      masks += part.masks.size();
    }
    labels_.tiles.reserve(first.size());
    labels_.live.reserve(live);
    labels_.dead.reserve(dead);
    labels_.masks.reserve(masks);
    for (LabelArrays& part : parts) {
      add(part);
      part = {};
    }
    labels_.tiles.push_back(end_of(labels_));
  }

  // Live or dead, and seen by all free cells or some.
  using ByKind = std::array<std::vector<const Seen*>, 4>;

  // A tile with what it sees, in the order of the corners.
  void list(std::uint32_t t, std::span<const Seen> seen, ByKind& kinds, LabelArrays& part) const {
    for (auto& kind : kinds) kind.clear();
    for (const Seen& s : seen)
      kinds[(is_live(s) ? 0 : 2) + (s.cells == free_[t] ? 0 : 1)].push_back(&s);
    part.tiles.push_back(end_of(part));
    Tile& tile = part.tiles.back();
    for (const Seen* s : kinds[0]) part.live.push_back(corner_of(s->corner));
    tile.live_partial = count(part.live);
    for (const Seen* s : kinds[1]) part.live.push_back(corner_of(s->corner));
    for (const Seen* s : kinds[2]) part.dead.push_back(s->corner);
    tile.dead_partial = count(part.dead);
    for (const Seen* s : kinds[3]) part.dead.push_back(s->corner);
    for (const int partial : {1, 3})
      for (const Seen* s : kinds[static_cast<std::size_t>(partial)]) part.masks.push_back(s->cells);
  }

  // Where the next tile begins.
  static Tile end_of(const LabelArrays& part) noexcept {
    const std::uint32_t live = count(part.live), dead = count(part.dead);
    return {live, live, dead, dead, count(part.masks)};
  }

  void add(const LabelArrays& part) {
    const Tile before = end_of(labels_);
    for (const Tile& t : part.tiles)
      labels_.tiles.push_back({before.live_full + t.live_full, before.live_full + t.live_partial,
                               before.dead_full + t.dead_full, before.dead_full + t.dead_partial,
                               before.masks + t.masks});
    labels_.live.insert(labels_.live.end(), part.live.begin(), part.live.end());
    labels_.dead.insert(labels_.dead.end(), part.dead.begin(), part.dead.end());
    labels_.masks.insert(labels_.masks.end(), part.masks.begin(), part.masks.end());
  }

  template <class T>
  static std::uint32_t count(const std::vector<T>& list) {
    return static_cast<std::uint32_t>(list.size());
  }

  TileCorner corner_of(std::uint32_t v) const noexcept {
    const GraphCorner& c = graph_.corner(v);
    return {v, static_cast<std::uint16_t>(c.x() | (c.block_x() > 0 ? 0x8000 : 0)),
            static_cast<std::uint16_t>(c.y() | (c.block_y() > 0 ? 0x8000 : 0))};
  }

  const kernels::BitmapView map_;
  const MirroredMap mirrored_;
  const TautGraph& graph_;
  const std::int64_t most_;
  const int threads_;
  const StopCondition& stop_;
  LabelArrays& labels_;
  const std::int64_t tiles_across_, tiles_;
  std::vector<std::uint64_t> free_;  // cells, by tile
  std::atomic<std::int64_t> bytes_ = 0;
  std::atomic<bool> stopped_ = false;
};

}  // namespace

HubsEnd list_tiles(const Grid& grid, const TautGraph& graph, std::int64_t most, int threads,
                   const StopCondition& stop, LabelArrays& labels) {
  return TileLister(grid, graph, most, threads, stop, labels).run();
}

}  // namespace lasius::exact
