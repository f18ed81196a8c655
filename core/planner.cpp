#include "lasius/planner.h"

#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "colony.h"
#include "lasius/components.h"
#include "lasius/error.h"
#include "lasius/path.h"
#include "workspace.h"

namespace lasius {

std::string_view to_string(Status status) noexcept {
  switch (status) {
    case Status::solved:
      return "solved";
    case Status::limit:
      return "limit";
    case Status::interrupted:
      return "interrupted";
    case Status::unreachable:
      return "unreachable";
    case Status::no_path:
      return "no_path";
    case Status::invalid:
      return "invalid";
  }
  return "";
}

Result::Result() : length(std::numeric_limits<double>::quiet_NaN()) {}

std::optional<double> Result::gap() const {
  if (!lower_bound || path.empty()) return std::nullopt;
  return length == 0 ? 0.0 : (length - *lower_bound) / *lower_bound;
}

Progress::~Progress() = default;

Workspace::Workspace() : impl_(std::make_unique<Impl>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

class Planner::Impl {
 public:
  explicit Impl(Grid g) : grid(std::move(g)), four(grid, Components::Connectivity::four) {}
  Impl(Grid g, Components c) : grid(std::move(g)), four(std::move(c)) {}

  /// Made when first asked for: only Corners::allow needs it.
  const Components& eight() const {
    std::call_once(eight_made_, [this] { eight_.emplace(grid, Components::Connectivity::eight); });
    return *eight_;
  }

  const Grid grid;
  const Components four;

 private:
  mutable std::once_flag eight_made_;
  mutable std::optional<Components> eight_;
};

Planner::Planner(Grid grid) : impl_(std::make_shared<const Impl>(std::move(grid))) {}
Planner::Planner(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

const Grid& Planner::grid() const noexcept { return impl_->grid; }

bool Planner::connected(Cell a, Cell b, Corners corners) const {
  const auto& components = corners == Corners::allow ? impl_->eight() : impl_->four;
  return components.connected(impl_->grid, a, b);
}

namespace {

/// Distance along row y from column x to the nearest free cell, at most `limit`; -1 if none.
/// Ties go to the left.
int nearest_free_in_row(const Grid& grid, int x, int y, int limit) {
  for (int d = 0; d <= limit; ++d) {
    if (grid.free({x - d, y})) return -d;
    if (grid.free({x + d, y})) return d;
  }
  return limit + 1;
}

std::string name(Cell c) {
  std::string text = "(";
  text += std::to_string(c.x) + ", " + std::to_string(c.y);
  return text += ')';
}

}  // namespace

std::optional<Cell> Planner::nearest_free(Cell c) const {
  const Grid& grid = impl_->grid;
  std::optional<Cell> best;
  std::int64_t best_squared = std::numeric_limits<std::int64_t>::max();
  const int reach = grid.width() + grid.height();
  const Cell from{std::clamp(c.x, -reach, 2 * reach), std::clamp(c.y, -reach, 2 * reach)};
  for (int dy = 0; static_cast<std::int64_t>(dy) * dy < best_squared && dy <= 3 * reach; ++dy) {
    for (const int y : {from.y - dy, from.y + dy}) {
      if (y < 0 || y >= grid.height()) continue;
      const double room = std::sqrt(static_cast<double>(best_squared));
      const int limit = static_cast<int>(std::min<double>(3.0 * reach, room));
      const int dx = nearest_free_in_row(grid, from.x, y, limit);
      const std::int64_t squared =
          static_cast<std::int64_t>(dx) * dx + static_cast<std::int64_t>(dy) * dy;
      if (dx <= limit && squared < best_squared) {
        best_squared = squared;
        best = Cell{from.x + dx, y};
      }
    }
  }
  return best;
}

Result Planner::plan(const Request& request, const Params& params, Workspace* workspace,
                     const Observer& observer) const {
  validate(params);
  const Grid& grid = impl_->grid;
  Result result;
  for (const auto& [what, cell] : {std::pair{"start", request.start}, {"goal", request.goal}}) {
    if (grid.free(cell)) continue;
    result.status = Status::invalid;
    result.error = std::string(what) + " " + name(cell) +
                   (grid.contains(cell) ? " is blocked" : " is outside the map");
    if (const auto near = nearest_free(cell)) {
      result.error += "; the nearest free cell is " + name(*near);
    } else {
      result.error += "; the map has no free cell";
    }
    return result;
  }
  if (request.start == request.goal) {
    result.status = Status::solved;
    result.path = {centre(request.start)};
    result.length = 0;
    result.lower_bound = 0;
    result.optimal = true;
    return result;
  }
  // With 4 neighbours no corner is ever passed, whatever the rule.
  const Corners corners = params.neighbours == 4 ? Corners::forbid : params.corners;
  if (!connected(request.start, request.goal, corners)) {
    result.status = Status::unreachable;
    result.error = "start " + name(request.start) + " and goal " + name(request.goal) +
                   " lie in different regions of free cells";
    return result;
  }

  std::optional<Workspace> own;
  if (workspace == nullptr) workspace = &own.emplace();
  result = run_colony(grid, request, params, workspace->impl(), observer);
  if (const auto fault = path_fault(grid, result.path, corners); fault && !result.path.empty()) {
    throw std::logic_error("a planned path is not valid: " + *fault);
  }
  return result;
}

Planner Planner::edited(std::span<const Edit> edits) const {
  Grid grid = impl_->grid;
  std::vector<Cell> changed;
  for (const Edit& edit : edits) {
    if (!grid.contains(edit.cell)) {
      throw Error(ErrorCode::invalid_parameter, "edited cell " + name(edit.cell) + " is outside",
                  "the map is " + std::to_string(grid.width()) + " x " +
                      std::to_string(grid.height()) + " cells");
    }
    if (grid.blocked(edit.cell) == edit.blocked) continue;
    grid.set_blocked(edit.cell, edit.blocked);
    changed.push_back(edit.cell);
  }
  Components components = impl_->four.updated(grid, changed);
  return Planner(std::make_shared<const Impl>(std::move(grid), std::move(components)));
}

Planner::Footprint Planner::footprint() const noexcept {
  const Grid& grid = impl_->grid;
  Footprint f;
  f.bitmap = static_cast<std::int64_t>(grid.stride()) * (grid.height() + 2) * 8;
  f.components = impl_->four.bytes();
  return f;
}

}  // namespace lasius
