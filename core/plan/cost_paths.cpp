#include "core/plan/cost_paths.h"

#include "core/base/invalid_parameter.h"
#include "core/disc/disc_search.h"
#include "core/grid/cell_distance.h"
#include "core/plan/legs.h"

namespace lasius {

cost::Terrain narrowed(const cost::Terrain& terrain, const Grid& grid) {
  cost::Terrain narrow = terrain;
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x)
      if (grid.blocked({x, y})) narrow.set({x, y}, kInfinity);
  return narrow;
}

Grid wide_cells(const disc::DiscSpace& space, const Grid& passable, Cell start, Cell goal) {
  Grid wide = space.blocked_cells();
  for (int y = 0; y < wide.height(); ++y)
    for (int x = 0; x < wide.width(); ++x)
      if (space.in_band({x, y})) wide.set_blocked({x, y});
  for (const Cell end : {start, goal})
    for (int y = end.y - 1; y <= end.y + 1; ++y)
      for (int x = end.x - 1; x <= end.x + 1; ++x)
        if (!passable.blocked({x, y})) wide.set_blocked({x, y}, false);
  return wide;
}

std::vector<Point> repaired(const disc::DiscSpace& space, const std::vector<Point>& path,
                            const StopCondition& stop) {
  if (path.empty()) return {};  // none was found in time
  std::vector<Point> made{path.front()};
  disc::DiscSearch search;
  disc::DiscAnswer way;
  for (std::size_t i = 1; i < path.size(); ++i) {
    while (!space.clear(path[i])) ++i;
    if (space.reaches(made.back(), path[i])) {
      made.push_back(path[i]);
      continue;
    }
    search.search(space, nullptr, made.back(), path[i], {}, stop, way);
    if (way.path.empty()) return {};
    made.insert(made.end(), way.path.begin() + 1, way.path.end());
  }
  return made;
}

Point inside(Cell cell, Point p, bool centre_alone) {
  constexpr double kOff = 1e-7;
  if (centre_alone) return centre(cell);
  return {std::clamp(p.x, cell.x + kOff, cell.x + 1 - kOff),
          std::clamp(p.y, cell.y + kOff, cell.y + 1 - kOff)};
}

std::vector<Cell> begun_in(const cost::Terrain& terrain, const FewCells& about) {
  std::vector<Cell> cells(about.begin(), about.end());
  if (cells.size() == 2 && cells[0].x != cells[1].x && cells[0].y != cells[1].y) return cells;
  return {std::ranges::min(cells, {}, [&](Cell c) { return terrain.weight(c.x, c.y); })};
}

CostResult cheaper(CostResult one, CostResult other) {
  if (one.path.empty() || (!other.path.empty() && other.cost < one.cost)) std::swap(one, other);
  one.lower_bound = one.lower_bound && other.lower_bound
                        ? std::optional(std::min(*one.lower_bound, *other.lower_bound))
                        : std::nullopt;
  one.optimal = one.optimal && one.lower_bound && *one.lower_bound >= one.cost;
  if (other.status != Status::solved) one.status = other.status;
  return one;
}

// Lengths of a colony's `best` are costs, but plan_legs() puts the lengths of the legs before it.
CostResult CostPlanner::plan_through(const Request& asked, const CostOptions& options) const {
  if (options.proof)
    refuse("a proof is asked for of a path through points", "ask for one of each part");
  CostResult whole;
  double cost = 0, dearer = 0;  // of the legs; of those before the last, than their lengths
  const auto plan_leg = [&](const Request& leg) -> Result {
    dearer = cost - whole.length;
    CostResult found = plan(leg, options);
    cost += found.cost;
    whole.length += found.length;
    return found;
  };
  whole.length = 0;
  static_cast<Result&>(whole) = plan_legs(asked, plan_leg);
  if (planner().robot().radius == 0)
    refuse_squeezes(planner().grid(), asked, corners_of_paths(options.params, {}), whole);
  if (whole.path.empty()) return whole;
  whole.cost = cost;
  for (double& best : whole.curves.best) best += dearer;
  return whole;
}

void move_end(std::vector<Point>& path, Point to) {
  if (path.size() > 1) {
    const Point from = path[0], next = path[1];
    const Cell cell = cell_at(from);
    const auto share = [](double at, double step, int low) {
      return step == 0 ? kInfinity : ((step > 0 ? low + 1 : low) - at) / step;
    };
    const double t =
        std::min(share(from.x, next.x - from.x, cell.x), share(from.y, next.y - from.y, cell.y));
    if (t < 1)
      path.insert(path.begin() + 1,
                  {from.x + t * (next.x - from.x), from.y + t * (next.y - from.y)});
    path[0] = to;
  } else if (!path.empty() && path[0] != to) {
    path.insert(path.begin(), to);
  }
}

}  // namespace lasius
