// A drive through a world that is not as the map has it, and that changes: simulated, tick by tick.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/base/status.h"
#include "lasius/base/stop.h"
#include "lasius/drive/navigator.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// At the beginning of a tick the cells of a rectangle become blocked or free.
struct Change {
  std::int64_t tick = 0;  ///< 0 or more
  Rectangle part;         ///< inside the map
  bool blocked = true;    ///< else free
  friend bool operator==(const Change&, const Change&) = default;
};

/// A rectangle of blocked cells that moves from one point of its track to the next, to the last
/// one and back again, for ever. It passes over blocked cells and over others of its kind, but
/// never onto the robot: it waits.
struct MovingObstacle {
  std::int64_t tick = 0;    ///< when it appears, 0 or more; later, should the robot stand there
  int width = 1;            ///< columns, at least 1
  int height = 1;           ///< rows, at least 1
  double speed = 0;         ///< moves to one of the eight neighbours per tick, 0 .. 64
  std::vector<Cell> track;  ///< its top left cell at each point, inside the map; at least one
  friend bool operator==(const MovingObstacle&, const MovingObstacle&) = default;
};

/// What happens to a world.
struct Changes {
  std::vector<Change> cells;              ///< of one tick in this order
  std::vector<MovingObstacle> obstacles;  ///< they move in this order
  friend bool operator==(const Changes&, const Changes&) = default;
};

/// Reads changes from text, one a line; numbers are parted by blanks or commas, `#` begins a
/// comment:
///
///     TICK X Y blocked|free                  one cell
///     TICK X Y W H blocked|free              a rectangle
///     TICK move W H SPEED X Y [X Y]...       a moving obstacle and its track
///
/// @param name   of the file, for messages
/// @param width  of the map, like `height`
/// @throws Error(file_broken) with the line, for text that is none of these and for what does not
/// lie inside the map.
LASIUS_EXPORT Changes read_changes(std::string_view text, const std::string& name, int width,
                                   int height);
/// Reads a file of changes. @throws likewise, and Error(file_missing).
LASIUS_EXPORT Changes read_changes_file(const std::string& path, int width, int height);

/// A tick as an observer sees it, after the robot has seen and planned, before it moves. Pointers
/// hold until the observer returns.
struct DriveTick {
  std::int64_t tick = 0;               ///< from 0
  Cell robot;                          ///< where it is
  const Grid* world = nullptr;         ///< what is there in truth, moving obstacles too
  const Grid* still = nullptr;         ///< the same without moving obstacles
  const Pilot* robot_knows = nullptr;  ///< its planner, with its map
  const Way* way = nullptr;            ///< null where the planner gave none, and on arrival
  std::vector<Rectangle> obstacles;    ///< where the moving ones are, those that have appeared
  std::vector<Cell> news;              ///< cells that the robot learned in this tick
  bool replanned = false;              ///< the way was planned in this tick
  bool arrived = false;                ///< at the goal, or as near as its tolerance lets it
};
/// Called at each tick and on arrival, but not at one that ends without a way. Go::stop ends the
/// drive there, where it has neither arrived nor spent its ticks: Status::interrupted.
using DriveObserver = Callback<const DriveTick&>;

/// How to drive.
struct DriveOptions {
  /// The robot sees cells whose centre is at most so far from its own, in cells: a free one where
  /// `visible` holds between the centres, a blocked one at whose edge it sees a free cell, or
  /// stands; and all cells that its disc covers. At least 1.
  double sense = 20;
  std::int64_t max_ticks = 1'000'000;  ///< 0 or more; after them it ends as Status::limit
  /// Time for planning in a tick, in seconds of the stop condition's clock, above 0: a search that
  /// takes longer ends with the best way so far. Drives can be replayed only where it is infinite.
  double seconds_per_tick = std::numeric_limits<double>::infinity();
  /// As Params::seed; draws the cells to which the robot steps aside for obstacles: see drive().
  std::uint64_t seed = 1;
  StopCondition stop = {};      ///< ends the drive; by its clock time is told
  DriveObserver observer = {};  ///< sees each tick
};

