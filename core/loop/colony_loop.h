// The one loop that every ant algorithm runs, on a bitmap, among polygons or in a lattice.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/special_values.h"
#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/plan/search_result.h"

namespace lasius {

/// A world as the loop sees it: where ants walk, what a tour is, what carries pheromone.
class ColonyWorld {
 public:
  virtual ~ColonyWorld() = default;

  /// Sends all ants of iteration q, measures their tours and makes paths of them: all that may take
  /// long, so all that polls. Other than `none` when it was cut short: then some ants count as
  /// lost, and a trail that another run goes on with is what it was before.
  virtual StopCondition::Cause send_ants(int q) = 0;
  /// Offers what the ants of a whole iteration found as the best path so far.
  virtual void offer() = 0;
  /// Offers what the ants of an iteration found that was cut short: to the result alone, where
  /// another run goes on from here.
  virtual void offer_cut() { offer(); }
  /// The world's rule: changes the trail by what the ants of a whole iteration found. Polls
  /// nowhere: its work is bounded by what the ants have walked.
  virtual void update_trail(int q) = 0;

  virtual int ants() const = 0;
  /// Threads that stand by for its parallel loops.
  virtual int threads() const { return 1; }
  /// Length of an ant's raw tour, NaN unless it arrived.
  virtual double tour_length(int ant) const = 0;
  /// What an ant walked: the length of its tour after the cut, NaN unless it arrived, its moves,
  /// backward ones too, the cells of its raw tour and those near the straight line. Only of worlds
  /// whose runs record that.
  struct Walked {
    double cut_length;
    std::int64_t steps;
    std::int64_t cells;
    std::int64_t near;
  };
  virtual std::optional<Walked> walked(int) const { return std::nullopt; }
  /// How open the trail leaves the choice; see Convergence.
  virtual double trail_entropy() const { return kNaN; }
  /// Length of the best path so far, NaN without one.
  virtual double best_length() const = 0;
  /// Length of the shortest path that this iteration offered, NaN without one. Only of worlds whose
  /// runs record that.
  virtual double iteration_best() const { return kNaN; }

  /// True when another iteration is of no use. Asked once after each, when it was observed, of
  /// islands before, from any thread; to find out may take long, and poll.
  virtual bool settled() { return false; }
  /// Called after every iteration, its record the last of `run`. Has an observer asked to stop?
  virtual StopCondition::Cause observe(const Convergence& run) = 0;
};

/// What the ants of an iteration walked and what came of it: adds up over parts of a colony.
struct IterationSums {
  /// Those that are numbers.
  struct Values {
    double sum = 0, least = kNaN;
    int count = 0;

    static Values of(double value);
    void add(const Values& more);
    double mean() const { return count > 0 ? sum / count : kNaN; }
  };
  Values raw, cut, entropies;  ///< lengths of raw and cut tours, entropies of trails
  double best = kNaN, iteration_best = kNaN;
  std::int64_t steps = 0, cells = 0, near = 0;
  bool walked = false;  ///< is ColonyWorld::walked() recorded?

  void add(const IterationSums& more);
};
IterationSums sums_of(const ColonyWorld& world);
/// Another part's iterations to those of one: whichever has ended first keeps its best.
void add_part(std::vector<IterationSums>& to, std::span<const IterationSums> part);
/// The iteration after the last of `run`.
void record(const IterationSums& sums, Convergence& run);

/// The main loop: send the ants, offer, update the trail, record, observe, up to `iterations`
/// times. Returns why it was cut short, or `none`.
///
/// An iteration is whole or nothing. Once all ants are back it is offered, updated and recorded
/// before anything polls; one that was cut short leaves no record and no trail, though what its
/// ants found is offered. Whoever asks to stop in the last iteration, or in one that settles, comes
/// too late: the search has ended by itself. Exported for the components; not a public header.
LASIUS_EXPORT StopCondition::Cause run_colony_loop(ColonyWorld& world, int iterations,
                                                   const StopCondition& stop, Convergence& run);

}  // namespace lasius
