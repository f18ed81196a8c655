// Planning on a bitmap: make a planner of a map once, then plan from as many threads as you like.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lasius/base/status.h"
#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"
#include "lasius/params/own_rules.h"
#include "lasius/params/params.h"
#include "lasius/plan/preparation.h"
#include "lasius/plan/progress.h"
#include "lasius/plan/request.h"
#include "lasius/plan/result.h"

namespace lasius {

struct WorkspaceMemory;  // internal

/// Scratch memory of one call in flight. Keep one per thread: with it, `exact` and every colony
/// allocate nothing but the result in a second call of the same size. A call without one gives its
/// memory back before it returns, past a deadline, too: a tenth of a second for each gigabyte that
/// ants have touched. A call that threw leaves nothing in it that a later one sees.
///
/// It holds what its largest calls took, whatever the map of the next one: the ants' tours, tiles
/// of pheromone, the corners that `exact` reached. The cells that ants entered, a bit per cell and
/// ant, are given back on large maps when the next colony begins.
class LASIUS_EXPORT Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;  ///< one that was moved from may only be assigned to or end
  Workspace& operator=(Workspace&&) noexcept;

  /// Memory held, in bytes; of large arrays the pages that were touched. Between two calls.
  std::int64_t bytes() const noexcept;
  /// Gives all of it back, in a tenth of a second for each gigabyte; the next call begins as with a
  /// new Workspace. Between two calls. @throws std::bad_alloc, and is then as before.
  void release();

 private:
  friend struct WorkspaceMemory;
  std::unique_ptr<WorkspaceMemory> memory_;
};

/// What else a plan may be given.
struct PlanOptions {
  Workspace* workspace = nullptr;  ///< kept from call to call; null: memory of this call alone
  Observer observer = {};          ///< called as Progress says
  OwnRules own_rules = {};         ///< of a colony
};

/// A robot: a disc whose centre keeps a distance of `radius` cells, and no more is asked, from
/// every blocked cell (a closed square) and from what lies outside the map. 0: a point.
struct Disc {
  double radius = 0;  ///< cells
};

/// A map made ready for planning. Immutable: use one from many threads, a Workspace each. After a
/// move only assignment and destruction are left.
class LASIUS_EXPORT Planner {
 public:
  /// Labels the components of the free cells; nothing else is made of the map.
  ///
  /// For a disc, unless its radius is 0, `exact` plans exactly where it can go: its answers have a
  /// Result::curve of straight pieces and arcs, a door as wide as the disc is open, and start and
  /// goal may be cells whose centres alone keep the radius. Its radii are those of [0.05, 54]
  /// cells; for any other it refuses every request. All other algorithms walk over `passable()`:
  /// their paths keep the radius, too, but a door whose middle is no centre of a cell may be closed
  /// to them. Params::corners has no effect: diagonal moves are those that keep the radius, or
  /// between four passable cells; a knight's move needs all of its 2 x 3 cells then.
  /// @throws Error(invalid_parameter) for a radius that is negative or not finite.
  explicit Planner(Grid grid, Disc robot = {});
  /// Also prepares the map for `exact`: makes its visibility graph, of a disc that of its curves.
  /// Answers are as short and as certain as without; where several paths are shortest perhaps
  /// another one. If the graph was abandoned, planning uses the ordinary search; the stop condition
  /// is asked about the graph alone. Of planners made from this one by edited, exclude and allow
  /// see edited.
  /// @throws Error(invalid_parameter) where the number of threads is out of range, and as above.
  Planner(Grid grid, const PrepareOptions& options, Disc robot = {});
  /// As the constructors, for those who may have to stop: empty if stopped while components were
  /// labelled, or a disc's free space was made. `grid` is moved from only where a planner comes of
  /// it. @throws as they do.
  [[nodiscard]] static std::optional<Planner> make(Grid&& grid, Disc robot = {},
                                                   const StopCondition& stop = {});
  /// The same, with the visibility graph: a stop that comes later leaves the planner without it.
  [[nodiscard]] static std::optional<Planner> make_prepared(Grid&& grid,
                                                            const PrepareOptions& options = {},
                                                            Disc robot = {});
  /// A planner for the same map, prepared as by the constructor. Copies the bitmap and its
  /// components; this one stays as it is. @throws as the constructor with options.
  Planner prepared(const PrepareOptions& options) const;
  ~Planner();
  Planner(const Planner&) noexcept;  ///< copies share the map
  Planner& operator=(const Planner&) noexcept;
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  const Grid& grid() const noexcept;  ///< the map; holds as long as the planner
  Disc robot() const noexcept;        ///< whom it plans for
  /// The cells that colonies walk over, and what components, `connected`, `nearest_free` and
  /// `nearest_reachable` are about, of a disc by its own rule of corners: those whose centres keep
  /// the radius; of one that is not in [0.05, 54] grow_obstacles(grid(), radius). Holds as long as
  /// the planner.
  const Grid& passable() const noexcept;
  /// May the robot's centre be at the centre of a cell, for `exact`?
  bool clear(Cell c) const noexcept;
  /// Can it go from the centre of one cell to that of another, for `exact`? False proves that it
  /// cannot; for a point as `connected`.
  bool joined(Cell a, Cell b) const;
  /// As `clear`, of a point: of a free cell or its border, a disc's where it keeps the radius.
  bool clear_at(Point p) const;
  /// As `joined`, of two points.
  bool joined_at(Point a, Point b) const;
  /// The largest radius in cells, at most 54, with which a disc can go from the centre of one cell
  /// to that of another, whatever this planner's; nothing where not even a point can, or when
  /// stopped (ask its token), or one is outside. Makes a disc's free space for some 15 radii, plans
  /// with the last ones, and keeps a quarter of a byte a cell of 32 of all that it made.
  std::optional<double> widest_disc(Cell a, Cell b, const StopCondition& stop = {}) const;

