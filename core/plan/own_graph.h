// The visibility graph that a planner makes for itself once it pays.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <memory>

#include "core/exact/corner_graph.h"
#include "core/exact/exact.h"
#include "lasius/plan/preparation.h"

namespace lasius {

/// Of a map that is not prepared, shared by all threads that plan on it. Ordinary searches tell
/// what one takes, in expansions and rows; when the 64th one ends, and with each doubling, the
/// thread that counts it makes the graph if that is a small part of what was done, or of what is
/// known to come. From there on queries are asked of the graph, where the shortest path is the only
/// one; until then, and where another one may be as short, the ordinary search answers: no answer
/// depends on whether there is a graph, nor when.
class OwnGraph {
 public:
  static constexpr std::int64_t kMostBytes = std::int64_t{128} << 20;

  /// What it may hold; 0: none is made, and one that was made is not asked.
  void limit(std::int64_t bytes) noexcept { most_bytes_ = bytes; }

  /// To be asked; null while there is none, and where it is in vain.
  const exact::CornerGraph* graph() const noexcept {
    return on_.load(std::memory_order_acquire) && most_bytes_ > 0 ? graph_.get() : nullptr;
  }
  /// Whether it was, and answered. Where many paths are as short, as in warehouses and noise, it is
  /// in vain, and where searches tell so before, none is made.
  void count_asked(bool told) noexcept {
    told_ += told ? 1 : 0;
    if (++asked_ >= kFirst && in_vain()) on_ = false;
  }
  /// An ordinary search has ended. May make the graph, unless stopped.
  void count_search(const Grid& grid, const exact::Counters& counters, const StopCondition& stop) {
    work_ += counters.expansions * exact::kWordsPerExpansion + counters.words;
    if (counters.ties == exact::Counters::Ties::none) told_ += 1;
    if (counters.ties != exact::Counters::Ties::unknown) ++asked_;
    if (const std::int64_t done = ++done_;
        done >= kFirst && std::has_single_bit(std::uint64_t(done)))
      make(grid, done, stop);
  }
  /// A batch of so many plans begins.
  void expect(std::int64_t plans) noexcept { expected_ += plans; }

  std::int64_t bytes() const noexcept { return made_bytes_; }  ///< held

 private:
  static constexpr std::int64_t kFirst = 64;
  // Of work: what is not worth a look around from start and goal, and what a byte of the graph
  // takes to make, twice, times how often that must be spent or be known to come before it is.
  static constexpr std::int64_t kLeastWork = 2000;
  static constexpr std::int64_t kWorkPerByteDone = 4, kWorkPerByteToCome = 16;

  bool in_vain() const noexcept { return 4 * told_ < 3 * asked_; }

  void make(const Grid& grid, std::int64_t done, const StopCondition& stop) {
    const std::int64_t mean = work_ / done;
    if (mean < kLeastWork || in_vain() || making_.exchange(true)) return;
    const std::int64_t worth =
        mean * std::max(done / kWorkPerByteDone, (expected_ - done) / kWorkPerByteToCome);
    const PrepareOptions options{
        .threads = 1, .max_bytes = std::min(most_bytes_.load(), worth), .stop = stop};
    Preparation report;
    if (exact::CornerGraph::expected_bytes(grid, options) <= options.max_bytes)
      graph_ = exact::CornerGraph::make(grid, options, report);
    if (graph_ == nullptr) {
      making_ = false;
      return;
    }
    made_bytes_ = report.bytes;
    on_.store(true, std::memory_order_release);
  }

  std::atomic<std::int64_t> most_bytes_ = kMostBytes, made_bytes_ = 0;
  std::atomic<std::int64_t> done_ = 0, work_ = 0, expected_ = 0, asked_ = 0, told_ = 0;
  std::atomic<bool> making_ = false;  // or made
  std::shared_ptr<const exact::CornerGraph> graph_;
  std::atomic<bool> on_ = false;
};

}  // namespace lasius
