#include "lasius/planner.h"

#include <limits>
#include <stdexcept>

#include "core/base/poller.h"
#include "core/colony/colony.h"
#include "core/exact/anytime.h"
#include "core/genetic/grid_ga.h"
#include "core/grid/nearest_free.h"
#include "core/loop/run_status.h"
#include "core/params/parameter_table.h"
#include "core/plan/planner_impl.h"
#include "core/plan/workspace.h"
#include "lasius/path.h"

namespace lasius {

Workspace::Workspace() : impl_(std::make_unique<Impl>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
std::int64_t Workspace::bytes() const noexcept { return impl_->bytes(); }
void Workspace::release() { impl_ = std::make_unique<Impl>(); }

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

namespace {

/// What an observer sees of `exact`: one more path, shorter than those before.
class ExactView final : public GridProgress {
 public:
  ExactView(const std::vector<Point>& path, int number, double length, double bound) : path_(path) {
    iteration = number;
    best_length = length;
    lower_bound = bound;
  }
  std::vector<Point> path() const override { return path_; }

 private:
  const std::vector<Point>& path_;
};

Result run_exact(const Grid& grid, const exact::CornerGraph* graph, const Request& request,
                 Workspace::Impl& memory, const Observer& observer) {
  ExactAnswer& answer = memory.exact_answer;
  int improvements = 0;
  const OnImproved show = [&](const std::vector<Point>& path, double length, double bound) {
    const ExactView view(path, improvements++, length, bound);
    observer(view);
    return !view.stopped();
  };
  exact::Anytime anytime(memory.hurried, grid, request.start, request.goal,
                         {.target_gap = request.target_gap, .improved = observer ? &show : nullptr},
                         request.stop);
  if (graph != nullptr) {
    memory.prepared.search(grid, *graph, request.start, request.goal, anytime.options(),
                           request.stop, answer);
  } else {
    memory.exact.search(grid, request.start, request.goal, anytime.options(), request.stop, answer);
  }
  anytime.merge(answer);
  Result result;
  switch (answer.end) {
    case ExactEnd::proven:
    case ExactEnd::target_gap:
      result.status = Status::solved;
      break;
    case ExactEnd::unreachable:
      return failed<Result>(Status::unreachable, Fault::disconnected, {});
    case ExactEnd::stopped:
      result.status = status_after(answer.cause, Status::limit);
      break;
  }
  result.path = answer.path;
  if (!result.path.empty()) result.length = answer.length;
  result.lower_bound = answer.lower_bound;
  result.optimal = answer.optimal;
  return result;
}

/// The answer to a start or goal that is blocked or outside.
Result invalid(const Grid& grid, bool at_start, Cell cell, const std::stop_token& token) {
  const bool inside = grid.contains(cell);
  const Fault fault = at_start ? (inside ? Fault::start_blocked : Fault::start_outside)
                               : (inside ? Fault::goal_blocked : Fault::goal_outside);
  auto result = failed<Result>(Status::invalid, fault,
                               (at_start ? "start " : "goal ") + cell_name(cell) +
                                   (inside ? " is blocked" : " is outside the map"));
  // It is named whatever the deadline.
  const StopCondition no_deadline{.token = token};
  Poller poller(no_deadline);
  result.nearest_free = nearest_free(grid, cell, poller);
  if (result.nearest_free) {
    result.error += "; the nearest free cell is " + cell_name(*result.nearest_free);
  } else if (!poller.stopped()) {
    result.error += "; the map has no free cell";
  }
  return result;
}

}  // namespace

Result Planner::plan(const Request& request, const Params& params, Workspace* workspace,
                     const Observer& observer) const {
  validate(params);
  const Algorithm& algorithm = find_algorithm(params.algorithm());
  check_certifies(algorithm, request.target_gap);
  const Grid& grid = impl_->grid;
  if (grid.blocked(request.start)) return invalid(grid, true, request.start, request.stop.token);
  if (grid.blocked(request.goal)) return invalid(grid, false, request.goal, request.stop.token);
  if (request.start == request.goal) {
    auto result = already_there<Result>();
    result.path = {centre(request.start)};
    return result;
  }
  // Any-angle paths never squeeze, and with 4 neighbours no corner is ever passed.
  const bool exact = algorithm.kind == Algorithm::Kind::exact;
  const bool squeezes = !exact && params.neighbours != Neighbours::four;
  const Corners corners = squeezes ? params.corners : Corners::forbid;
  const auto connected = impl_->connected(request.start, request.goal, corners, request.stop);
  Result result;
  if (!connected) {
    result.status = status_after(request.stop.poll(), Status::limit);
    return result;
  }
  if (!*connected) {
    return failed<Result>(Status::unreachable, Fault::disconnected,
                          "start " + cell_name(request.start) + " and goal " +
                              cell_name(request.goal) + " lie in different regions of free cells");
  }

  std::optional<Workspace> own;
  if (workspace == nullptr) workspace = &own.emplace();
  Workspace::Impl& memory = workspace->impl();
  switch (algorithm.kind) {
    case Algorithm::Kind::exact:
      result = run_exact(grid, impl_->graph.get(), request, memory, observer);
      break;
    case Algorithm::Kind::genetic: {
      const auto joined = [&](Cell c) {
        return impl_->connected(request.start, c, corners, request.stop).value_or(false);
      };
      result = run_grid_ga(grid, request, params, joined, memory.genetic, observer);
      break;
    }
    case Algorithm::Kind::colony:
      result = run_colony(grid, request, params, memory.colony, observer);
      break;
  }
  if (result.path.empty()) return result;
  // Not to be cut short: a glance at the words along the path.
  if (const auto fault = path_fault(grid, result.path, corners)) {
    throw std::logic_error("a planned path is not valid: " + *fault);
  }
  return result;
}

const Preparation& Planner::preparation() const noexcept { return impl_->preparation; }

std::int64_t Planner::components(Corners corners) const {
  return impl_->components(corners, {})->count();
}

Planner::Footprint Planner::footprint() const noexcept {
  const Grid& grid = impl_->grid;
  Footprint f;
  f.bitmap = static_cast<std::int64_t>(grid.stride()) * (grid.height() + 2) * 8;
  f.components = impl_->component_bytes();
  f.visibility_graph = impl_->preparation.bytes;
  return f;
}

}  // namespace lasius
