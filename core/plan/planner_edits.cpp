// Planners made from planners: a map that changes.
#include <set>
#include <tuple>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/disc/disc_cells.h"
#include "core/grid/grow_obstacles.h"
#include "core/plan/planner_impl.h"

namespace lasius {
namespace {

/// A direction as it is ordered, to find it again.
using Key = std::tuple<int, int, int, int>;
Key key_of(const Planner::Direction& d) { return {d.from.x, d.from.y, d.dx, d.dy}; }

std::set<Key> keys_of(std::span<const Planner::Direction> directions) {
  std::set<Key> keys;
  for (const auto& d : directions) keys.insert(key_of(d));
  return keys;
}

}  // namespace

std::shared_ptr<const Planner::Impl> Planner::Impl::next(std::span<const Edit> edits,
                                                         std::vector<Direction> directions,
                                                         const StopCondition& stop) const {
  Grid now = map();
  for (const Cell c : closed) now.set_blocked(c, false);  // the map as it is
  for (const Edit& edit : edits) {
    if (!now.contains(edit.cell))
      refuse("edited cell " + cell_name(edit.cell) + " is outside",
             "the map is " + size_text(now.width(), now.height()) + " cells");
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
    if (now.blocked(c) != map().blocked(c)) changed.push_back(c);
  };
  for (const Edit& edit : edits) note(edit.cell);
  for (const Cell c : closed) note(c);
  for (const Cell c : shut) note(c);
  if (disc != nullptr)
    return next_of_disc(std::move(now), changed, std::move(directions), std::move(shut), stop);
  auto components = four.updated(now, changed, stop);
  if (!components) return nullptr;
  auto made = std::make_shared<Impl>(std::move(now), std::move(*components), std::move(directions),
                                     std::move(shut));
  std::shared_ptr<const StaleAnswers> older;
  if (graph != nullptr)
    older = std::make_shared<const StaleAnswers>(
        std::make_shared<const PreparedMap>(PreparedMap{grid, graph, labels}), made->grid, changed);
  else if (stale != nullptr)
    older = std::make_shared<const StaleAnswers>(*stale, made->grid, changed);
  if (older != nullptr && older->tells()) made->stale = std::move(older);
  return made;
}

std::shared_ptr<const Planner::Impl> Planner::Impl::next_of_disc(
    Grid&& now, std::span<const Cell> changed, std::vector<Direction>&& directions,
    std::vector<Cell>&& shut, const StopCondition& stop) const {
  Grid grown = grid;
  Components joined = four;
  std::vector<Rectangle> parts;
  if (!regrow(now, disc::growth(now, disc->radius), changed, grown, parts, stop)) return nullptr;
  if (!joined.update(grown, parts, stop)) return nullptr;
  auto next_disc = std::make_shared<DiscMap>(*disc);
  if (next_disc->space) {
    if (!next_disc->space->update(now, changed, stop)) return nullptr;
  } else {
    next_disc->alone = std::move(now);
  }
  return std::make_shared<const Impl>(std::move(grown), std::move(joined), std::move(directions),
                                      std::move(shut), std::move(next_disc));
}

std::optional<Planner> Planner::edited(std::span<const Edit> edits,
                                       const StopCondition& stop) const {
  return if_made(impl_->next(edits, impl_->excluded, stop));
}

std::optional<Planner> Planner::exclude(std::span<const Direction> reported,
                                        const StopCondition& stop) const {
  std::vector<Direction> directions = impl_->excluded;
  std::set<Key> known = keys_of(directions);
  for (const Direction& d : reported) {
    if (!impl_->grid.contains(d.from))
      refuse("excluded direction starts outside the map, at " + cell_name(d.from),
             "give a cell of the map");
    const auto one = [](int step) { return step >= -1 && step <= 1; };
    if (!one(d.dx) || !one(d.dy) || (d.dx == 0 && d.dy == 0))
      refuse(pair_text(d.dx, d.dy) + " is no direction",
             "give one of the eight steps to a neighbour");
    if (known.insert(key_of(d)).second) directions.push_back(d);
  }
  return if_made(impl_->next({}, std::move(directions), stop));
}

std::optional<Planner> Planner::allow(std::span<const Direction> gone,
                                      const StopCondition& stop) const {
  const std::set<Key> allowed = keys_of(gone);
  std::vector<Direction> directions;
  for (const Direction& d : impl_->excluded)
    if (!allowed.contains(key_of(d))) directions.push_back(d);
  return if_made(impl_->next({}, std::move(directions), stop));
}

std::span<const Planner::Direction> Planner::excluded() const noexcept { return impl_->excluded; }

}  // namespace lasius
