#include "lasius/planner.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "colony.h"
#include "corner_graph.h"
#include "grid_ga.h"
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

std::string_view to_string(Preparation::State state) noexcept {
  switch (state) {
    case Preparation::State::none:
      return "none";
    case Preparation::State::ready:
      return "ready";
    case Preparation::State::too_large:
      return "too_large";
    case Preparation::State::stopped:
      return "stopped";
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
  Impl(Grid g, const PrepareOptions& options) : Impl(std::move(g)) {
    const auto begin = Clock::now();
    graph = exact::CornerGraph::make(grid, options, preparation);
    preparation.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }
  Impl(Grid g, Components c, std::vector<Direction> e, std::vector<Cell> shut)
      : grid(std::move(g)), four(std::move(c)), excluded(std::move(e)), closed(std::move(shut)) {}

  /// The next version: the map with some edits, and these directions excluded.
  std::shared_ptr<const Impl> next(std::span<const Edit> edits,
                                   std::vector<Direction> directions) const;

  /// Made when first asked for: only Corners::allow needs it.
  const Components& eight() const {
    std::call_once(eight_made_, [this] { eight_.emplace(grid, Components::Connectivity::eight); });
    return *eight_;
  }

  const Grid grid;
  const Components four;
  const std::vector<Direction> excluded;
  const std::vector<Cell> closed;  ///< blocked in `grid` by `excluded`, not by the map
  std::shared_ptr<const exact::CornerGraph> graph;  ///< of `grid`; null if not prepared
  Preparation preparation;

 private:
  mutable std::once_flag eight_made_;
  mutable std::optional<Components> eight_;
};

Planner::Planner(Grid grid) : impl_(std::make_shared<const Impl>(std::move(grid))) {}
Planner::Planner(Grid grid, const PrepareOptions& options)
    : impl_(std::make_shared<const Impl>(std::move(grid), options)) {}
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

/// The column of the free cell of row y nearest to x, the left one of two, or nothing. x may lie
/// outside.
std::optional<int> nearest_free_in_row(const Grid& grid, int x, int y) {
  const std::uint64_t* row = grid.row(y);
  const int inside = std::clamp(x, 0, grid.width() - 1);
  std::optional<int> left, right;
  std::uint64_t upto = ~std::uint64_t{0} >> (63 - (inside & 63));
  for (int w = inside >> 6; w >= 0 && !left; --w, upto = ~std::uint64_t{0}) {
    if (const std::uint64_t free = ~row[w] & upto) left = w * 64 + 63 - std::countl_zero(free);
  }
  std::uint64_t from = ~std::uint64_t{0} << (inside & 63);
  for (int w = inside >> 6; w < grid.words() && !right; ++w, from = ~std::uint64_t{0}) {
    if (const std::uint64_t free = ~row[w] & from) right = w * 64 + std::countr_zero(free);
  }
  if (!left || !right) return left ? left : right;
  return std::abs(*right - x) < std::abs(x - *left) ? right : left;
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
  std::uint64_t best_squared = std::numeric_limits<std::uint64_t>::max();
  // Rows outwards from the cell's own, the upper one first.
  const std::int64_t above = c.y, below = static_cast<std::int64_t>(grid.height()) - 1 - c.y;
  const std::int64_t last = std::max(above, below);
  for (std::int64_t d = std::max<std::int64_t>({0, -above, -below}); d <= last; ++d) {
    const auto dy = static_cast<std::uint64_t>(d);  // below 2^32: squares add up in 64 bits
    if (dy * dy > best_squared) break;
    for (const std::int64_t y : {c.y - d, c.y + d}) {
      if (y < 0 || y >= grid.height()) continue;
      const auto x = nearest_free_in_row(grid, c.x, static_cast<int>(y));
      if (!x) continue;
      const auto dx = static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(*x) - c.x));
      const std::uint64_t squared = dx * dx + dy * dy;
      if (squared > best_squared || (squared == best_squared && y > best->y)) continue;
      best_squared = squared;
      best = Cell{*x, static_cast<int>(y)};
    }
  }
  return best;
}

