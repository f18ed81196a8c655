// One question about a map, answered by any algorithm.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/poller.h"
#include "core/cost/terrain.h"
#include "core/disc/disc_graph.h"
#include "core/disc/disc_space.h"
#include "core/exact/corner_graph.h"
#include "core/exact/labels/corner_labels.h"
#include "core/grid/nearest_free.h"
#include "core/plan/own_graph.h"
#include "core/plan/stale_answers.h"
#include "lasius/plan/planner.h"

namespace lasius {

/// A map before it grew by a disc's radius, and where `exact` may go on it.
struct DiscMap {
  double radius;
  std::optional<disc::DiscSpace> space = {};  ///< nothing for a radius that there is none for
  std::optional<Grid> alone = {};             ///< the map, where no space holds it

  const Grid& map() const noexcept { return space ? space->map() : *alone; }
};

/// Where `exact` may go with a disc; null for a point, and a radius that it does not serve.
inline const disc::DiscSpace* space_of(const DiscMap* disc) noexcept {
  return disc != nullptr && disc->space ? &*disc->space : nullptr;
}

/// A map, and what its owner knows about it.
struct PlanningMap {
  const Grid& grid;  ///< where `disc` is given, the cells that its centre may walk on
  const exact::CornerGraph* graph = nullptr;    ///< of `grid`; null if not prepared
  const exact::CornerLabels* labels = nullptr;  ///< of `graph`; null if there are none
  /// Are two free cells joined under a rule? Nothing if stopped.
  std::function<std::optional<bool>(Cell, Cell, Corners)> connected;
  /// Searches between the centres of two cells in the owner's way: a colony (empty: a new one a
  /// question, run_colony()) or, over costs, `exact`.
  std::function<Result(const Request&, const Observer&)> search = {};
  const DiscMap* disc = nullptr;  ///< what is planned on for a disc; null: a point's is `grid`
  const disc::DiscGraph* disc_graph = nullptr;  ///< of that; null if not prepared
  const cost::Terrain* terrain = nullptr;       ///< of a search over costs; of a colony's, too
  const StaleAnswers* stale = nullptr;          ///< of an older map; null if there are none
  bool from_file = false;                       ///< the graph: its edges are not proven here
  OwnGraph* own = nullptr;  ///< asked by `exact` first where `graph` is null; null: none is made
  /// The path is walked over cells: a disc that stands too near is refused and not led out, and a
  /// goal's tolerance leads to the centre of a cell.
  bool walked = false;
};

/// What Planner::plan answers, and throws.
Result answer(const PlanningMap& map, const Request& request, const Params& params,
              const PlanOptions& options);

/// Why a start or goal is invalid, and a sentence that names it. Precondition: it is blocked, or
/// what else makes it useless, or outside the map. `name`: of what is told of, if not the cell's.
std::pair<Fault, std::string> fault_of_end(const Grid& grid, bool at_start, Cell cell,
                                           const std::string& what = "blocked",
                                           const std::string& name = {});

/// Looks for the free cell nearest to a start or goal that is invalid, and for the nearest of those
/// that are joined to the other end; `joined` is empty where that is bad too. False when stopped.
template <class SomeResult>
bool find_nearest(SomeResult& result, const Grid& grid, Cell cell, const std::stop_token& token,
                  const std::function<bool(Cell)>& joined) {
  const StopCondition no_deadline{.token = token};  // it is named whatever the deadline
  Poller poller(no_deadline);
  const auto free = result.nearest_free = nearest_free(grid, Spot{cell}, poller);
  if (free && joined)
    result.nearest_reachable =
        joined(*free) ? free : nearest_free(grid, Spot{cell}, poller, joined);
  return !poller.stopped();
}
/// @throws Error(invalid_parameter) for a radius that the algorithm does not serve.
void check_serves(const Algorithm& algorithm, Disc robot);

/// The rule of corners that paths obey: any-angle paths never squeeze, and with 4 neighbours no
/// corner is ever passed. A disc's radius decides for it.
Corners corners_of_paths(const Params& params, Disc robot);
/// That of moves from cell to cell, `asked` for a point.
Corners corners_of(Corners asked, Disc robot) noexcept;

/// A cell in messages.
inline std::string cell_name(Cell c) { return pair_text(c.x, c.y); }

}  // namespace lasius
