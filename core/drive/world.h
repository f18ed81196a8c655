// What is really there, tick by tick.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/drive/edited_map.h"
#include "lasius/drive/drive.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// The cells that a robot's centre may be in during a move: where it was, where it is, and for a
/// diagonal move the two cells beside.
class HeldCells {
 public:
  HeldCells(Cell from, Cell to) noexcept : cells_{{from, to, {from.x, to.y}, {to.x, from.y}}} {}
  std::span<const Cell> cells() const noexcept { return cells_; }

 private:
  std::array<Cell, 4> cells_;
};

class World {
 public:
  /// @throws Error(invalid_parameter) for changes that are not inside the map.
  World(const Grid& truth, const Changes& changes, double radius);

  /// Whether the robot holds one of some cells.
  using Holds = std::function<bool(const Rectangle&)>;
  /// The changes of a tick take place, and obstacles move; not onto what the robot holds.
  void advance(std::int64_t tick, const Holds& holds);
  /// What a robot of the radius holds in a move.
  bool held(const HeldCells& robot, const Rectangle& part) const noexcept;

  const Grid& now() const noexcept { return map_.map(); }
  /// Where the robot's centre may be.
  const Grid& passable() const noexcept { return map_.passable(); }
  const Growth& growth() const noexcept { return map_.growth(); }
  /// What is there but for moving obstacles, not grown.
  const Grid& still() const noexcept { return still_; }

  /// Moving obstacles that have appeared, where they are.
  std::vector<Rectangle> obstacles() const;
  /// The last tick at which anything changed or moved.
  std::int64_t changed_at() const noexcept { return changed_at_; }
  /// The same, of moving obstacles not.
  std::int64_t still_changed_at() const noexcept { return still_changed_at_; }
  /// Changes are still to come that might open a way: deferred ones do not.
  bool to_change() const noexcept { return next_ < changes_.size(); }
  /// An obstacle moves by itself, or waits for the robot.
  bool stirs() const noexcept;
  std::int64_t deferrals() const noexcept { return deferrals_; }

  /// The blocked cells that keep the robot from what it would hold: it feels them.
  std::vector<Cell> felt(const HeldCells& robot) const;

  /// Can the robot get from cell to cell as things stand? Looks at the whole map.
  enum class Without { nothing, those_that_move, all_obstacles };
  Grid walls(Without without) const;  ///< not grown
  bool joined(Cell from, Cell to, Corners corners, Without without) const;

 private:
  struct Mover {
    MovingObstacle what;
    Cell at;
    std::size_t towards = 0;  // point of the track
    bool back = false;        // on the way to the first one
    double moves = 0;         // not made yet
    bool there = false, waits = false;

    bool travels() const noexcept { return there && what.speed > 0 && what.track.size() > 1; }
    Rectangle cells(Cell corner) const noexcept {
      return {corner.x, corner.y, what.width, what.height};
    }
  };

  void change(const Change& change, const Holds& holds);
  void set_still(Cell cell, bool blocked, const Holds& holds);
  void move(Mover& mover, const Holds& holds);
  bool step(Mover& mover, const Holds& holds);
  void cover(const Rectangle& part, int by);
  void show();
  static std::uint32_t key(Cell c) noexcept {
    return static_cast<std::uint32_t>(c.y) << 16 | static_cast<std::uint32_t>(c.x);
  }

  Grid still_;                   // without moving obstacles
  EditedMap map_;                // with them
  std::vector<Change> changes_;  // by tick
  std::size_t next_ = 0;
  std::vector<Mover> movers_;                      // by the tick in which they appear
  std::unordered_map<std::uint32_t, int> covers_;  // obstacles that cover a cell
  std::vector<Cell> deferred_;                     // to be blocked
  std::vector<Cell> touched_;                      // in the tick in hand, to be shown in map_
  std::int64_t deferrals_ = 0;
  std::int64_t changed_at_ = 0, still_changed_at_ = 0;
  std::int64_t tick_ = 0;
};

}  // namespace lasius
