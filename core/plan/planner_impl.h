// What a Planner holds.
#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/disc/disc_space.h"
#include "core/exact/corner_graph.h"
#include "core/exact/labels/corner_labels.h"
#include "core/grid/components.h"
#include "core/grid/grid_view.h"
#include "core/params/parameter_table.h"
#include "core/plan/answer.h"
#include "lasius/plan/planner.h"

namespace lasius {

class Planner::Impl {
 public:
  Impl(Grid g, Components c, std::vector<Direction> e = {}, std::vector<Cell> shut = {},
       std::shared_ptr<const DiscMap> d = {})
      : grid(std::move(g)),
        four(std::move(c)),
        excluded(std::move(e)),
        closed(std::move(shut)),
        disc(std::move(d)) {}

  /// Null, and the map as it was, when stopped.
  static std::shared_ptr<Impl> make(Grid&& map, Disc robot, const StopCondition& stop,
                                    std::vector<Direction> excluded = {},
                                    std::vector<Cell> closed = {});
  static std::shared_ptr<Impl> make(Grid&& map, Disc robot, const PrepareOptions& options,
                                    const StopCondition& stop) {
    check_threads(options.threads);
    auto impl = make(std::move(map), robot, stop);
    if (impl != nullptr) impl->prepare_more(options);
    return impl;
  }

  /// `before`: of an older map, whose order of labels is kept; null: none.
  void prepare_more(const PrepareOptions& options, const StaleAnswers* before = nullptr) {
    const auto begin = Clock::now();
    if (disc == nullptr) {
      graph = exact::CornerGraph::make(grid, options, preparation);
      if (options.labels && graph != nullptr)
        labels = exact::CornerLabels::make(grid, *graph, options, preparation.labels,
                                           order_kept(before));
    } else if (disc->space) {
      disc_graph = disc::DiscGraph::make(*disc->space, options, preparation);
    }
    preparation.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }

  std::vector<std::uint32_t> order_kept(const StaleAnswers* before) const {
    if (before == nullptr || before->older().labels == nullptr) return {};
    return before->older().labels->order_of(*before->older().graph, *graph);
  }

  /// The map as it was given, with what is excluded.
  const Grid& map() const noexcept { return disc != nullptr ? disc->map() : grid; }
  const disc::DiscSpace* space() const noexcept { return space_of(disc.get()); }
  Disc robot() const noexcept { return {disc != nullptr ? disc->radius : 0}; }

  /// The next version: the map with some edits, and these directions excluded. Null when stopped.
  std::shared_ptr<const Impl> next(std::span<const Edit> edits, std::vector<Direction> directions,
                                   const StopCondition& stop) const;

  /// The same of a disc; `changed` are the cells that differ.
  std::shared_ptr<const Impl> next_of_disc(Grid&& now, std::span<const Cell> changed,
                                           std::vector<Direction>&& directions,
                                           std::vector<Cell>&& shut,
                                           const StopCondition& stop) const;

  /// As answer() looks at it; this object outlives it, and so does the stop condition.
  PlanningMap planning_map(const StopCondition& stop) const {
    return {.grid = grid,
            .graph = graph.get(),
            .labels = labels.get(),
            .connected = [this, &stop](Cell a, Cell b,
                                       Corners corners) { return connected(a, b, corners, stop); },
            .disc = disc.get(),
            .disc_graph = disc_graph.get(),
            .stale = stale.get(),
            .from_file = from_file,
            .own = disc == nullptr ? &own : nullptr};
  }

  /// The rule of corners, of a disc its own.
  Corners rule(Corners asked) const noexcept { return corners_of(asked, robot()); }

  /// The components under a rule; null if stopped. Those of 8 neighbours are made when first
  /// asked for. Two threads may both make them, and find the same: none has to wait for another,
  /// whose stop condition is not its own.
  const Components* components(Corners corners, const StopCondition& stop) const {
    if (rule(corners) != Corners::allow) return &four;
    if (const Components* ready = eight_.load(std::memory_order_acquire)) return ready;
    auto made = Components::make(grid, Components::Connectivity::eight, stop);
    if (!made) return nullptr;
    std::call_once(eight_kept_, [&] {
      made_eight_ = std::move(made);
      eight_.store(&*made_eight_, std::memory_order_release);
    });
    return &*made_eight_;
  }

  /// Are the cells joined under a rule? Nothing if stopped. The pieces of 8 neighbours are made
  /// only for cells that 4 neighbours do not join.
  std::optional<bool> connected(Cell a, Cell b, Corners corners, const StopCondition& stop) const {
    if (four.connected(grid, a, b)) return true;
    if (rule(corners) != Corners::allow) return false;
    const Components* const eight = components(corners, stop);
    if (eight == nullptr) return std::nullopt;
    return eight->connected(grid, a, b);
  }

  /// Which cells some points of a disc's free space lie in, and how they are joined. Kept from
  /// question to question: the first radii that a bisection tries are always the same.
  struct Regions {
    Grid blocked;
    Components four;
  };
  static constexpr std::size_t kMostRegions = 32;  ///< that are kept
  /// By the square of the radius in half cells. Nothing if stopped.
  std::shared_ptr<const Regions> regions(int squared_half_cells, const StopCondition& stop) const;
  /// Likewise; the last one is kept: many questions of a map end at the same narrow place.
  std::shared_ptr<const disc::DiscSpace> space_with(int squared_half_cells,
                                                    const StopCondition& stop) const;

  /// Memory that components hold.
  std::int64_t component_bytes() const noexcept {
    const Components* const eight = eight_.load(std::memory_order_acquire);
    return four.bytes() + (eight != nullptr ? eight->bytes() : 0);
  }

  /// Memory that regions() and space_with() keep.
  std::int64_t region_bytes() const noexcept {
    const std::scoped_lock lock(regions_kept_);
    std::int64_t bytes = last_space_ != nullptr ? last_space_->bytes() : 0;
    for (const auto& [radius, kept] : regions_)
      bytes += bitmap_bytes(kept->blocked) + kept->four.bytes();
    return bytes;
  }

  const Grid grid;  ///< grown, for a disc
  const Components four;
  const std::vector<Direction> excluded;
  const std::vector<Cell> closed;                     ///< blocked in `map()` by `excluded` alone
  std::shared_ptr<const exact::CornerGraph> graph;    ///< of `grid`; null if not prepared
  bool from_file = false;                             ///< it is: not proven here
  std::shared_ptr<const exact::CornerLabels> labels;  ///< of `graph`; null if there are none
  std::shared_ptr<const StaleAnswers> stale;          ///< of an edited map; null: none
  const std::shared_ptr<const DiscMap> disc;          ///< null for a point
  std::shared_ptr<const disc::DiscGraph> disc_graph;  ///< of `disc`; null if not prepared
  Preparation preparation;
  mutable OwnGraph own;  ///< of `grid`

 private:
  mutable std::mutex regions_kept_;
  mutable std::map<int, std::shared_ptr<const Regions>> regions_;
  mutable std::shared_ptr<const disc::DiscSpace> last_space_;
  mutable int last_radius_ = 0;  ///< of it; the square, in half cells
  mutable std::once_flag eight_kept_;
  mutable std::optional<Components> made_eight_;
  mutable std::atomic<const Components*> eight_ = nullptr;  ///< null until they are kept
};

/// What is internal of a Planner.
struct PlannerParts {
  static const Planner::Impl& of(const Planner& planner) noexcept { return *planner.impl_; }
};

}  // namespace lasius
