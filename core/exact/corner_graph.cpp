#include "core/exact/corner_graph.h"

#include <algorithm>
#include <atomic>

#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/base/thread_team.h"
#include "core/exact/corner_sight.h"
#include "core/exact/place_landmarks.h"
#include "core/grid/grid_view.h"

namespace lasius::exact {
namespace {

constexpr std::int64_t kWordsPerCorner = 64;  // of work, beside the rows scanned
constexpr std::size_t kWordsPerEdge = 16;     // of looking for the way back

}  // namespace

class CornerGraph::Builder {
 public:
  Builder(const Grid& grid, const PrepareOptions& options)
      : map_(view_of(grid)),
        options_(options),
        threads_(thread_count(options.threads)),
        poller_(options.stop),
        graph_(std::make_shared<CornerGraph>()) {}

  std::shared_ptr<CornerGraph> run(const Grid& grid, Preparation& report) {
    count_corners();
    report.vertices = stopped_ ? 0 : corner_count_;
    report.edges = report.bytes = 0;
    fixed_bytes_ = fixed_bytes();
    too_large_ = fixed_bytes_ > options_.max_bytes;
    if (!too_large_) {
      mark_corners();
      list_corners();
      scan();
      if (!stopped_ && !too_large_) list_one_ways();
      graph_->edge_count_ = edges_;
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

  // See CornerGraph::expected_bytes().
  std::int64_t expected() {
    count_corners();
    if (fixed_bytes() > options_.max_bytes) return fixed_bytes();
    mark_corners();
    list_corners();
    CornerSight sight(options_.stop);
    const std::size_t chunks = graph_->chunks_.size();
    const std::size_t few = std::min((chunks + kPerSample - 1) / kPerSample, kMostSamples);
    for (std::size_t i = 0; i < few && !stopped_; ++i)
      scan_chunk((2 * i + 1) * chunks / (2 * few), sight);
    if (few == 0) return fixed_bytes();
    const auto all = edges_ * static_cast<std::int64_t>(chunks) / static_cast<std::int64_t>(few);
    return fixed_bytes() + all * static_cast<std::int64_t>(sizeof(GraphEdge));
  }

 private:
  // Of chunks: one that is looked at among so many, and how many at most.
  static constexpr std::size_t kPerSample = 8, kMostSamples = 16;

  std::uint64_t corners_at(int y, int word) const noexcept;
  void count_corners();
  void mark_corners();
  void list_corners();
  void scan();
  void list_one_ways();
  void scan_chunk(std::size_t chunk, CornerSight& sight);

  // False if stopped; `words` is what was done since the last call.
  bool go_on(std::int64_t words) {
    if (poller_.stop_after(words)) stopped_ = true;
    return !stopped_;
  }

  std::int64_t tiles_across() const noexcept { return (map_.width >> 3) + 1; }
  std::int64_t tiles() const noexcept { return tiles_across() * ((map_.height >> 3) + 1); }
  int words_across() const noexcept { return (map_.width >> 6) + 1; }

  std::int64_t fixed_bytes() const noexcept {
    const auto chunks = (corner_count_ + kChunk - 1) >> kChunkBits;
    return tiles() * 12 +
           corner_count_ *
               static_cast<std::int64_t>(sizeof(GraphCorner) + sizeof(Landmarks::Distances) +
                                         sizeof(std::uint32_t)) +
           chunks * static_cast<std::int64_t>(sizeof(Chunk));
  }

  const kernels::BitmapView map_;
  const PrepareOptions& options_;
  const int threads_;
  Poller poller_;
  std::shared_ptr<CornerGraph> graph_;
  std::int64_t corner_count_ = 0;
  std::int64_t fixed_bytes_ = 0;
  std::atomic<std::int64_t> edges_ = 0;
  std::atomic<bool> too_large_ = false;
  std::atomic<bool> stopped_ = false;
};

// Of the 64 lattice points of a word's columns on line y, a bit for each that is a corner.
std::uint64_t CornerGraph::Builder::corners_at(int y, int word) const noexcept {
  const std::uint64_t* above = map_.row(y - 1) + word;
  const std::uint64_t* below = map_.row(y) + word;
  const std::uint64_t a = above[0], a1 = a << 1 | above[-1] >> 63;
  const std::uint64_t b = below[0], b1 = b << 1 | below[-1] >> 63;
  return ((a ^ b) & ~(a1 | b1)) | ((a1 ^ b1) & ~(a | b));
}

// Counted first: what it takes is known before memory is.
void CornerGraph::Builder::count_corners() {
  for (int y = 1; y < map_.height && go_on(words_across()); ++y) {
    for (int w = 0; w < words_across(); ++w) corner_count_ += std::popcount(corners_at(y, w));
  }
}

// Deals the bits of a line out to the tiles.
void CornerGraph::Builder::mark_corners() {
  CornerGraph& g = *graph_;
  g.tiles_across_ = static_cast<std::size_t>(tiles_across());
  g.tiles_ = ZeroArray<std::uint64_t>(tiles());
  for (int y = 1; y < map_.height && go_on(words_across()); ++y) {
    std::uint64_t* row = g.tiles_.at(static_cast<std::int64_t>(g.tile_of(0, y)));
    for (int w = 0; w < words_across(); ++w) {
      std::uint64_t* tile = row + std::ptrdiff_t{w} * 8;
      for (std::uint64_t left = corners_at(y, w); left != 0; left >>= 8, ++tile)
        if ((left & 0xff) != 0) *tile |= (left & 0xff) << ((y & 7) << 3);
    }
  }
}

void CornerGraph::Builder::list_corners() {
  CornerGraph& g = *graph_;
  g.ranks_.reserve(static_cast<std::size_t>(tiles()));
  g.corners_.reserve(static_cast<std::size_t>(corner_count_));
  for (std::int64_t t = 0; t < tiles(); ++t) {
    const std::uint64_t all = g.tiles_[t];
    if (!go_on(1 + 2 * std::popcount(all))) return;
    g.ranks_.push_back(g.size());
    const int x0 = static_cast<int>(t % tiles_across()) * 8;
    const int y0 = static_cast<int>(t / tiles_across()) * 8;
    for (std::uint64_t bits = all; bits != 0; bits &= bits - 1) {
      const int i = std::countr_zero(bits);
      const int x = x0 + (i & 7), y = y0 + (i >> 3);
      const bool below = map_.blocked(x - 1, y) || map_.blocked(x, y);
      const bool right = map_.blocked(x, y - 1) || map_.blocked(x, y);
      g.corners_.emplace_back(x, y, right ? 1 : -1, below ? 1 : -1);
    }
  }
  g.chunks_.resize((g.corners_.size() + kChunk - 1) >> kChunkBits);
}

void CornerGraph::Builder::scan_chunk(std::size_t chunk, CornerSight& sight) {
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
      for (const auto [x, y] : sight.from(map_, corner.quadrant(side), side)) {
        const std::uint32_t to = g.index(x, y);
        edges.emplace_back(corner, g.corners_[to], to);
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
  g.chunks_[chunk] = {std::make_unique_for_overwrite<GraphEdge[]>(edges.size()), count()};
  std::copy(edges.begin(), edges.end(), g.chunks_[chunk].edges.get());
}

// Each chunk is a function of the map alone, so it does not matter who scans it.
void CornerGraph::Builder::scan() {
  std::vector<CornerSight> team(static_cast<std::size_t>(threads_), CornerSight(options_.stop));
  parallel_for(static_cast<int>(graph_->chunks_.size()), threads_, [&](int chunk, int thread) {
    if (stopped_ || too_large_) return;
    scan_chunk(static_cast<std::size_t>(chunk), team[static_cast<std::size_t>(thread)]);
  });
}

// Found by all threads, listed in the order of the corners.
void CornerGraph::Builder::list_one_ways() {
  CornerGraph& g = *graph_;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> found(g.chunks_.size());
  std::vector<Poller> pollers(static_cast<std::size_t>(threads_), Poller(options_.stop));
  parallel_for(static_cast<int>(found.size()), threads_, [&](int chunk, int thread) {
    const std::uint32_t begin = static_cast<std::uint32_t>(chunk) << kChunkBits;
    for (std::uint32_t v = begin; v < std::min(begin + kChunk, g.size()) && !stopped_; ++v) {
      for (const GraphEdge& edge : g.edges(v)) {
        if (!g.leads_back(v, edge))
          found[static_cast<std::size_t>(chunk)].push_back({v, edge.to()});
      }
      const auto work = static_cast<std::int64_t>(kWordsPerEdge * g.edges(v).size());
      if (pollers[static_cast<std::size_t>(thread)].stop_after(work)) stopped_ = true;
    }
  });
  if (stopped_) return;
  std::size_t count = 1;
  for (const auto& edges : found) count += edges.size();
  const auto bytes = static_cast<std::int64_t>(count * sizeof(OneWay));
  too_large_ = fixed_bytes_ + edges_ * static_cast<std::int64_t>(sizeof(GraphEdge)) + bytes >
               options_.max_bytes;
  if (too_large_) return;
  g.one_way_.resize(g.size());
  g.one_ways_.reserve(count);
  g.one_ways_.push_back({});
  for (const auto& edges : found) {
    for (const auto& [from, to] : edges) g.add_one_way(from, to);
  }
}

std::shared_ptr<CornerGraph> CornerGraph::make(const Grid& grid, const PrepareOptions& options,
                                               Preparation& report) {
  std::shared_ptr<CornerGraph> graph;
  ThreadTeam::lead(thread_count(options.threads),
                   [&] { graph = Builder(grid, options).run(grid, report); });
  return graph;
}

std::int64_t CornerGraph::expected_bytes(const Grid& grid, const PrepareOptions& options) {
  return Builder(grid, options).expected();
}

std::int64_t CornerGraph::bytes() const noexcept {
  return static_cast<std::int64_t>(
             ranks_.size() * (sizeof(std::uint64_t) + sizeof(std::uint32_t)) +
             corners_.size() * sizeof(GraphCorner) + chunks_.size() * sizeof(chunks_[0]) +
             one_way_.size() * sizeof(one_way_[0]) + one_ways_.size() * sizeof(one_ways_[0])) +
         edge_count_ * static_cast<std::int64_t>(sizeof(GraphEdge)) + landmarks_.bytes();
}

}  // namespace lasius::exact
