// Planning on a bitmap: prepare a map once, then plan on it from as many threads as you like.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lasius/export.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/params.h"
#include "lasius/stop.h"

namespace lasius {

/// How a plan ended: outcomes, not errors.
enum class Status {
  solved,       ///< the algorithm ended by its own rule, with a path
  limit,        ///< the deadline ended it; the best path so far, if any
  interrupted,  ///< the stop token ended it; the best path so far, if any
  unreachable,  ///< proven: no path exists
  no_path,      ///< its iterations ended without a path
  invalid,      ///< start or goal outside or blocked
};
LASIUS_EXPORT std::string_view to_string(Status status) noexcept;

/// One question.
struct Request {
  Cell start;
  Cell goal;
  StopCondition stop = {};
  /// Stop at this certified gap, as a fraction, 0 or more; for certifying algorithms.
  double target_gap = 0;
};

/// One answer. Without a path `path` is empty and `length` is not a number.
struct LASIUS_EXPORT Result {
  Status status = Status::no_path;
  std::string error;         ///< why the status is invalid or unreachable; else empty
  std::vector<Point> path;   ///< start and goal at cell centres; one point where they are the same
  double length;             ///< in cells
  int iterations = 0;        ///< iterations done
  std::vector<double> best;  ///< by iteration: shortest final path up to then; NaN if none
  std::vector<double> mean;  ///< by iteration: mean raw tour of the arrived ants; NaN if none
  std::vector<int> arrived;  ///< by iteration: ants that reached the goal
  std::optional<double> lower_bound;  ///< certified: no path is shorter
  /// Certified (length - lower_bound) / lower_bound; 0 at length 0; nothing where not certified.
  std::optional<double> gap() const;
  bool optimal = false;  ///< proven shortest

