#include "lasius/navigator.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "core/base/held_bytes.h"
#include "core/base/invalid_parameter.h"
#include "core/colony/colony.h"
#include "core/drive/edited_map.h"
#include "core/drive/path_walker.h"
#include "core/grid/cell_distance.h"
#include "core/grid/components.h"
#include "core/params/parameter_table.h"
#include "core/plan/answer.h"
#include "core/plan/workspace.h"

namespace lasius {
namespace {

using Connectivity = Components::Connectivity;

/// @throws Error(invalid_parameter) unless the algorithm is of the kind that an option is for.
void check_kind(const Algorithm& algorithm, Algorithm::Kind kind, const char* option,
                const char* whose) {
  if (algorithm.kind == kind) return;
  throw invalid_parameter(
      std::string(option) + " is set, which " + std::string(algorithm.name) + " ignores",
      std::string("leave it out, or take ") + whose);
}

/// The components of a map that is edited, brought up to date when they are asked for.
class LiveComponents {
 public:
  LiveComponents(const Grid& grid, Connectivity connectivity) : components_(grid, connectivity) {}

  /// `grid` has the change already.
  void changed(const Grid& grid, const Rectangle& part) {
    changed_.push_back(part);
    constexpr std::size_t kMost = 256;  // where nobody asks
    if (changed_.size() == kMost) (void)update(grid, {});
  }
  /// Nothing if stopped; the next call goes on.
  std::optional<bool> connected(const Grid& grid, Cell a, Cell b, const StopCondition& stop) {
    if (!update(grid, stop)) return std::nullopt;
    return components_.connected(grid, a, b);
  }
  std::int64_t bytes() const noexcept { return components_.bytes() + held_bytes(changed_); }

 private:
  bool update(const Grid& grid, const StopCondition& stop) {
    if (!changed_.empty() || !up_to_date_) {
      up_to_date_ = components_.update(grid, changed_, stop);
      changed_.clear();  // if it was stopped, they are kept there
    }
    return up_to_date_;
  }

  Components components_;
  std::vector<Rectangle> changed_;
  bool up_to_date_ = true;
};

/// A colony and what it was not told yet: changes beside each other in one, since each is repaired.
class LiveColony {
 public:
  LiveColony(const Grid& grid, Cell goal, const Params& params)
      : colony_(grid, goal, params), iterations_(params.iterations) {}

  void changed(const Rectangle& part) {
    if (!changed_.empty()) {
      Rectangle& last = changed_.back();
      const Rectangle both = round(last, part);
      if (area(both) <= 4 * (area(last) + area(part))) {
        last = both;
        return;
      }
    }
    changed_.push_back(part);
    constexpr std::size_t kMost = 256;  // where nobody asks
    if (changed_.size() < kMost) return;
    Rectangle all = part;
    for (const Rectangle& one : changed_) all = round(all, one);
    changed_.assign(1, all);
  }
  Result run(const Request& request, const Observer& observer) {
    for (const Rectangle& part : changed_) colony_.changed(part);
    changed_.clear();
    return colony_.run(request.start, iterations_, request.stop, observer);
  }
  void forget() {
    changed_.clear();
    colony_.forget();
  }

 private:
  static std::int64_t area(const Rectangle& r) noexcept { return std::int64_t{r.width} * r.height; }
  static Rectangle round(const Rectangle& a, const Rectangle& b) noexcept {
    const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
    return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
            std::max(a.y + a.height, b.y + b.height) - top};
  }

  SurvivingColony colony_;
  int iterations_;
  std::vector<Rectangle> changed_;
};

}  // namespace

class Navigator::Impl {
 public:
  Impl(Grid grid, Cell to, const NavigatorOptions& given)
      : goal(to), options(given), map(std::move(grid), given.radius) {
    validate(options.params);
    const Algorithm& algorithm = find_algorithm(options.params.algorithm());
    check_certifies(algorithm, options.target_gap);
    if (options.prepare) check_kind(algorithm, Algorithm::Kind::exact, "prepare", "exact");
    if (options.search_on) check_kind(algorithm, Algorithm::Kind::colony, "search_on", "a colony");
    if (algorithm.kind == Algorithm::Kind::colony) send_colony();
    corners = corners_of_paths(options.params);
    if (corners == Corners::allow) eight.emplace(map.passable(), Connectivity::eight);
    if (options.prepare) prepare(*options.prepare);
  }

  /// A trail leads to one goal.
  void send_colony() { colony.emplace(map.passable(), goal, options.params); }

  void prepare(const PrepareOptions& how) {
    check_threads(how.threads);
    const auto begin = Clock::now();
    graph = exact::CornerGraph::make(map.passable(), how, preparation);
    preparation.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }

  const EditedMap::OnChange on_change = [this](const Rectangle& part, std::span<const Cell> cells) {
    four.changed(map.passable(), part);
    if (eight) eight->changed(map.passable(), part);
    if (graph) graph->update(map.passable(), part);
    if (colony) colony->changed(part);
    if (holds) {
      holds = std::ranges::none_of(
          cells, [this](Cell c) { return map.passable().blocked(c) ? breaks(c) : shortens(c); });
    }
  };
  /// Does a cell that has become blocked make the way impossible, or the fault another one?
  bool breaks(Cell cell) const noexcept {
    if (way.path.empty()) return cell == at || cell == goal || cell == way.nearest_free;
    return walker.touches_rest(cell) || beside_walk(cell);
  }
  /// Does the walk pass a cell by a diagonal move?
  bool beside_walk(Cell cell) const noexcept {
    for (std::size_t i = 1; i < way.walk.size(); ++i) {
      const Cell a = way.walk[i - 1], b = way.walk[i];
      if (cell == Cell{a.x, b.y} || cell == Cell{b.x, a.y}) return true;
    }
    return false;
  }