  /// Labels the components under a rule, if that is still to do: those of 8 neighbours, for
  /// Corners::allow. Else the first call does that needs them, on its own time: a plan or a call of
  /// `connected` between cells that 4 neighbours do not join, or `components`. Takes 0.6 ms for a
  /// million cells, in dense noise 4 ms. False when stopped.
  bool label(Corners corners, const StopCondition& stop = {}) const;

  /// True when the cells are joined under the rule (4-connected for forbid and one_side,
  /// 8-connected for allow). No work that grows with the map once the rule is labelled; before, see
  /// `label`, which can be stopped.
  bool connected(Cell a, Cell b, Corners corners = Corners::forbid) const;

  /// The free cell nearest to `c` (Euclidean, ties to the smaller row, then column), if there is
  /// one.
  std::optional<Cell> nearest_free(Cell c) const;

  /// The same of the cells that are joined to `from` under a rule; nothing where that is blocked.
  std::optional<Cell> nearest_reachable(Cell c, Cell from, Corners corners = Corners::forbid) const;

  /// The lengths in cells of shortest paths from each source to each target, row by row: by
  /// `exact`, exact up to rounding, whatever the number of threads; infinite where there is none.
  /// Where both are the same array, each pair is asked once. Nothing if stopped.
  /// @throws Error(invalid_parameter) for a cell that is outside or blocked, or where the number of
  /// threads is out of range.
  std::optional<std::vector<double>> distances(std::span<const Cell> sources,
                                               std::span<const Cell> targets, int threads = 0,
                                               const StopCondition& stop = {}) const;
  /// The same between points.
  std::optional<std::vector<double>> distances(std::span<const Point> sources,
                                               std::span<const Point> targets, int threads = 0,
                                               const StopCondition& stop = {}) const;

  /// Answers one request.
  /// Deterministic in (grid, request, params); threads and CPU never change the answer, a deadline
  /// or token may. An unreachable goal is proven before any search.
  /// @throws Error(invalid_parameter) for parameters that validate() refuses, a target gap that is
  /// out of range or that the algorithm cannot certify, a goal tolerance out of range, a disc's
  /// radius that `exact` has no answers for, own rules that do not go with map or algorithm, and
  /// from a colony where the environment's LASIUS_KERNELS names no kernels that this CPU has; what
  /// observer and own rules throw. Start or goal outside or blocked is an answer, not an exception:
  /// Status::invalid.
  Result plan(const Request& request, const Params& params = {},
              const PlanOptions& options = {}) const;

