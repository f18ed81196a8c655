// What a colony on a bitmap learns by: pheromone, a terminal index, or an update of the caller's.
#pragma once

#include <algorithm>
#include <span>

#include "core/base/special_values.h"
#include "core/colony/colony_memory.h"
#include "core/colony/own_update.h"
#include "core/colony/stored_pheromone.h"
#include "core/colony/terminal_index.h"
#include "core/colony/tour_measures.h"
#include "core/colony/update.h"
#include "core/grid/cell_distance.h"
#include "lasius/params/schedule.h"
#include "lasius/plan/request.h"

namespace lasius {

/// The trail in a colony's memory: what ants draw by and teach, and what a change of the map leaves
/// of it. Which of the three models it is, is asked here alone.
class TrailModel {
 public:
  /// `own`, checked, may take the place of some rules. `kept`: other runs go on with the trail. All
  /// outlive the object.
  TrailModel(const Grid& grid, const Params& params, const OwnRules& own, bool kept,
             const kernels::Moves& moves, ColonyMemory& memory)
      : grid_(grid),
        params_(params),
        own_(own),
        kept_(kept),
        moves_(moves),
        memory_(memory),
        kind_(own.update                                ? Kind::callers
              : params.update == Update::terminal_index ? Kind::terminal_index
                                                        : Kind::pheromone) {}

  /// Is the answer read from what the ants taught? Else it is the best of their paths.
  bool answers() const noexcept { return kind_ == Kind::terminal_index; }
  /// May learn() be called on any thread, while the walks become paths? Not where an iteration that
  /// is cut short then has to leave no trail.
  bool learns_aside() const noexcept { return kind_ != Kind::callers && !kept_; }
  /// Has the caller's update asked for the end?
  bool stopped() const noexcept { return stopped_; }

  /// Makes it blank; the request's stop condition may leave it in pieces.
  void begin(const Request& request, const TourMeasure& measure) {
    goal_ = request.goal;
    level_ = 0;
    tau0_ = initial_pheromone(params_, measure.least(distance(request.start, goal_)));
    // The terminal index of unknown cells grows with the map.
    const double unknown = params_.unknown_index * std::max(grid_.width(), grid_.height()) / 20;
    memory_.field.reset(grid_, moves_, goal_, params_, answers() ? unknown : tau0_, request.stop,
                        own_.heuristic, measure.terrain());
  }

  /// The weights of an iteration that begins, by the caller's own schedule where there is one.
  StepWeights begin_iteration(int iteration) {
    memory_.earlier.clear();
    return own_.schedule ? own_weights(own_, params_, iteration) : schedule(params_, iteration);
  }
  /// The local update after a batch.
  void pass(const Tours& batch) {
    update_locally(memory_.field, params_, tau0_, batch, kept_ ? &memory_.earlier : nullptr);
  }
  /// Makes a trail that is kept what it was before an iteration that was cut short, to the bit.
  void take_back() {
    for (auto last = memory_.earlier.rbegin(); last != memory_.earlier.rend(); ++last)
      memory_.field.set_tau(last->place, last->tau);
    memory_.earlier.clear();
  }

  /// The paper's update by the walks of a whole iteration.
  void learn(const Tours& walks) {
    if (kind_ != Kind::callers) update_trail(memory_.field, params_, walks);
  }
  /// Once these are paths: the update that takes the place of the paper's, on the caller's thread,
  /// and what straight paths lay. `finder`: the ant that found the best one, -1 being none.
  void learn_from_paths(const Tours& walks, std::span<const Ant> ants,
                        std::span<const PolishedPath> paths, int finder) {
    if (kind_ == Kind::callers) {
      IterationTours view = memory_.numbered.view(walks, grid_, params_.trail);
      view.goal = goal_;
      StoredPheromone stored(memory_.field, grid_, params_, moves_.count);
      stopped_ = own_.update(stored.pheromone, view) == Go::stop;
    }
    lay_straight_paths(memory_.field, params_, ants, paths, finder);
  }
  /// How open it leaves the choice along the best tour; see Convergence::trail_entropy.
  double entropy(Cell start) const {
    if (answers()) return kNaN;
    return trail_entropy(memory_.field, params_.trail, moves_, start, memory_.best.moves());
  }

  /// Fits it to cells that have changed. Beside an opening it becomes more alike, so that ants may
  /// leave it, and the best tour goes, which would renew it.
  void changed(const Rectangle& part, Cell start) {
    Field& field = memory_.field;
    field.edited(part);
    if (answers()) return forget_lost_ways(field, grid_, params_.corners, moves_, goal_, part);
    BestTour& best = memory_.best;
    if (!best.passed_by(grid_, start, goal_, part)) return;
    constexpr double kShare = 0.3;  // see docs/theory.md
    if (!best.none()) level_ = best.strongest(field, moves_, start);
    if (level_ > 0) field.equalise(part, std::max(part.width, part.height), kShare, level_);
    best.drop();
  }

 private:
  enum class Kind { pheromone, terminal_index, callers };

  const Grid& grid_;
  const Params& params_;
  const OwnRules& own_;
  bool kept_;
  const kernels::Moves& moves_;
  ColonyMemory& memory_;
  Kind kind_;
  bool stopped_ = false;
  Cell goal_;
  double tau0_ = 0;
  double level_ = 0;  // most tau on the best tour when it was last needed
};

}  // namespace lasius
