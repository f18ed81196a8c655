// Paths over costs: where a disc can go, and what is kept of what a search finds.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/special_values.h"
#include "core/cost/merged.h"
#include "core/cost/path_cost.h"
#include "core/cost/terrain.h"
#include "core/disc/disc_space.h"
#include "core/plan/exact_view.h"
#include "core/plan/plan_ends.h"
#include "lasius/base/stop.h"
#include "lasius/cost/planner.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/plan/progress.h"

namespace lasius {

/// The terrain where a grid is free as well.
cost::Terrain narrowed(const cost::Terrain& terrain, const Grid& grid);

/// The cells all of whose points are clear, and those about the ends whose centres are.
Grid wide_cells(const disc::DiscSpace& space, const Grid& passable, Cell start, Cell goal);

/// The path with a disc's shortest ways in place of the pieces that it cannot go; empty when
/// stopped, or where there is none. The path's ends are clear.
std::vector<Point> repaired(const disc::DiscSpace& space, const std::vector<Point>& path,
                            const StopCondition& stop);

/// May a disc go along it, whose first point is clear? Null: a point may.
inline bool can_go(const disc::DiscSpace* space, const std::vector<Point>& path) {
  return space == nullptr || space->reaches_along(path);
}

/// The point of a cell, a little off its border; or its centre.
Point inside(Cell cell, Point p, bool centre_alone);

/// Of the cells about a point those that its path begins in: the cheapest, since from there it
/// comes to the others over the point itself; two where it may not, between diagonal blocks.
std::vector<Cell> begun_in(const cost::Terrain& terrain, const FewCells& about);

/// The better of two answers of searches that have nothing in common but the ends.
CostResult cheaper(CostResult one, CostResult other);

/// Lets a path begin at another point of its first vertex's cell: straight to where it leaves that.
void move_end(std::vector<Point>& path, Point to);

/// The cheapest path so far that a robot can go, and who is told of it.
class Kept {
 public:
  Kept(const cost::Terrain& terrain, const disc::DiscSpace* space, const Observer& observer)
      : terrain_(terrain), space_(space), observer_(observer) {}

  /// False where whoever looks on asks to end.
  bool offer(std::vector<Point> path, double cost, double bound) {
    if (!(cost < cost_) || !can_go(space_, path)) return true;
    std::vector<Point> fewer = cost::merged(terrain_, path);
    const double less = cost::cost_of(terrain_, fewer);
    if (less <= cost * (1 + 1e-12) && can_go(space_, fewer)) {
      path = std::move(fewer);
      cost = less;
    }
    path_ = std::move(path);
    cost_ = cost;
    if (!observer_) return true;
    return observer_(ExactView(path_, improvements_++, cost_, std::min(bound, cost_))) == Go::on;
  }
  std::vector<Point>& path() noexcept { return path_; }
  bool any() const noexcept { return !path_.empty(); }
  double cost() const noexcept { return cost_; }

 private:
  const cost::Terrain& terrain_;
  const disc::DiscSpace* space_;
  const Observer& observer_;
  std::vector<Point> path_;
  double cost_ = kInfinity;
  int improvements_ = 0;
};

}  // namespace lasius
