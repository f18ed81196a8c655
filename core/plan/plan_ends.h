// Where a plan begins and ends, and why it does not.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "core/base/special_values.h"
#include "core/disc/sweep.h"
#include "core/grid/cell_distance.h"
#include "core/grid/rings.h"
#include "core/plan/answer.h"
#include "core/plan/disc_path.h"
#include "lasius/grid/clearance.h"

namespace lasius {

/// Where a plan begins and ends: cells' centres, unless points are asked for, or a disc's curve is.
struct Places {
  Point from, to;
  std::optional<Point> way_out = {};  ///< from where it begins, if not at the start
};

/// A start or goal as it was asked for.
struct Asked {
  Point at;
  Cell cell;      ///< that holds it
  bool is_point;  ///< at another place than the cell's centre

  Asked(const Grid& map, Cell c, const std::optional<Point>& p)
      : at(p.value_or(centre(c))), cell(p ? cell_of(map, *p) : c), is_point(at != centre(cell)) {}
  std::string name() const { return is_point ? pair_text(at.x, at.y) : cell_name(cell); }
  /// Of a point far outside the map its cell's centre.
  Spot spot() const {
    const Point middle = centre(cell), aside{at.x - middle.x, at.y - middle.y};
    const bool inside = std::abs(aside.x) <= 0.5 && std::abs(aside.y) <= 0.5;
    return {cell, inside ? aside : Point{}};
  }

 private:
  /// The last column and row hold the map's border.
  static Cell cell_of(const Grid& map, Point p) noexcept {
    const auto part = [](double v, int side) {
      constexpr double kFar = 1 << 30;
      if (v == side) return side - 1;
      return static_cast<int>(std::floor(std::max(-kFar, std::min(v, kFar))));  // of NaN -kFar
    };
    return {part(p.x, map.width()), part(p.y, map.height())};
  }
};

/// A few cells.
class FewCells {
 public:
  FewCells() = default;
  explicit FewCells(Cell c) noexcept { add(c); }
  void add(Cell c) noexcept { cells_[count_++] = c; }
  int size() const noexcept { return count_; }
  const Cell* begin() const noexcept { return cells_.data(); }
  const Cell* end() const noexcept { return cells_.data() + count_; }

 private:
  std::array<Cell, 4> cells_{};
  int count_ = 0;
};

/// Where a path may begin and end: points of cells that are free, or for `exact` and a disc those
/// that are clear.
class Ends {
 public:
  Ends(const PlanningMap& map, const disc::DiscSpace* space, Corners corners)
      : map_(map), space_(space), corners_(corners) {}

