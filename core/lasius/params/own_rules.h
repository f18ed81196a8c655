// Rules of your own for a colony on a bitmap: heuristic values, update of the trail, schedule.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/moves.h"
#include "lasius/params/params.h"
#include "lasius/params/schedule.h"

namespace lasius {

class NumberedTours;  // internal, and so the next
class StoredPheromone;

/// What carries pheromone, or a cell, as a number. Cell (x, y) is y * width + x. With Trail::cells
/// a place is a cell; with Trail::arcs it is a move out of one: cell * moves + k, k the number of
/// the move in move_steps(), moves their count.
using TrailPlace = std::int64_t;

/// The moves of a neighbourhood as differences of cells, in their order: by rows, dy from -3 to 3,
/// in a row by dx. Of Neighbours::four: up, left, right, down.
LASIUS_EXPORT std::vector<Cell> move_steps(Neighbours neighbours);

/// What the ants of one iteration have found, for an update. The object holds until the update
/// returns, and so do its spans; those that were asked for by then hold for who keeps `memory`,
/// too. Nothing is copied for the call: the numbers of a tour's cells and moves are written when
/// they are first asked for, all of them for cells() and arcs(). It belongs to the thread that the
/// update is called on. Tours are those that the built-in updates see: after Params::walk_cut,
/// before polish.
struct LASIUS_EXPORT IterationTours {
  int iteration = 0;           ///< from 0
  int width = 0;               ///< of the map, in cells
  int height = 0;              ///< of the map, in cells
  int moves = 0;               ///< out of a cell, of the neighbourhood
  Trail trail = Trail::cells;  ///< what carries pheromone
  Cell start;                  ///< where tours begin
  Cell goal;                   ///< where those that arrived end

  /// One more than there are ants: ant a has cells()[offsets[a]] to cells()[offsets[a + 1] - 1].
  std::span<const std::int64_t> offsets;
  /// By ant: length of its tour, in cells; NaN unless it arrived.
  std::span<const double> lengths;
  /// The ants that arrived, shortest tour first, ties to the lower number.
  std::span<const int> ranked;
  /// Length of the shortest tour so far, this iteration's included; NaN before an ant has arrived.
  double best_length = std::numeric_limits<double>::quiet_NaN();

  /// What the spans show: while a copy of this pointer is kept, those that were asked for hold, and
  /// never change.
  std::shared_ptr<const void> memory;

  IterationTours& operator=(IterationTours&&) = delete;  // nor copied: see above

  /// Ants of the iteration.
  int ants() const noexcept { return static_cast<int>(lengths.size()); }
  /// Did it reach the goal? As the two below, for 0 <= ant < ants().
  bool arrived(int ant) const noexcept { return lengths[ant] > 0; }
  /// The cells of its tour, from the start on, no cell twice. Of an ant that did not arrive: the
  /// way it had taken when it was lost.
  std::span<const TrailPlace> cells_of(int ant) const noexcept;
  /// The places of its tour that carry pheromone: with Trail::cells its cells, the start's and the
  /// goal's too, with Trail::arcs its moves.
  std::span<const TrailPlace> places_of(int ant) const noexcept;

  /// The cells of all ants' tours, one tour after the other.
  std::span<const TrailPlace> cells() const noexcept;
  /// With Trail::arcs the moves between these cells, else empty: ant a has arcs()[offsets[a] - a]
  /// to arcs()[offsets[a + 1] - a - 2], one fewer than cells.
  std::span<const TrailPlace> arcs() const noexcept;

  /// The shortest tour so far; empty before an ant has arrived.
  std::span<const TrailPlace> best_cells() const noexcept;
  std::span<const TrailPlace> best_arcs() const noexcept;    ///< its moves as arcs() has them
  std::span<const TrailPlace> best_places() const noexcept;  ///< as places_of()

 private:
  friend class NumberedTours;
  explicit IterationTours(NumberedTours& tours) noexcept : tours_(&tours) {}
  IterationTours(IterationTours&&) = default;

  NumberedTours* tours_;
};

/// A part of the trail as it is stored, see Pheromone::tile().
struct TrailTile {
  Cell first;  ///< top left cell; the tile may reach beyond the map
  /// Pheromone::kTileSide rows of as many cells, of each cell one value, with arcs one per move, in
  /// units of Pheromone::scale().
  std::span<const float> stored;
};

/// The trail of a colony, tau, as an update changes it: by calls that take many places at once,
/// since tau is stored in tiles, one common factor apart, only where an ant has been. The built-in
/// updates change it by the same steps, so what computes the same gives the same path bit for bit.
///
/// Values are stored as 32-bit floats, at least 2^-100 in stored units: tau never becomes 0, and
/// where it would grow beyond 10^200 all of it is scaled down, since ants see ratios only. Calls
/// work through places in their order; a place that is given twice is changed twice. A call that
/// throws has changed nothing. An update is called for whole iterations alone, and none of its
/// calls is cut short: a request to stop is heeded once the iteration is recorded. The object holds
/// until the update returns, and belongs to the thread that the update is called on.
///
/// All calls that take places throw Error(invalid_parameter) for one out of range, and for spans of
/// different lengths.
class LASIUS_EXPORT Pheromone {
 public:
  static constexpr int kTileSide = 32;    ///< cells along a side of a tile
  static constexpr double kMost = 1e200;  ///< the largest number that a call takes

