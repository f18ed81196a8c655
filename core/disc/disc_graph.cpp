#include "core/disc/disc_graph.h"

#include <algorithm>
#include <atomic>

#include "core/base/held_bytes.h"
#include "core/base/parallel.h"
#include "core/disc/view.h"

namespace lasius::disc {

namespace {

constexpr std::int64_t kWordsPerArc = 64;  // of work, beside the rows scanned

}  // namespace

class DiscGraph::Builder {
 public:
  Builder(const DiscSpace& space, const PrepareOptions& options)
      : space_(space), options_(options), graph_(std::make_shared<DiscGraph>()) {}

  std::shared_ptr<DiscGraph> run(Preparation& report) {
    const auto arcs = static_cast<std::int64_t>(space_.arcs().size());
    report.vertices = arcs;
    report.edges = report.bytes = 0;
    graph_->chunks_.resize(static_cast<std::size_t>((2 * arcs + kChunk - 1) >> kChunkBits));
    fixed_bytes_ = held_bytes(graph_->chunks_);
    too_large_ = fixed_bytes_ > options_.max_bytes;
    const int threads = thread_count(options_.threads);
    std::vector<Worker> team(static_cast<std::size_t>(threads),
                             Worker{Poller(options_.stop), {}, {}});
    parallel_for(static_cast<int>(graph_->chunks_.size()), threads, [&](int chunk, int thread) {
      if (!stopped_ && !too_large_)
        fill(static_cast<std::uint32_t>(chunk), team[static_cast<std::size_t>(thread)]);
    });
    report.state = too_large_ ? Preparation::State::too_large : Preparation::State::stopped;
    if (too_large_ || stopped_) return nullptr;
    graph_->edge_count_ = edges_;
    report.state = Preparation::State::ready;
    report.edges = edges_;
    report.bytes = graph_->bytes();
    return std::move(graph_);
  }

 private:
  // Of a thread.
  struct Worker {
    Poller poller;
    ViewMemory view;
    std::vector<GraphEdge> edges;  // of the arc in hand
  };
  struct Sink {
    const DiscSpace& space;
    Worker& worker;
    const Arc& from;
    double radius;

    void take(const Seen& seen) {
      if (!space.sees(seen.leaves, seen.arrives)) return;
      const Arc& to = space.arcs()[seen.arc];
      // Lines that do not cross are as long as the centres are apart.
      const double x = to.x - from.x, y = to.y - from.y;
      const bool across = seen.length * seen.length + 2 * radius * radius < x * x + y * y;
      worker.edges.push_back(
          {seen.normal.angle(),
           seen.arc | (seen.rising ? GraphEdge::kRising : 0) | (across ? GraphEdge::kAcross : 0),
           static_cast<std::int16_t>(to.x - from.x), static_cast<std::int16_t>(to.y - from.y)});
    }
    template <int S>
    kernels::ConeLimits limits(int down, int line0) const noexcept {
      const Grid& map = space.map();
      return kernels::whole_map<S>(view_of(map), down > 0 ? map.height() - line0 : line0);
    }
    bool beyond(Point) const noexcept { return false; }
    bool go_on(std::int64_t words) { return !worker.poller.stop_after(words); }
  };

  void fill(std::uint32_t number, Worker& worker) {
    Chunk& chunk = graph_->chunks_[number];
    for (std::uint32_t i = 0; i < kChunk; ++i) {
      const std::uint32_t node = number * kChunk + i;
      if (node < 2 * space_.arcs().size()) look(node / 2, node % 2 != 0, chunk, worker);
      if (worker.poller.stop_after(kWordsPerArc)) stopped_ = true;
      if (stopped_ || too_large_) return;
      chunk.first[i + 1] = static_cast<std::uint32_t>(chunk.edges.size());
    }
    chunk.edges.shrink_to_fit();
    const auto total = edges_ += static_cast<std::int64_t>(chunk.edges.size());
    if (fixed_bytes_ + total * static_cast<std::int64_t>(sizeof(GraphEdge)) > options_.max_bytes)
      too_large_ = true;
  }

  void look(std::uint32_t arc, bool rising, Chunk& chunk, Worker& worker) {
    const Arc& from = space_.arcs()[arc];
    worker.edges.clear();
    Sink sink{space_, worker, from, space_.radius()};
    View<Sink> view(space_, worker.view, sink);
    const Root root = Root::on(space_, arc, rising, normal_at(rising ? from.low : from.high));
    view.look(root);
    view.look_along_wall(root);
    std::ranges::sort(worker.edges, [&](const GraphEdge& a, const GraphEdge& b) {
      if (a.angle != b.angle) return rising ? a.angle > b.angle : a.angle < b.angle;
      if (a.flags() != b.flags()) return a.flags() < b.flags();
      return comes_before(space_.arcs()[a.to()], space_.arcs()[b.to()]);
    });
    const auto last = std::unique(worker.edges.begin(), worker.edges.end());
    chunk.edges.insert(chunk.edges.end(), worker.edges.begin(), last);
  }

  const DiscSpace& space_;
  const PrepareOptions& options_;
  std::shared_ptr<DiscGraph> graph_;
  std::int64_t fixed_bytes_ = 0;
  std::atomic<std::int64_t> edges_ = 0;
  std::atomic<bool> too_large_ = false;
  std::atomic<bool> stopped_ = false;
};

std::shared_ptr<DiscGraph> DiscGraph::make(const DiscSpace& space, const PrepareOptions& options,
                                           Preparation& report) {
  return Builder(space, options).run(report);
}

std::int64_t DiscGraph::bytes() const noexcept {
  return held_bytes(chunks_) + edge_count_ * static_cast<std::int64_t>(sizeof(GraphEdge));
}

}  // namespace lasius::disc
