#include "lasius/plan/planner.h"

#include <algorithm>
#include <utility>

#include "core/base/poller.h"
#include "core/disc/disc_cells.h"
#include "core/grid/grid_view.h"
#include "core/grid/nearest_free.h"
#include "core/plan/plan_ends.h"
#include "core/plan/planner_impl.h"
#include "core/plan/workspace.h"

namespace lasius {
namespace {

std::int64_t disc_bytes(const DiscMap& disc) noexcept {
  return disc.space ? disc.space->bytes() : bitmap_bytes(*disc.alone);
}

}  // namespace

Workspace::Workspace() : memory_(std::make_unique<WorkspaceMemory>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
std::int64_t Workspace::bytes() const noexcept { return memory_->bytes(); }
void Workspace::release() { memory_ = std::make_unique<WorkspaceMemory>(); }

std::shared_ptr<Planner::Impl> Planner::Impl::make(Grid&& map, Disc robot,
                                                   const StopCondition& stop,
                                                   std::vector<Direction> excluded,
                                                   std::vector<Cell> closed) {
  std::optional<Grid> grown;
  std::shared_ptr<DiscMap> disc;
  if (robot.radius != 0) {
    grown = grow_obstacles(map, disc::growth(map, robot.radius), stop);
    if (!grown) return nullptr;
  }
  auto four = Components::make(grown ? *grown : map, Components::Connectivity::four, stop);
  if (!four) return nullptr;
  if (grown) {
    Grid whole = std::exchange(map, *std::move(grown));
    disc = std::make_shared<DiscMap>(DiscMap{robot.radius});
    if (disc::has_space(robot.radius)) {
      disc->space = disc::DiscSpace::make(std::move(whole), robot.radius, stop);
      if (!disc->space) return nullptr;
    } else {
      disc->alone = std::move(whole);
    }
  }
  return std::make_shared<Impl>(std::move(map), std::move(*four), std::move(excluded),
                                std::move(closed), std::move(disc));
}

Planner::Planner(Grid grid, Disc robot) : impl_(Impl::make(std::move(grid), robot, {})) {}
Planner::Planner(Grid grid, const PrepareOptions& options, Disc robot)
    : impl_(Impl::make(std::move(grid), robot, options, {})) {}
std::optional<Planner> Planner::make(Grid&& grid, Disc robot, const StopCondition& stop) {
  return if_made(Impl::make(std::move(grid), robot, stop));
}
std::optional<Planner> Planner::make_prepared(Grid&& grid, const PrepareOptions& options,
                                              Disc robot) {
  return if_made(Impl::make(std::move(grid), robot, options, options.stop));
}
Planner Planner::prepared(const PrepareOptions& options) const {
  check_threads(options.threads);
  auto more =
      std::make_shared<Impl>(impl_->grid, impl_->four, impl_->excluded, impl_->closed, impl_->disc);
  more->prepare_more(options, impl_->stale.get());
  return Planner(std::move(more));
}
std::optional<Planner> Planner::if_made(std::shared_ptr<const Impl> impl) {
  return impl == nullptr ? std::nullopt : std::optional(Planner(std::move(impl)));
}
Planner::Planner(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Planner::~Planner() = default;
Planner::Planner(const Planner&) noexcept = default;
Planner& Planner::operator=(const Planner&) noexcept = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

const Grid& Planner::grid() const noexcept { return impl_->map(); }
Disc Planner::robot() const noexcept { return impl_->robot(); }
const Grid& Planner::passable() const noexcept { return impl_->grid; }
bool Planner::clear(Cell c) const noexcept {
  if (impl_->disc == nullptr || !impl_->disc->space) return impl_->grid.free(c);
  return impl_->disc->space->clear(centre(c));
}

bool Planner::clear_at(Point p) const {
  const StopCondition never;
  const PlanningMap map = impl_->planning_map(never);
  return Ends(map, impl_->space(), Corners::forbid).serves({impl_->map(), {}, p});
}

bool Planner::joined_at(Point a, Point b) const {
  if (!clear_at(a) || !clear_at(b)) return false;
  const StopCondition never;
  const PlanningMap map = impl_->planning_map(never);
  return *Ends(map, impl_->space(), Corners::forbid).joined(a, b);
}

bool Planner::label(Corners corners, const StopCondition& stop) const {
  return impl_->components(corners, stop) != nullptr;
}

bool Planner::connected(Cell a, Cell b, Corners corners) const {
  return *impl_->connected(a, b, corners, {});
}

std::optional<Cell> Planner::nearest_free(Cell c) const {
  const StopCondition never;
  Poller poller(never);
  return lasius::nearest_free(impl_->grid, Spot{c}, poller);
}

std::optional<Cell> Planner::nearest_reachable(Cell c, Cell from, Corners corners) const {
  const StopCondition never;
  Poller poller(never);
  const auto joined = [&](Cell at) { return connected(from, at, corners); };
  return lasius::nearest_free(impl_->grid, Spot{c}, poller, joined);
}

Result Planner::plan(const Request& request, const Params& params,
                     const PlanOptions& options) const {
  return answer(impl_->planning_map(request.stop), request, params, options);
}

void Planner::limit_own_graph(std::int64_t max_bytes) noexcept {
  impl_->own.limit(std::max<std::int64_t>(max_bytes, 0));
}

const Preparation& Planner::preparation() const noexcept { return impl_->preparation; }

std::int64_t Planner::components(Corners corners) const {
  return impl_->components(corners, {})->count();
}

Planner::Footprint Planner::footprint() const noexcept {
  return {.bitmap = bitmap_bytes(impl_->grid),
          .components = impl_->component_bytes(),
          .visibility_graph =
              impl_->preparation.bytes + impl_->preparation.labels.bytes + impl_->own.bytes(),
          .disc = (impl_->disc != nullptr ? disc_bytes(*impl_->disc) : 0) + impl_->region_bytes()};
}

}  // namespace lasius
