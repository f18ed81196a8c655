#include "lasius/planner.h"

#include "core/base/poller.h"
#include "core/grid/grid_view.h"
#include "core/grid/nearest_free.h"
#include "core/plan/answer.h"
#include "core/plan/planner_impl.h"
#include "core/plan/workspace.h"

namespace lasius {

Workspace::Workspace() : memory_(std::make_unique<WorkspaceMemory>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
std::int64_t Workspace::bytes() const noexcept { return memory_->bytes(); }
void Workspace::release() { memory_ = std::make_unique<WorkspaceMemory>(); }

Planner::Planner(Grid grid) : impl_(Impl::make(std::move(grid), {})) {}
Planner::Planner(Grid grid, const PrepareOptions& options)
    : impl_(Impl::make(std::move(grid), {}, options)) {}
std::optional<Planner> Planner::make(Grid&& grid, const StopCondition& stop) {
  return if_made(Impl::make(std::move(grid), stop));
}
std::optional<Planner> Planner::make_prepared(Grid&& grid, const PrepareOptions& options) {
  return if_made(Impl::make(std::move(grid), options.stop, options));
}
Planner Planner::prepared(const PrepareOptions& options) const {
  check_threads(options.threads);
  auto more = std::make_shared<Impl>(impl_->grid, impl_->four, impl_->excluded, impl_->closed);
  more->prepare_more(options);
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

const Grid& Planner::grid() const noexcept { return impl_->grid; }

bool Planner::label(Corners corners, const StopCondition& stop) const {
  return impl_->components(corners, stop) != nullptr;
}

bool Planner::connected(Cell a, Cell b, Corners corners) const {
  return *impl_->connected(a, b, corners, {});
}

std::optional<Cell> Planner::nearest_free(Cell c) const {
  const StopCondition never;
  Poller poller(never);
  return lasius::nearest_free(impl_->grid, c, poller);
}

std::optional<Cell> Planner::nearest_reachable(Cell c, Cell from, Corners corners) const {
  const StopCondition never;
  Poller poller(never);
  const auto joined = [&](Cell at) { return connected(from, at, corners); };
  return lasius::nearest_free(impl_->grid, c, poller, joined);
}

Result Planner::plan(const Request& request, const Params& params, Workspace* workspace,
                     const Observer& observer) const {
  return plan(request, params, {}, workspace, observer);
}

Result Planner::plan(const Request& request, const Params& params, const OwnRules& own,
                     Workspace* workspace, const Observer& observer) const {
  const auto connected = [&](Cell a, Cell b, Corners corners) {
    return impl_->connected(a, b, corners, request.stop);
  };
  return answer({impl_->grid, impl_->graph.get(), connected}, request, params, workspace, observer,
                own);
}

const Preparation& Planner::preparation() const noexcept { return impl_->preparation; }

std::int64_t Planner::components(Corners corners) const {
  return impl_->components(corners, {})->count();
}

Planner::Footprint Planner::footprint() const noexcept {
  return {.bitmap = bitmap_bytes(impl_->grid),
          .components = impl_->component_bytes(),
          .visibility_graph = impl_->preparation.bytes};
}

}  // namespace lasius