  Result();
};

/// What an observer may look at, between two iterations, on the calling thread. `exact` has none;
/// to `grid-ga` ants are its individuals, and there is no pheromone (0). @throws std::out_of_range
/// for an ant that is none.
class LASIUS_EXPORT Progress {
 public:
  virtual ~Progress();
  int iteration = 0;       ///< from 0
  double best_length = 0;  ///< NaN if none yet
  double mean_length = 0;  ///< NaN if none arrived
  int arrived = 0;
  virtual int ants() const = 0;
  /// The tour of one ant, start to goal; empty if it did not arrive.
  virtual std::vector<Cell> tour(int ant) const = 0;
  /// The way that one ant had taken when it ended, arrived or stuck.
  virtual std::vector<Cell> walk(int ant) const { return tour(ant); }
  /// Pheromone on a cell of the map.
  virtual double pheromone(Cell c) const = 0;
};
using Observer = std::function<void(const Progress&)>;

/// Scratch memory of one call in flight. Keep one per thread: with it, `exact` and every colony
/// allocate nothing but the result in a second call of the same size. A call without one gives its
/// memory back before it returns, past a deadline, too: a tenth of a second for each gigabyte that
/// ants have touched. A call that threw leaves nothing in it that a later one sees.
class LASIUS_EXPORT Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;
  class Impl;
  Impl& impl() noexcept { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// How much `exact` may prepare of a map before its first question.
struct PrepareOptions {
  int threads = 0;  ///< at most 1024; 0: as many as OpenMP gives; never changes what is prepared
  /// Preparation that would hold more is given up. A Workspace takes 32 bytes more for each corner.
  std::int64_t max_bytes = std::int64_t{1} << 30;
  StopCondition stop = {};
};

/// What came of it.
struct Preparation {
  enum class State {
    none,       ///< not asked for, or gone with an edit
    ready,      ///< `exact` plans on it
    too_large,  ///< given up: it would take more than max_bytes
    stopped,    ///< given up: the stop condition said so
  };
  State state = State::none;
  std::int64_t corners = 0;  ///< at which a path may bend; 0 if stopped before they were counted
  std::int64_t edges = 0;    ///< from corner to corner in sight, if ready
  std::int64_t bytes = 0;    ///< held, if ready
  double seconds = 0;        ///< spent
};
LASIUS_EXPORT std::string_view to_string(Preparation::State) noexcept;

/// A map made ready for planning. Immutable: use one from many threads, a Workspace each. After a
/// move only assignment and destruction are left.
class LASIUS_EXPORT Planner {
 public:
  explicit Planner(Grid grid);
  /// Prepares more for `exact`: every corner learns which corners it sees, so that queries scan
  /// from start and goal only. Answers are as short and as certain as without, where several paths
  /// are shortest perhaps another one. Given up, it plans as without; the stop condition is asked
  /// about this alone. Planners made from this one by edited, exclude and allow are not prepared.
  /// @throws Error(invalid_parameter) where the number of threads is out of range.
  Planner(Grid grid, const PrepareOptions& options);
  /// As the constructors, for those who may have to stop: nothing when the condition said so while
  /// components were labelled. `grid` is moved from only where a planner comes of it.
  [[nodiscard]] static std::optional<Planner> prepare(Grid&& grid, const StopCondition& stop);
  [[nodiscard]] static std::optional<Planner> prepare(Grid&& grid, const PrepareOptions& options);
  /// A planner for the same map with more prepared for `exact`, as by the constructor. Copies the
  /// bitmap and its components; this one stays as it is.
  Planner prepared(const PrepareOptions& options) const;
  ~Planner();
  Planner(const Planner&) noexcept;  ///< copies share the map
  Planner& operator=(const Planner&) noexcept;
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  const Grid& grid() const noexcept;

  /// Labels the components under a rule, if that is still to do; else the first plan that asks for
  /// them does, on its own time. False when stopped.
  bool label(Corners corners, const StopCondition& stop = {}) const;

  /// True when the cells are joined under the rule (4-connected for forbid and one_side,
  /// 8-connected for allow). No work that grows with the map once the rule is labelled.
  bool connected(Cell a, Cell b, Corners corners = Corners::forbid) const;

  /// The free cell nearest to `c` (Euclidean, ties to the smaller row, then column), if there is
  /// one.
  std::optional<Cell> nearest_free(Cell c) const;

  /// Answers one question.
  /// Deterministic in (grid, request, params); threads and CPU never change the answer, a deadline
  /// or token may. An unreachable goal is proven before any search.
  /// @throws Error(invalid_parameter) for parameters or a target gap out of range, and from a
  /// colony where the environment's LASIUS_KERNELS names no kernels that this CPU has; what the
  /// observer throws. Start or goal outside or blocked is an answer, not an exception:
  /// Status::invalid.
  Result plan(const Request& request, const Params& params = {}, Workspace* workspace = nullptr,
              const Observer& observer = {}) const;

  /// A planner for the map with some cells changed; this one stays as it is. Copies the bitmap
  /// (one bit a cell) and prepares only the tiles around changed cells again. What is excluded
  /// stays excluded.
  struct Edit {
    Cell cell;
    bool blocked = true;
  };
  Planner edited(std::span<const Edit> edits) const;
  /// The same, or nothing when the condition said so while tiles were prepared; the bitmap's copy
  /// is not cut short. So with a condition below.
  [[nodiscard]] std::optional<Planner> edited(std::span<const Edit> edits,
                                              const StopCondition& stop) const;

  /// A direction out of a cell, towards one of its eight neighbours.
  struct Direction {
    Cell from;
    int dx = 0;  ///< -1 .. 1
    int dy = 0;  ///< -1 .. 1, not both 0
    friend bool operator==(const Direction&, const Direction&) = default;
  };

  /// Local planning in a world that changes (lecture, local planning): a planner whose ants are
  /// kept out of the directions in which a sensor reports an obstacle that the map does not have.
  /// The neighbour there counts as blocked, for the polish and for reachability too, until no
  /// direction to it is excluded any more. Costs what `edited` does; this planner stays as it is,
  /// so plans under way end in the world that they began in.
  /// @throws Error(invalid_parameter) for a cell outside the map or a step that is no direction.
  Planner exclude(std::span<const Direction> reported) const;
  [[nodiscard]] std::optional<Planner> exclude(std::span<const Direction> reported,
                                               const StopCondition& stop) const;
  /// The same without these directions: the sensor has stopped reporting them. Those that were not
  /// excluded are ignored.
  Planner allow(std::span<const Direction> gone) const;
  [[nodiscard]] std::optional<Planner> allow(std::span<const Direction> gone,
                                             const StopCondition& stop) const;
  /// What is excluded now, in the order in which it was reported.
  std::span<const Direction> excluded() const noexcept;

  /// What the heavier preparation came to.
  const Preparation& preparation() const noexcept;

  /// Pieces of free space, as paths under a rule can go: 4-connected, with Corners::allow
  /// 8-connected, which are made when first asked for.
  std::int64_t components(Corners corners = Corners::forbid) const;

  /// Memory held, in bytes, by part.
  struct Footprint {
    std::int64_t bitmap = 0;
    std::int64_t components = 0;
    std::int64_t corners = 0;  ///< heavier preparation
  };
  Footprint footprint() const noexcept;

  class Impl;

 private:
  explicit Planner(std::shared_ptr<const Impl> impl);
  static std::optional<Planner> if_made(std::shared_ptr<const Impl> impl);
  std::shared_ptr<const Impl> impl_;
};

}  // namespace lasius
