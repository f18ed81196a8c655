// Planning over costs on a bitmap: make a planner of a map and its costs once, then plan from as
// many threads as you like.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "lasius/cost/field.h"
#include "lasius/cost/proof.h"
#include "lasius/export.h"
#include "lasius/grid/moves.h"
#include "lasius/plan/planner.h"
#include "lasius/plan/progress.h"
#include "lasius/plan/request.h"
#include "lasius/plan/result.h"

namespace lasius {

/// One answer. `length` is the path's length; `lower_bound` and `optimal` are about its cost.
struct CostResult : Result {
  double cost = std::numeric_limits<double>::quiet_NaN();  ///< NaN without a path
  /// Certified (cost - lower_bound) / lower_bound; 0 at cost 0; nothing where there is no path or
  /// no bound above 0.
  LASIUS_EXPORT std::optional<double> gap() const;
  /// What proves `lower_bound`, where CostOptions::proof asks for it and there is a path; it takes
  /// about as much memory as the search. Null otherwise.
  std::shared_ptr<const CostProof> proof;
};

/// How to plan, and which paths there are.
struct CostOptions {
  /// Of `exact`, or a colony: then costs take the place of lengths in its deposits, its best and
  /// mean and its polish, the heuristic has the factor least weight / weight of the cell that a
  /// move leads to, and nothing is certified. Corners::allow is refused, and grid-ga.
  Params params = {};
  Workspace* workspace = nullptr;  ///< as PlanOptions::workspace, of a colony
  /// Called with every cheaper path, of a colony once an iteration; its best_length is a cost.
  Observer observer = {};
  OwnRules own_rules = {};  ///< of a colony, see OwnRules; its lengths are costs
  /// Only walks by eight moves from centre to centre, for comparison with other planners;
  /// `lower_bound` and `optimal` are about these. Not of a disc.
  bool eight_moves = false;
  Corners corners = Corners::forbid;  ///< of eight moves; Corners::allow is refused
  /// Ask for CostResult::proof; not of eight moves or a disc. It is of centres of cells, and of
  /// equal weights its bound is a little less than the answer's.
  bool proof = false;
};

/// Finds the cheapest path over costs, of any angle, within a gap that it proves. Immutable; copies
/// share what they hold: 8 bytes a cell, for a disc 16. A call takes 18 bytes a cell, and in the
/// cells where a cheapest path may be, half of the map on long ways, 95 more.
///
/// For a disc the bound is that of the cells where its centre may be at some point. Mostly their
/// cheapest path keeps the radius, since costs are high near what is blocked; where it does not,
/// the path is the cheapest one found that does, over the cells whose centres keep it, those all of
/// whose points do, and the shortest curve: never nearer than the radius, its gap proven, but not
/// always small. One that begins or ends beside the centres of cells, led out or within a goal
/// tolerance, is the shortest path.
class LASIUS_EXPORT CostPlanner {
 public:
  /// @throws Error(invalid_parameter) where the costs are for a map of another size, or the planner
  /// is for a disc whose radius `exact` does not serve.
  CostPlanner(Planner planner, const CostField& costs);
  ~CostPlanner();
  CostPlanner(const CostPlanner&) noexcept;
  CostPlanner& operator=(const CostPlanner&) noexcept;
  CostPlanner(CostPlanner&&) noexcept;
  CostPlanner& operator=(CostPlanner&&) noexcept;

  const Planner& planner() const noexcept;  ///< of the map
  /// Of the free cells (1 where none is): no path costs less than its length times this.
  double least_weight() const noexcept;

  /// Answers one request, deterministic as Planner::plan. Of any angle: a path soon, then better
  /// ones and higher bounds, to Request::target_gap, or where that is 0 to about 0.03%
  /// (Status::solved). Where all free cells have one weight, the answer is that of
  /// Planner::plan's `exact`. Between other points than centres a proof is searched for after the
  /// plan, which it does not change, in half of the time to a deadline; a colony and eight moves
  /// plan between centres, the first and last piece put in place, and what an observer sees begins
  /// there. Request::via as of Planner::plan, and without a proof. @throws as Planner::plan; for
  /// options that do not go together.
  CostResult plan(const Request& request, const CostOptions& options = {}) const;

 private:
  struct Impl;
  CostResult plan_through(const Request& asked, const CostOptions& options) const;
  CostResult plan_cells(const Request& request, const CostOptions& options) const;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace lasius