/// A way that was planned.
struct Replan {
  std::int64_t tick = 0;  ///< when
  double ms = 0;          ///< spent on planning in this tick, by the stop condition's clock
  double length = 0;  ///< of the way that came of it, in cells; not a number where there is none
  double cost = std::numeric_limits<double>::quiet_NaN();  ///< its Way::cost
};

/// How a drive went.
struct DriveResult {
  /// Status::solved on arrival; Status::unreachable: proven on what is known at last;
  /// Status::no_path and Fault::trapped: moving obstacles stand in the way for good, or have for
  /// 16 384 ticks, or close one way after the other: while nothing changed but them, and nothing
  /// else was to, the robot entered no new cell for 16 384 ticks and 16 for each that it had been
  /// in, not counting those in which no plan was ready; Status::limit: no ticks or time left;
  /// Status::interrupted; Status::invalid: at tick 0 the start is blocked in truth or outside, or
  /// the goal as the robot knows it then.
  Status status = Status::no_path;
  Limit limit = Limit::none;  ///< which one ended it: of time or of ticks
  Fault fault = Fault::none;  ///< why it is invalid, unreachable or trapped
  std::string error;          ///< the same in a sentence; empty for none
  /// To a start or goal that is invalid: free in truth, and for a goal on the robot's map too.
  std::optional<Cell> nearest_free;
  std::optional<Cell> nearest_reachable;  ///< the same, joined to the other end: see Result
  /// With a goal tolerance: where the robot arrived.
  std::optional<Cell> goal_reached;
  std::vector<Cell> track;            ///< where the robot was at each tick, the start first
  std::int64_t ticks = 0;             ///< moves and waits: track.size() - 1
  std::vector<Replan> replans;        ///< in order
  std::int64_t seen = 0;              ///< cells learned to be other than they were known
  double length = 0;                  ///< travelled, in cells
  double cost = 0;                    ///< of that, each move's as the robot knew it: move_cost()
  double planning_ms = 0;             ///< in all ticks, by the stop condition's clock
  std::int64_t waits = 0;             ///< ticks in which the robot stood
  std::int64_t deferred_changes = 0;  ///< sum over ticks of cells whose change waits for the robot
};

/// Drives a robot from `start` to `goal`, in each tick one move to one of the eight neighbours, or
/// none.
///
/// In each tick changes take place and obstacles move, then the robot sees, plans, and moves to the
/// next cell of its way. It never enters a cell that is blocked at that tick, nor cuts a corner
/// between two cells of which one is blocked, unless Pilot::corners allows all; with a
/// radius the same holds for its disc. What would block a cell that the robot covers, or has
/// covered on its last move, waits: a change is deferred to the first tick at which it can be made,
/// an obstacle stands. So robot and obstacle never exchange cells.
///
/// Where no way is known, the robot doubts walls that it has not seen since the world changed last,
/// or ever: first those that it learned before, then those of the map. While obstacles move, or
/// changes are to come, it waits first, and every 16 ticks steps aside to a cell nearby, drawn at
/// random, so that an obstacle that waits for it can pass. The simulation tells it from the truth
/// whether a way exists at all: it gives up where none does, and else searches until it arrives,
/// unless it is trapped. With a goal tolerance it has arrived, too, where a way that it was given
/// ends short of a goal that cannot be reached as far as it knows, when it has doubted walls.
/// @param map    what the robot knows in the beginning
/// @param truth  what is there, of the same size
/// @param navigator  how it plans, and its radius
/// @throws Error(invalid_parameter) for sizes that differ, changes outside the map, and options out
/// of range or, as Navigator, for other algorithms; what the observer throws.
LASIUS_EXPORT DriveResult drive(const Grid& map, const Grid& truth, Cell start, Cell goal,
                                const Changes& changes = {}, const DriveOptions& options = {},
                                const NavigatorOptions& navigator = {});

/// The same with a planner that is there already, to its goal; it knows what it has observed.
/// @throws likewise, and where its walk leads to no neighbour of the robot's cell.
LASIUS_EXPORT DriveResult drive(Pilot& pilot, const Grid& truth, Cell start,
                                const Changes& changes = {}, const DriveOptions& options = {});

}  // namespace lasius