  Trail trail() const noexcept;          ///< what carries it
  std::int64_t places() const noexcept;  ///< those of the map: 0 .. places() - 1

  /// tau <- persistence * tau everywhere, in constant time; at least 2^-60 of it is kept.
  /// @throws Error(invalid_parameter) unless 0 <= persistence <= 1.
  void persist(double persistence);

  /// tau <- tau + amount at each place.
  /// @throws Error(invalid_parameter) too unless amount or values are 0 .. kMost.
  void add(std::span<const TrailPlace> places, double amount);
  void add(std::span<const TrailPlace> places,
           std::span<const double> values);  ///< one each

  /// tau <- value at each place. @throws as add.
  void set(std::span<const TrailPlace> places, std::span<const double> values);

  /// tau is read as at least `least` and at most `most` from now on, by ants, by add() and by
  /// get(), until another call; what is stored stays as it is. At first 0 and infinity.
  /// @throws Error(invalid_parameter) unless 0 <= least <= kMost, most > 0, least <= most.
  void clamp(double least, double most);

  /// Writes tau at each place.
  void get(std::span<const TrailPlace> places, std::span<double> values) const;

  /// What cells have taught the ants, eta of Heuristic::learned: 1 at first. Likewise.
  /// @throws Error(invalid_parameter) too where the heuristic is another one.
  void get_learned(std::span<const TrailPlace> cells, std::span<double> values) const;
  void set_learned(std::span<const TrailPlace> cells,
                   std::span<const double> values);  ///< likewise

  /// The trail as it is stored: tiles, in the order in which ants first came to them, which depends
  /// on threads where there are several; tau of all other places is untouched(). tau is the stored
  /// value times scale(), then within least() and most().
  int tiles() const noexcept;
  TrailTile tile(int number) const;   ///< 0 <= number < tiles(); holds until the next change
  double scale() const noexcept;      ///< of stored values; any change may change it
  double untouched() const noexcept;  ///< tau where nothing was ever changed
  double least() const noexcept;      ///< as clamp() has it
  double most() const noexcept;       ///< as clamp() has it

  Pheromone(const Pheromone&) = delete;
  Pheromone& operator=(const Pheromone&) = delete;

 private:
  friend class StoredPheromone;
  explicit Pheromone(StoredPheromone& stored) noexcept : stored_(stored) {}
  void check_learned() const;

  StoredPheromone& stored_;
};

/// What of a colony is the caller's own, beside any parameters: what is left empty is as
/// `Params` say. Only colonies on bitmaps take own rules.
///
/// A plan calls `schedule`, then after its ants `update`, once per iteration, on the thread that
/// called the planner and never two of one plan at a time; a batch calls them from its threads, for
/// several plans at a time. What they throw ends the plan and is thrown on.
///
/// The library's part stays deterministic: with functions that compute the same from the same
/// arguments, seed and parameters give the same path bit for bit, on any number of threads. That
/// they do is up to the caller; so a result found with own rules says so (Result::own_rules), and
/// cannot be replayed from what it holds.
struct OwnRules {
  /// The largest value of a heuristic.
  static constexpr double kMostHeuristic = 1e15;
  /// Values eta that take the place of Params::heuristic: a move's weight has the factor eta^beta.
  /// One per cell, of where a move leads, width x height in all, or one per place of Trail::arcs,
  /// width x height x moves; empty: none. From 0 to kMostHeuristic, less than 1 / kMostHeuristic
  /// counting as that, but for moves that do not exist; one that does weighs at least 2^-60 of the
  /// best beside it. Not copied: as it is until the plan ends. Looked through once per plan.
  std::span<const double> heuristic = {};

  /// Takes the place of Params::update once the ants of an iteration have walked. What else lays
  /// pheromone stays as Params have it, and can be turned off there: straight_deposit after it,
  /// local_evaporation of `acs` before. Go::stop ends the search after this iteration.
  Callback<Pheromone&, const IterationTours&> update = {};

  /// Takes the place of the schedule that Params give. The rules of pheromone and distance alone
  /// can only have a share where they have one in Params at some iteration.
  std::function<StepWeights(int iteration)> schedule = {};

  /// True where nothing is the caller's own.
  bool none() const noexcept { return heuristic.empty() && !update && !schedule; }
};

}  // namespace lasius