  /// Might a way over a cell that has become free be shorter than what is left of this one? There
  /// is none shorter through it where the straight distances to both ends are as long together.
  bool shortens(Cell cell) const noexcept {
    if (way.path.empty()) return true;
    // Of the cell any point may be met, and of the robot's cell.
    constexpr double kSlack = 4;
    return distance(at, cell) + distance(cell, goal) < walker.rest() + kSlack;
  }

  Result ask(Cell robot, const StopCondition& stop) {
    PlanningMap known{
        .grid = map.passable(),
        .graph = graph.get(),
        .connected = [&](Cell a, Cell b, Corners rule) { return connected(a, b, rule, stop); }};
    if (colony) {
      known.colony = [&](const Request& request, const Observer& observer) {
        return colony->run(request, observer);
      };
    }
    const Request request{
        .start = robot, .goal = goal, .stop = stop, .target_gap = options.target_gap};
    return answer(known, request, options.params, &workspace, {});
  }

  void take(Result&& result) {
    static_cast<Result&>(way) = std::move(result);
    way.replanned = true;
    way.walk.clear();
    walker.begin(way.path);
    holds = way.status == Status::solved || way.status == Status::unreachable ||
            way.status == Status::invalid;
  }

  std::optional<bool> connected(Cell a, Cell b, Corners rule, const StopCondition& stop) {
    const auto joined = four.connected(map.passable(), a, b, stop);
    if (rule != Corners::allow || joined != false) return joined;
    return eight->connected(map.passable(), a, b, stop);
  }

  const Way& step(Cell robot, const StopCondition& stop) {
    way.replanned = false;
    const auto here = std::ranges::find(way.walk, robot);
    const bool on_way = way.path.empty() ? robot == at : here != way.walk.end();
    const bool go_on = holds && on_way;
    at = robot;
    if (go_on) way.walk.erase(way.walk.begin(), here);
    if (!go_on) {
      take(ask(robot, stop));
    } else if (colony && options.search_on && robot != goal) {
      Result result = ask(robot, stop);
      if (!result.path.empty() && result.length < walker.rest()) take(std::move(result));
    }
    if (!way.path.empty() && way.walk.size() < 2) {
      walker.next(map.passable(), rule_of_walks(corners), robot, way.walk);
      if (way.walk.size() < 2 && robot != goal) holds = false;
    }
    return way;
  }

  Cell goal;
  NavigatorOptions options;
  EditedMap map;
  Corners corners;
  std::optional<LiveColony> colony;
  LiveComponents four{map.passable(), Connectivity::four};
  std::optional<LiveComponents> eight;  ///< only where paths may squeeze
  std::shared_ptr<exact::CornerGraph> graph;
  Preparation preparation;
  Workspace workspace;
  PathWalker walker;
  Way way;
  bool holds = false;  ///< the way, as far as is known
  Cell at{-1, -1};     ///< where the robot was in the last step
};

Pilot::~Pilot() = default;

Navigator::Navigator(Grid map, Cell goal, const NavigatorOptions& options)
    : impl_(std::make_unique<Impl>(std::move(map), goal, options)) {}
Navigator::~Navigator() = default;
Navigator::Navigator(Navigator&&) noexcept = default;
Navigator& Navigator::operator=(Navigator&&) noexcept = default;

void Navigator::observe(const Rectangle& part, bool blocked) {
  impl_->map.set(part, blocked, impl_->on_change);
}
void Navigator::observe(std::span<const Cell> cells, bool blocked) {
  impl_->map.set(cells, blocked, impl_->on_change);
}
const Way& Navigator::step(Cell robot, const StopCondition& stop) {
  return impl_->step(robot, stop);
}

Cell Navigator::goal() const noexcept { return impl_->goal; }
void Navigator::set_goal(Cell goal) {
  if (goal == impl_->goal) return;
  impl_->goal = goal;
  impl_->holds = false;
  if (impl_->colony) impl_->send_colony();
}
void Navigator::forget() {
  impl_->holds = false;
  if (impl_->colony) impl_->colony->forget();
}

const Grid& Navigator::map() const noexcept { return impl_->map.map(); }
const Grid& Navigator::passable() const noexcept { return impl_->map.passable(); }
bool Navigator::connected(Cell a, Cell b) { return *impl_->connected(a, b, impl_->corners, {}); }
double Navigator::radius() const noexcept { return impl_->options.radius; }
Corners Navigator::corners() const noexcept { return impl_->corners; }
Preparation Navigator::preparation() const noexcept {
  Preparation now = impl_->preparation;
  if (impl_->graph) {
    now.edges = impl_->graph->edge_count();
    now.bytes = impl_->graph->bytes();
  }
  return now;
}
std::int64_t Navigator::bytes() const noexcept {
  const Impl& i = *impl_;
  return i.map.bytes() + i.four.bytes() + (i.eight ? i.eight->bytes() : 0) + preparation().bytes +
         i.workspace.bytes() + held_bytes(i.way.path, i.way.walk);
}

}  // namespace lasius
