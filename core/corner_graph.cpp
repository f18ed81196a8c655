#include "corner_graph.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>

#include "corner_view.h"
#include "grid_view.h"
#include "kernels/sight.h"
#include "parallel.h"
#include "place_landmarks.h"

namespace lasius::exact {
namespace {

constexpr std::int64_t kWordsPerCorner = 64;  // of work, beside the rows scanned

// The corners that one corner sees on one side, put in order.
class Sight {
 public:
  explicit Sight(const StopCondition& stop) : poller_(stop) {}

  void corner(int x, int y) { seen_.push_back({x, y}); }
  bool go_on(std::int64_t words) { return !poller_.stop_after(words); }

  // From the block's edge on, the nearer of two in the same direction first.
  std::span<const kernels::HalfPoint> from(const kernels::BitmapView& map, const GraphCorner& c,
                                           Side side) {
    seen_.clear();
    const int right = side == kColumn ? -c.block_x() : c.block_x();
    const int down = side == kColumn ? c.block_y() : -c.block_y();
    const bool line = side == kLine;
    if (right > 0) {
      view_quadrant<1>(map, c.x(), c.y(), down, line, stack_, *this);
    } else {
      view_quadrant<-1>(map, c.x(), c.y(), down, line, stack_, *this);
    }
    const auto before = [&](kernels::HalfPoint a, kernels::HalfPoint b) {
      const std::int64_t ax = std::abs(a.x - c.x()), ay = std::abs(a.y - c.y());
      const std::int64_t bx = std::abs(b.x - c.x()), by = std::abs(b.y - c.y());
      const std::int64_t turn = line ? ay * bx - by * ax : ax * by - bx * ay;
      return turn != 0 ? turn < 0 : ax + ay < bx + by;
    };
    std::sort(seen_.begin(), seen_.end(), before);
    seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
    return seen_;
  }

 private:
  Poller poller_;
  std::vector<kernels::Interval> stack_;
  std::vector<kernels::HalfPoint> seen_;
};

}  // namespace

class CornerGraph::Builder {
 public:
  Builder(const Grid& grid, const PrepareOptions& options)
      : map_(view_of(grid)),
        options_(options),
        threads_(options.threads > 0 ? options.threads : omp_get_max_threads()),
        graph_(std::make_shared<CornerGraph>()) {}

  std::shared_ptr<const CornerGraph> run(const Grid& grid, Preparation& report) {
    number_corners();
    report.corners = corner_count_;
    report.edges = report.bytes = 0;
    fixed_bytes_ = fixed_bytes();
    if (fixed_bytes_ <= options_.max_bytes) {
      list_corners();
      scan();
      graph_->edge_count_ = edges_;
    } else {
      too_large_ = true;
    }
    report.state = too_large_ ? Preparation::State::too_large : Preparation::State::stopped;
    if (too_large_ || stopped_) return nullptr;
    graph_->landmarks_ = place_landmarks(grid, *graph_, threads_, options_.stop);
    if (options_.stop.poll() != StopCondition::Cause::none) return nullptr;
    graph_->detour_ = measure_detour(*graph_);
    report.state = Preparation::State::ready;
    report.edges = edges_;
    report.bytes = graph_->bytes();
    return std::move(graph_);
  }

 private:
  void number_corners();
  void list_corners();
  void scan();
  void scan_chunk(std::size_t chunk, Sight& sight);

  std::int64_t fixed_bytes() const noexcept {
    const auto chunks = (corner_count_ + kChunk - 1) >> kChunkBits;
    return static_cast<std::int64_t>(graph_->tiles_.size()) * 12 +
           corner_count_ *
               static_cast<std::int64_t>(sizeof(GraphCorner) + sizeof(Landmarks::Distances)) +
           chunks * 8;
  }