  /// What is to be of a cell.
  struct Edit {
    Cell cell;            ///< of the map
    bool blocked = true;  ///< else free
  };
  /// A planner for the map with some cells changed; this one stays as it is. Copies the bitmap
  /// (one bit per cell) and labels only the tiles around changed cells again. What is excluded
  /// stays excluded.
  /// It is not prepared. But where this one is, or was when it was made so, for a point, it keeps
  /// what was prepared: `exact` then answers by that where the path found is one still and no way
  /// through what has become free (at most 1024 cells) can be shorter, by labels or else straight
  /// distances; and by the ordinary search where it is not proven. prepared() of it prepares the
  /// new map, which another thread may do meanwhile; labels keep the order that the older ones had,
  /// as long as few corners are new. @throws Error(invalid_parameter) for a cell outside the map.
  /// Empty only if stopped while tiles were labelled; the bitmap's copy is not cut short.
  [[nodiscard]] std::optional<Planner> edited(std::span<const Edit> edits,
                                              const StopCondition& stop = {}) const;

  /// A direction out of a cell, towards one of its eight neighbours.
  struct Direction {
    Cell from;   ///< a cell of the map
    int dx = 0;  ///< -1 .. 1
    int dy = 0;  ///< -1 .. 1, not both 0
    friend bool operator==(const Direction&, const Direction&) = default;
  };

  /// Local planning in a world that changes (lecture, local planning): a planner whose ants are
  /// kept out of the directions in which a sensor reports an obstacle that the map does not have.
  /// The neighbour there counts as blocked, for the polish and for reachability too, until no
  /// direction to it is excluded any more. Costs what `edited` does; this planner stays as it is,
  /// so plans under way end in the world that they began in. Empty only if stopped.
  /// @throws Error(invalid_parameter) for a cell outside the map or a step that is no direction.
  [[nodiscard]] std::optional<Planner> exclude(std::span<const Direction> reported,
                                               const StopCondition& stop = {}) const;
  /// The same without these directions: the sensor has stopped reporting them. Those that were not
  /// excluded are ignored.
  [[nodiscard]] std::optional<Planner> allow(std::span<const Direction> gone,
                                             const StopCondition& stop = {}) const;
  /// What is excluded now, in the order in which it was reported.
  std::span<const Direction> excluded() const noexcept;

  /// Where nothing is prepared, `exact` makes the visibility graph for itself once so many plans
  /// of a point were asked for, without deadline, target gap or observer, that it pays: within one
  /// of these calls, on its thread. No answer depends on it: the graph answers where the shortest
  /// path is the only one, bit for bit as without. It holds at most 128 MiB, and 36 bytes a vertex
  /// in each Workspace; this sets another limit, of all copies of this planner; 0: none is made or
  /// asked. From any thread. Planners made by edited, exclude and allow begin anew.
  void limit_own_graph(std::int64_t max_bytes) noexcept;

  /// What came of the visibility graph that was asked for.
  const Preparation& preparation() const noexcept;
  /// Writes the visibility graph and its labels, if any, to a file, with the map's hash; under a
  /// temporary name first. @throws Error(output_failed); Error(invalid_parameter) where nothing is
  /// prepared, or for a disc's.
  void save_preparation(const std::string& file) const;
  /// A planner for the same map with what such a file holds; this one stays as it is. Checks that
  /// the file is whole. @throws Error(file_missing); Error(file_broken) where it is not of this
  /// map, damaged, or of another version; Error(invalid_parameter) for a disc.
  Planner load_preparation(const std::string& file) const;

  /// Pieces of free space, as paths under a rule can go: 4-connected, with Corners::allow
  /// 8-connected. Labels these first, see `label`.
  std::int64_t components(Corners corners = Corners::forbid) const;

  /// Memory held, in bytes, by part.
  struct Footprint {
    std::int64_t bitmap = 0;            ///< one bit per cell and the border
    std::int64_t components = 0;        ///< as labelled so far
    std::int64_t visibility_graph = 0;  ///< with labels, or a planner's own; 0: none
    std::int64_t disc = 0;              ///< the map before it grew, a disc's free space, and
                                        ///< what widest_disc() keeps
  };
  Footprint footprint() const noexcept;  ///< now

  class Impl;

 private:
  friend class CostPlanner;
  friend struct PlannerParts;  // internal
  explicit Planner(std::shared_ptr<const Impl> impl);
  static std::optional<Planner> if_made(std::shared_ptr<const Impl> impl);
  std::shared_ptr<const Impl> impl_;
};

}  // namespace lasius