namespace {

Result run_exact(const Grid& grid, const exact::CornerGraph* graph, const Request& request,
                 Workspace::Impl& workspace) {
  ExactAnswer& answer = workspace.exact_answer;
  const ExactOptions options{.target_gap = request.target_gap};
  if (graph != nullptr) {
    workspace.prepared.search(grid, *graph, request.start, request.goal, options, request.stop,
                              answer);
  } else {
    workspace.exact.search(grid, request.start, request.goal, options, request.stop, answer);
  }
  Result result;
  switch (answer.end) {
    case ExactEnd::proven:
    case ExactEnd::target_gap:
      result.status = Status::solved;
      break;
    case ExactEnd::unreachable:
      result.status = Status::unreachable;
      return result;
    case ExactEnd::stopped:
      result.status =
          answer.cause == StopCondition::Cause::token ? Status::interrupted : Status::limit;
      break;
  }
  result.path = answer.path;
  if (!result.path.empty()) result.length = answer.length;
  result.lower_bound = answer.lower_bound;
  result.optimal = answer.optimal;
  return result;
}

}  // namespace

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
  // Any-angle paths never squeeze, and with 4 neighbours no corner is ever passed.
  const bool squeezes = params.algorithm != "exact" && params.neighbours != Neighbours::four;
  const Corners corners = squeezes ? params.corners : Corners::forbid;
  if (!connected(request.start, request.goal, corners)) {
    result.status = Status::unreachable;
    result.error = "start " + name(request.start) + " and goal " + name(request.goal) +
                   " lie in different regions of free cells";
    return result;
  }

  std::optional<Workspace> own;
  if (workspace == nullptr) workspace = &own.emplace();
  if (params.algorithm == "exact") {
    result = run_exact(grid, impl_->graph.get(), request, workspace->impl());
  } else if (params.algorithm == "grid-ga") {
    const auto joined = [&](Cell c) { return connected(request.start, c, corners); };
    result = run_grid_ga(grid, request, params, joined, observer);
  } else {
    result = run_colony(grid, request, params, workspace->impl(), observer);
  }
  if (const auto fault = path_fault(grid, result.path, corners); fault && !result.path.empty()) {
    throw std::logic_error("a planned path is not valid: " + *fault);
  }
  return result;
}

std::shared_ptr<const Planner::Impl> Planner::Impl::next(std::span<const Edit> edits,
                                                         std::vector<Direction> directions) const {
  Grid now = grid;
  for (const Cell c : closed) now.set_blocked(c, false);  // the map as it is
  for (const Edit& edit : edits) {
    if (!now.contains(edit.cell)) {
      throw Error(ErrorCode::invalid_parameter, "edited cell " + name(edit.cell) + " is outside",
                  "the map is " + std::to_string(now.width()) + " x " +
                      std::to_string(now.height()) + " cells");
    }
    now.set_blocked(edit.cell, edit.blocked);
  }
  std::vector<Cell> shut;
  for (const Direction& d : directions) {
    const Cell c{d.from.x + d.dx, d.from.y + d.dy};
    if (now.blocked(c)) continue;  // by the map, by another direction, or outside
    now.set_blocked(c, true);
    shut.push_back(c);
  }
  std::vector<Cell> changed;
  const auto note = [&](Cell c) {
    if (now.blocked(c) != grid.blocked(c)) changed.push_back(c);
  };
  for (const Edit& edit : edits) note(edit.cell);
  for (const Cell c : closed) note(c);
  for (const Cell c : shut) note(c);
  Components components = four.updated(now, changed);
  return std::make_shared<const Impl>(std::move(now), std::move(components), std::move(directions),
                                      std::move(shut));
}

Planner Planner::edited(std::span<const Edit> edits) const {
  return Planner(impl_->next(edits, impl_->excluded));
}

Planner Planner::exclude(std::span<const Direction> reported) const {
  std::vector<Direction> directions = impl_->excluded;
  for (const Direction& d : reported) {
    if (!impl_->grid.contains(d.from)) {
      throw Error(ErrorCode::invalid_parameter,
                  "excluded direction starts outside the map, at " + name(d.from),
                  "give a cell of the map");
    }
    if (std::max(std::abs(d.dx), std::abs(d.dy)) != 1) {
      throw Error(ErrorCode::invalid_parameter,
                  "(" + std::to_string(d.dx) + ", " + std::to_string(d.dy) + ") is no direction",
                  "give one of the eight steps to a neighbour");
    }
    if (std::find(directions.begin(), directions.end(), d) == directions.end()) {
      directions.push_back(d);
    }
  }
  return Planner(impl_->next({}, std::move(directions)));
}

Planner Planner::allow(std::span<const Direction> gone) const {
  std::vector<Direction> directions;
  for (const Direction& d : impl_->excluded) {
    if (std::find(gone.begin(), gone.end(), d) == gone.end()) directions.push_back(d);
  }
  return Planner(impl_->next({}, std::move(directions)));
}

std::span<const Planner::Direction> Planner::excluded() const noexcept { return impl_->excluded; }

const Preparation& Planner::preparation() const noexcept { return impl_->preparation; }

Planner::Footprint Planner::footprint() const noexcept {
  const Grid& grid = impl_->grid;
  Footprint f;
  f.bitmap = static_cast<std::int64_t>(grid.stride()) * (grid.height() + 2) * 8;
  f.components = impl_->four.bytes();
  f.corners = impl_->preparation.bytes;
  return f;
}

}  // namespace lasius
