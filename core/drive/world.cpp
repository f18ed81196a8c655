#include "core/drive/world.h"

#include <algorithm>
#include <utility>

#include "core/drive/changes_check.h"
#include "core/grid/components.h"

namespace lasius {
namespace {

int sign(int value) noexcept { return (value > 0) - (value < 0); }

template <class Visit>
void for_each_cell(const Rectangle& part, const Visit& visit) {
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) visit(Cell{x, y});
  }
}

}  // namespace

World::World(const Grid& truth, const Changes& changes, double radius)
    : still_(truth), map_(truth, radius), changes_(changes.cells) {
  check_changes(changes, truth.width(), truth.height());
  std::ranges::stable_sort(changes_, {}, &Change::tick);
  for (const MovingObstacle& o : changes.obstacles) movers_.push_back({o, o.track.front()});
  std::ranges::stable_sort(movers_, {}, [](const Mover& m) { return m.what.tick; });
}

void World::advance(std::int64_t tick, const Holds& holds) {
  tick_ = tick;
  touched_.clear();
  for (const Cell cell : std::exchange(deferred_, {})) set_still(cell, true, holds);
  for (; next_ < changes_.size() && changes_[next_].tick <= tick; ++next_)
    change(changes_[next_], holds);
  for (Mover& mover : movers_)
    if (mover.what.tick <= tick) move(mover, holds);
  if (!touched_.empty()) changed_at_ = tick;
  show();
}

void World::change(const Change& change, const Holds& holds) {
  for_each_cell(change.part, [&](Cell cell) { set_still(cell, change.blocked, holds); });
}

void World::set_still(Cell cell, bool blocked, const Holds& holds) {
  // The last word on a cell counts.
  if (!deferred_.empty()) std::erase(deferred_, cell);
  if (still_.blocked(cell) == blocked) return;
  if (blocked && holds({cell.x, cell.y, 1, 1})) {
    deferred_.push_back(cell);
    ++deferrals_;
    return;
  }
  still_.set_blocked(cell, blocked);
  still_changed_at_ = tick_;
  touched_.push_back(cell);
}

void World::move(Mover& mover, const Holds& holds) {
  if (!mover.there) {
    if (holds(mover.cells(mover.at))) return;
    mover.there = true;
    cover(mover.cells(mover.at), 1);
    return;
  }
  mover.waits = false;
  if (!mover.travels()) return;
  for (mover.moves += mover.what.speed; mover.moves >= 1; mover.moves -= 1) {
    if (!step(mover, holds)) {
      mover.moves = 0;
      mover.waits = true;
      return;
    }
  }
}

// One move towards the next point of the track; false if the robot is in the way.
bool World::step(Mover& mover, const Holds& holds) {
  const auto& track = mover.what.track;
  for (std::size_t turns = 0; mover.at == track[mover.towards]; ++turns) {
    if (turns > 2 * track.size()) return true;  // all its points are one
    if (mover.towards == 0) mover.back = false;
    if (mover.towards + 1 == track.size()) mover.back = true;
    mover.towards += mover.back ? std::size_t{0} - 1 : 1;
  }
  const Cell to = track[mover.towards];
  const Cell next{mover.at.x + sign(to.x - mover.at.x), mover.at.y + sign(to.y - mover.at.y)};
  if (holds(mover.cells(next))) return false;
  cover(mover.cells(mover.at), -1);
  mover.at = next;
  cover(mover.cells(next), 1);
  return true;
}

bool World::held(const HeldCells& robot, const Rectangle& part) const noexcept {
  return std::ranges::any_of(robot.cells(), [&](Cell at) {
    const Cell nearest{std::clamp(at.x, part.x, part.x + part.width - 1),
                       std::clamp(at.y, part.y, part.y + part.height - 1)};
    return map_.growth().blocks(at, nearest);
  });
}

void World::cover(const Rectangle& part, int by) {
  for_each_cell(part, [&](Cell cell) {
    if ((covers_[key(cell)] += by) == 0) covers_.erase(key(cell));
    touched_.push_back(cell);
  });
}

// Cells are told apart at the end, when the last word on each is known.
void World::show() {
  const auto blocked = std::partition(touched_.begin(), touched_.end(), [&](Cell cell) {
    return !still_.blocked(cell) && !covers_.contains(key(cell));
  });
  const EditedMap::OnChange nobody = [](const Rectangle&, std::span<const Cell>) {};
  const std::span<const Cell> cells = touched_;
  const auto free = static_cast<std::size_t>(blocked - touched_.begin());
  map_.set(cells.first(free), false, nobody);
  map_.set(cells.subspan(free), true, nobody);
}

std::vector<Rectangle> World::obstacles() const {
  std::vector<Rectangle> there;
  for (const Mover& mover : movers_)
    if (mover.there) there.push_back(mover.cells(mover.at));
  return there;
}

std::vector<Cell> World::felt(const HeldCells& robot) const {
  std::vector<Cell> cells;
  const Cell at = robot.cells().front();
  const int reach = growth().reach() + 1, side = 2 * reach + 1;
  for_each_cell({at.x - reach, at.y - reach, side, side}, [&](Cell cell) {
    if (now().contains(cell) && now().blocked(cell) && held(robot, {cell.x, cell.y, 1, 1}))
      cells.push_back(cell);
  });
  return cells;
}

bool World::stirs() const noexcept {
  return std::ranges::any_of(movers_, [](const Mover& m) { return m.travels(); });
}

Grid World::walls(Without without) const {
  Grid grid = still_;
  for (const Mover& mover : movers_) {
    const bool moves = mover.travels() && !mover.waits;
    if (!mover.there || without == Without::all_obstacles) continue;
    if (moves && without == Without::those_that_move) continue;
    grid.fill(mover.cells(mover.at), true);
  }
  return grid;
}

bool World::joined(Cell from, Cell to, Corners corners, Without without) const {
  Grid grid = walls(without);
  if (growth().reach() > 0) grid = *grow_obstacles(grid, growth(), {});
  return Components(grid, connectivity_of(corners)).connected(grid, from, to);
}

}  // namespace lasius