  const PlanningMap& map() const noexcept { return map_; }
  /// The map, before obstacles grew.
  const Grid& map_alone() const noexcept {
    return map_.disc != nullptr ? map_.disc->map() : map_.grid;
  }
  bool serves(const Asked& end) const {
    return space_ == nullptr ? walked_from(end.at).size() > 0 : space_->clear(end.at);
  }
  /// Of two that serve; nothing if stopped.
  std::optional<bool> joined(Point a, Point b) const {
    if (space_ != nullptr) return space_->joined(a, b);
    const FewCells goals = walked_from(b);
    for (const Cell from : walked_from(a))
      for (const Cell to : goals) {
        const auto both = map_.connected(from, to, corners_);
        if (both != false) return both;
      }
    return false;
  }
  /// The cells between whose centres is walked, joined if any are.
  std::pair<Cell, Cell> walk(Point a, Point b) const {
    const auto from = walked_from(a), to = walked_from(b);
    if (from.size() == 0 || to.size() == 0) return {cell_at(a), cell_at(b)};
    for (const Cell c : from)
      for (const Cell d : to)
        if (from.size() * to.size() == 1 || map_.connected(c, d, corners_) == true) return {c, d};
    return {*from.begin(), *to.begin()};
  }
  /// Cells whose centres a point sees, and from which it is walked; none where it does not serve.
  FewCells walked_from(Point p) const {
    const Grid& map = map_alone();
    FewCells cells;
    if (!(p.x >= 0 && p.x <= map.width() && p.y >= 0 && p.y <= map.height())) return cells;
    const Cell last{static_cast<int>(p.x), static_cast<int>(p.y)};
    if (p == centre(last)) {
      if (map_.grid.free(last)) cells.add(last);
      return cells;
    }
    if (map_.disc != nullptr) return legs_from(p, last);
    const Cell first{static_cast<int>(std::ceil(p.x)) - 1, static_cast<int>(std::ceil(p.y)) - 1};
    for (int y = last.y; y >= first.y; --y)
      for (int x = last.x; x >= first.x; --x)
        if (map_.grid.free({x, y})) cells.add({x, y});
    return cells;
  }
  /// Of the cells that serve, if given of those joined to `other`, the nearest. It is found
  /// whatever the deadline.
  std::optional<Cell> nearest(const Asked& end, const std::stop_token& token,
                              const std::optional<Point>& other = {}) const {
    const StopCondition no_deadline{.token = token};
    Poller poller(no_deadline);
    if (space_ != nullptr) return nearest_clear(*space_, end.spot(), poller, other);
    if (!other) return nearest_free(map_.grid, end.spot(), poller);
    const auto leads_on = [&](Cell at) { return joined(*other, centre(at)).value_or(false); };
    return nearest_free(map_.grid, end.spot(), poller, leads_on);
  }
  /// The same, of a disc's curve any point, if it is not walked.
  std::optional<Point> nearest_point(const Asked& end, const std::stop_token& token,
                                     Point other) const {
    if (space_ == nullptr || map_.walked) {
      const auto cell = nearest(end, token, other);
      return cell ? std::optional(centre(*cell)) : std::nullopt;
    }
    const StopCondition no_deadline{.token = token};
    Poller poller(no_deadline);
    return space_->way_out(end.at, poller, other);
  }
  /// From a start that does not serve, but lies in a free cell: the nearest place that serves, if
  /// given of those joined to `goal`, to which a leg leads that is nowhere nearer to what is
  /// blocked than the start.
  std::optional<Point> way_out(const Asked& start, const std::optional<Point>& goal,
                               Poller& poller) const {
    if (map_.walked || map_.disc == nullptr || map_.disc->map().blocked(start.cell))
      return std::nullopt;
    const Grid& map = map_.disc->map();
    const Point from = start.at;
    const double most = std::min(map_.disc->radius, 1.0 * map.width() + map.height());
    const double clearance = nearest_blocked(map, from, most).distance - disc::kSlack;
    const auto leads_there = [&](Point to) { return disc::sweeps_clear(map, from, to, clearance); };
    if (space_ != nullptr) return space_->way_out(from, poller, goal, leads_there);
    std::optional<Point> best;
    double nearest = kInfinity;
    for_rings(map, start.cell, nearest, poller, [&](Cell c) {
      const Point to = centre(c);
      if (map_.grid.blocked(c) || !(distance(from, to) < nearest) || !leads_there(to)) return;
      if (goal && joined(to, *goal) != true) return;
      nearest = distance(from, to);
      best = to;
    });
    return best;
  }
  /// What is wrong with one that does not serve.
  std::pair<Fault, std::string> fault(bool at_start, const Asked& end) const {
    const Grid& map = map_alone();
    const bool near = map_.disc != nullptr && !map.blocked(end.cell);
    return fault_of_end(
        map, at_start, end.cell,
        near ? "nearer to what is blocked than the radius of " + rounded_text(map_.disc->radius)
             : "blocked",
        end.name());
  }

 private:
  /// Of a disc that walks: the nearest centre that it can go to from a point so that it keeps the
  /// radius, if there is one near by.
  FewCells legs_from(Point p, Cell at) const {
    constexpr int kNearBy = 2;
    const double room = map_.disc->radius - disc::kSlack;
    FewCells found;
    double least = kInfinity;
    for (int y = at.y - kNearBy; y <= at.y + kNearBy; ++y)
      for (int x = at.x - kNearBy; x <= at.x + kNearBy; ++x) {
        const Point to = centre(Cell{x, y});
        if (!(distance(p, to) < least) || map_.grid.blocked({x, y}) ||
            !disc::sweeps_clear(map_alone(), p, to, room))
          continue;
        least = distance(p, to);
        found = FewCells({x, y});
      }
    return found;
  }

  const PlanningMap& map_;
  const disc::DiscSpace* space_;
  Corners corners_;
};

/// Finds where the plan begins and ends, or why there is none.
std::optional<Result> refused(const Ends& ends, const Request& request, const Asked& start,
                              const Asked& goal, Places& places);

/// The answer where start and goal are not joined; `from` is where the plan begins.
Result apart(const Ends& ends, const Request& request, const Asked& start, const Asked& goal,
             Point from);

}  // namespace lasius