  const kernels::BitmapView map_;
  const PrepareOptions& options_;
  const int threads_;
  std::shared_ptr<CornerGraph> graph_;
  std::int64_t corner_count_ = 0;
  std::int64_t fixed_bytes_ = 0;
  std::atomic<std::int64_t> edges_ = 0;
  std::atomic<bool> too_large_ = false;
  std::atomic<bool> stopped_ = false;
};

// Corners are found 64 at a time, from the rows above and below a line, and their bits dealt out to
// the tiles.
void CornerGraph::Builder::number_corners() {
  CornerGraph& g = *graph_;
  g.tiles_across_ = static_cast<std::size_t>(map_.width >> 3) + 1;
  const auto tiles_down = static_cast<std::size_t>(map_.height >> 3) + 1;
  g.tiles_.assign(g.tiles_across_ * tiles_down, 0);
  const int words = (map_.width >> 6) + 1;
  for (int y = 1; y < map_.height; ++y) {
    const std::uint64_t* above = map_.row(y - 1);
    const std::uint64_t* below = map_.row(y);
    const std::size_t row = g.tile_of(0, y);
    for (int w = 0; w < words; ++w) {
      const std::uint64_t a = above[w], a1 = a << 1 | above[w - 1] >> 63;
      const std::uint64_t b = below[w], b1 = b << 1 | below[w - 1] >> 63;
      const std::uint64_t one = ((a ^ b) & ~(a1 | b1)) | ((a1 ^ b1) & ~(a | b));
      for (std::size_t i = 0; i < 8 && one != 0; ++i) {
        const std::size_t across = static_cast<std::size_t>(w) * 8 + i;
        if (across >= g.tiles_across_) break;
        g.tiles_[row + across] |= (one >> (8 * i) & 0xff) << ((y & 7) << 3);
      }
    }
  }
  g.ranks_.resize(g.tiles_.size());
  for (std::size_t t = 0; t < g.tiles_.size(); ++t) {
    g.ranks_[t] = static_cast<std::uint32_t>(corner_count_);
    corner_count_ += std::popcount(g.tiles_[t]);
  }
}

void CornerGraph::Builder::list_corners() {
  CornerGraph& g = *graph_;
  g.corners_.reserve(static_cast<std::size_t>(corner_count_));
  for (std::size_t t = 0; t < g.tiles_.size(); ++t) {
    const int x0 = static_cast<int>(t % g.tiles_across_) * 8;
    const int y0 = static_cast<int>(t / g.tiles_across_) * 8;
    for (std::uint64_t bits = g.tiles_[t]; bits != 0; bits &= bits - 1) {
      const int i = std::countr_zero(bits);
      const int x = x0 + (i & 7), y = y0 + (i >> 3);
      const bool below = map_.blocked(x - 1, y) || map_.blocked(x, y);
      const bool right = map_.blocked(x, y - 1) || map_.blocked(x, y);
      g.corners_.emplace_back(x, y, right ? 1 : -1, below ? 1 : -1);
    }
  }
  g.chunks_.resize((g.corners_.size() + kChunk - 1) >> kChunkBits);
}

void CornerGraph::Builder::scan_chunk(std::size_t chunk, Sight& sight) {
  CornerGraph& g = *graph_;
  std::vector<GraphEdge> edges;
  const std::size_t begin = chunk << kChunkBits;
  const std::size_t end = std::min(begin + kChunk, g.corners_.size());
  const auto count = [&] { return static_cast<std::uint32_t>(edges.size()); };
  for (std::size_t i = begin; i < end; ++i) {
    GraphCorner& corner = g.corners_[i];
    corner.first = count();
    for (const Side side : {kColumn, kLine}) {
      if (side == kLine) corner.middle = count();
      for (const auto [x, y] : sight.from(map_, corner, side)) {
        const std::uint32_t to = g.index(x, y);
        const Side onward = g.corners_[to].side_from(2 * corner.x(), 2 * corner.y());
        edges.push_back({to | (onward == kLine ? GraphEdge::kSideBit : 0),
                         static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
      }
    }
    corner.last = count();
    if (!sight.go_on(kWordsPerCorner)) stopped_ = true;
    if (stopped_ || too_large_) return;
  }
  const auto total = edges_ += count();
  if (fixed_bytes_ + total * static_cast<std::int64_t>(sizeof(GraphEdge)) > options_.max_bytes) {
    too_large_ = true;
    return;
  }
  g.chunks_[chunk] = std::make_unique_for_overwrite<GraphEdge[]>(edges.size());
  std::copy(edges.begin(), edges.end(), g.chunks_[chunk].get());
}

// Each chunk is a function of the map alone, so it does not matter who scans it.
void CornerGraph::Builder::scan() {
  std::vector<Sight> team(static_cast<std::size_t>(threads_), Sight(options_.stop));
  parallel_for(static_cast<int>(graph_->chunks_.size()), threads_, [&](int chunk, int thread) {
    if (stopped_ || too_large_) return;
    scan_chunk(static_cast<std::size_t>(chunk), team[static_cast<std::size_t>(thread)]);
  });
}

std::shared_ptr<const CornerGraph> CornerGraph::make(const Grid& grid,
                                                     const PrepareOptions& options,
                                                     Preparation& report) {
  return Builder(grid, options).run(grid, report);
}

std::int64_t CornerGraph::bytes() const noexcept {
  return static_cast<std::int64_t>(
             tiles_.size() * sizeof(std::uint64_t) + ranks_.size() * sizeof(std::uint32_t) +
             corners_.size() * sizeof(GraphCorner) + chunks_.size() * sizeof(chunks_[0])) +
         edge_count_ * static_cast<std::int64_t>(sizeof(GraphEdge)) + landmarks_.bytes();
}

}  // namespace lasius::exact
