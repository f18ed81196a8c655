// Parameters of every algorithm: plain data, one struct, presets named after their papers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/base/enum_names.h"
#include "lasius/export.h"
#include "lasius/grid/moves.h"
#include "lasius/params/rules.h"

namespace lasius {

/// What is done with a walk before it is offered as the answer. `local` is the one that a paper
/// describes. `straight` and `taut` are ours: they cut loops inside the walk's cells first; and in
/// the end a shortcut takes the path's place where one is found: a shorter path that bends only at
/// corners of cells which the walk entered, those it left again included, or which the path goes
/// over.
enum class Polish {
  none,      ///< the walk as it is
  straight,  ///< straighten(): vertices are centres of cells
  taut,      ///< greedy_straighten(), then pull_taut(): vertices are corners
  local,     ///< greedy_straighten(), of which each pass replaces only stretches that stay within
             ///< `straight_window` of the segment (Fan et al. 2004, note 3)
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 4> kPolishNames{"none", "straight", "taut", "local"};
/// The name of a value.
constexpr std::string_view to_string(Polish v) noexcept { return name_of(v, kPolishNames); }

/// What is left of a walk before it is measured, deposited and offered.
enum class WalkCut {
  none,           ///< all of it, but for steps that were taken back
  own_cells,      ///< the shortest way over its own cells by the ant's moves
  entered_cells,  ///< the same over all cells that the ant entered, those it left again included
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 3> kWalkCutNames{"none", "own-cells",
                                                               "entered-cells"};
/// The name of a value.
constexpr std::string_view to_string(WalkCut v) noexcept { return name_of(v, kWalkCutNames); }

/// What an ant does when every way on is closed.
enum class DeadEnd {
  backtrack,  ///< step back; the cell stays tabu for this ant, the tour is what is left
  kill,       ///< the ant dies without a tour
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kDeadEndNames{"backtrack", "kill"};
/// The name of a value.
constexpr std::string_view to_string(DeadEnd v) noexcept { return name_of(v, kDeadEndNames); }

/// Which straightened paths get pheromone too (Fan et al. 2004, step 3).
enum class StraightDeposit { none, improving, all };
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 3> kStraightDepositNames{"none", "improving", "all"};
/// The name of a value.
constexpr std::string_view to_string(StraightDeposit v) noexcept {
  return name_of(v, kStraightDepositNames);
}

/// What carries pheromone.
enum class Trail {
  cells,  ///< tau of a move is that of the cell it leads to
  arcs,   ///< each move out of each cell has its own tau, in the direction walked
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kTrailNames{"cells", "arcs"};
/// The name of a value.
constexpr std::string_view to_string(Trail v) noexcept { return name_of(v, kTrailNames); }

/// How a move is drawn from the weights of its row.
enum class Selection {
  roulette,          ///< in proportion to the weights
  inverse_roulette,  ///< moves are discarded in proportion until one is left (Li, Wang & Ma)
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kSelectionNames{"roulette", "inverse-roulette"};
/// The name of a value.
constexpr std::string_view to_string(Selection v) noexcept { return name_of(v, kSelectionNames); }

/// Which move has "the largest gradient" that the terminal index's answer follows (Li, Wang & Ma):
/// j at distance s from c.
enum class IndexAnswer {
  least_way,  ///< least K(j) + s
  steepest,   ///< largest (K(c) - K(j)) / s
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kIndexAnswerNames{"least-way", "steepest"};
/// The name of a value.
constexpr std::string_view to_string(IndexAnswer v) noexcept {
  return name_of(v, kIndexAnswerNames);
}

/// When an island learns by a tour of the others.
enum class Exchange {
  scheduled,     ///< all at once, by that of the island before it: depends on their number alone
  asynchronous,  ///< by the best that has arrived by then: no thread and no rank waits for another,
                 ///< and where there are several no two runs need be equal
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kExchangeNames{"scheduled", "asynchronous"};
/// The name of a value.
constexpr std::string_view to_string(Exchange v) noexcept { return name_of(v, kExchangeNames); }

/// Cong & Ponnambalam 2009, eq. 3 is broken in print: which reading to take.
enum class Reward {
  factor,  ///< tau <- tau (1 + reward rows / L)
  affine,  ///< tau <- tau reward rows / L + 1
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kRewardNames{"factor", "affine"};
/// The name of a value.
constexpr std::string_view to_string(Reward v) noexcept { return name_of(v, kRewardNames); }

/// Whose numbers an algorithm starts with.
enum class Preset {
  usual,  ///< those that are right on maps; of a published system its own
  book,   ///< the textbook's (Dorigo & Stuetzle 2004, box 3.1), of those that has_preset() names
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 2> kPresetNames{"usual", "book"};
/// The name of a value.
constexpr std::string_view to_string(Preset v) noexcept { return name_of(v, kPresetNames); }

/// The numbers of the families' updates, in any world; a row of kUpdates says which of them its
/// update reads.
struct TrailParams {
  double persistence = 0.5;   ///< share of pheromone that remains, 0 .. 1; below 2^-60 as 2^-60
  double deposit = 1;         ///< Q, 0 .. 10^9
  double elite_weight = 0;    ///< e of Update::elitist, 0 .. 10^6
  int ranks = 6;              ///< w of Update::rank, at least 2
  int elite_ants = 1;         ///< ants that Update::best_share lets deposit
  int best_so_far_every = 0;  ///< Update::max_min: every how many iterations the best so far, not
                              ///< the iteration's best, deposits; 0: never
  double best_probability = 0.05;  ///< Update::max_min: p_best, which sets tau_min / tau_max
  double local_evaporation = 0;    ///< Update::colony_system: tau <- (1 - xi) tau + xi tau0
  friend bool operator==(const TrailParams&, const TrailParams&) = default;
};

/// Parameters of one plan. The constructor sets the published values of an algorithm, which
/// `algorithms()` lists with its parameters and their ranges; any of them may be changed. What the
/// algorithm does not read must stay as the constructor left it: see validate(). Each field begins
/// as the plainest there is: one, a factor or exponent of 1, what may be left out left out; the
/// number of a single rule (`ranks`, `omega`, `penalty`) as that rule's source has it.
struct LASIUS_EXPORT Params : TrailParams {
  Params() : Params("exact") {}
  /// @throws Error(invalid_parameter) for an unknown name, with the nearest known one, and for a
  /// preset that the algorithm does not have.
  explicit Params(std::string_view algorithm, Preset preset = Preset::usual);
  /// Its name. To ask another algorithm, make other Params: a name without its numbers is none.
  const std::string& algorithm() const noexcept { return algorithm_; }
  friend bool operator==(const Params&, const Params&) = default;

  std::uint64_t seed = 1;  ///< at most 2^53 - 1
  int threads = 0;         ///< at most 1024; 0: as many as OpenMP gives; never changes the answer,
                           ///< but with Exchange::asynchronous

  int ants = 1;                              ///< m, 1 .. 10^6, of all islands together
  int iterations = 1;                        ///< T, 0 .. 10^9
  Neighbours neighbours = Neighbours::four;  ///< moves from a cell
  Corners corners = Corners::forbid;         ///< rule for diagonal steps past blocked cells
  Polish polish = Polish::none;              ///< what is done with each tour
  double straight_window = 10;               ///< D of Polish::local, cells, 0 .. 10^6
  DeadEnd dead_end = DeadEnd::backtrack;     ///< where every way on is closed
  WalkCut walk_cut = WalkCut::none;          ///< of every tour, before deposits

  // Random proportional rule: weight of a move = tau^alpha * visibility * heuristic.
  Selection selection = Selection::roulette;  ///< how a move is drawn
  Trail trail = Trail::cells;                 ///< what carries pheromone
  Heuristic heuristic = Heuristic::uniform;   ///< by where a move leads
  Visibility visibility = Visibility::none;   ///< by the move and the one before
  double alpha = 1;   ///< exponent of pheromone (of the terminal index), 0 .. 20
  double beta = 1;    ///< exponent of visibility and heuristic, 0 .. 20
  double greedy = 0;  ///< share of steps that take the largest weight, q0 (ACS), 0 .. 1
  // Time-varying exponents (Fan et al. 2004, eq. 5, 6): linear from the value at iteration 0 to
  // alpha and beta at iteration `critical_time`, constant after it.
  int critical_time = 0;   ///< mc; 0: constant from the start
  double alpha_first = 1;  ///< alpha at iteration 0
  double beta_first = 1;   ///< beta at iteration 0

  // Rescaled distance (Fan et al. 2004, eq. 4).
  double omega = 10;  ///< scale, per cell, 0 .. 10^6
  double mu = 2;      ///< offset, 10^-6 .. 10^6
  double lambda = 2;  ///< exponent, 0 .. 20

  // Roulette between the rules (Fan et al. 2004, note 4): shares at iteration 0 and from
  // `critical_time` on, linear between; that of the heuristic alone goes on to its last value at
  // `settling_time`. Each 0 .. 10^6; only their ratios count.
  double pheromone_rule_first = 0;  ///< by pheromone and visibility, at iteration 0
  double pheromone_rule = 0;        ///< the same from `critical_time` on
  double distance_rule_first = 0;   ///< by the heuristic alone, at iteration 0
  double distance_rule = 0;         ///< the same at `critical_time`
  double distance_rule_last = 0;    ///< the same from `settling_time` on
  int settling_time = 0;            ///< 0: the share at `critical_time` stays
  double combined_rule_first = 1;   ///< by the product of all, at iteration 0
  double combined_rule = 1;         ///< the same from `critical_time` on

  // Update: tau <- persistence * tau, then deposits. Its numbers are in TrailParams.
  Update update = Update::ant_system;  ///< how the trail changes
  /// tau0, up to 10^9. 0 stands for the formula of the update's source, see docs/theory.md: so no
  /// trail begins with 0.
  double initial_pheromone = 0;
  /// Polish::none makes no straight paths, and so implies StraightDeposit::none.
  StraightDeposit straight_deposit = StraightDeposit::none;
  int batch = 0;      ///< ants that walk before a local update; 0: all of them
  int agreement = 0;  ///< iterations in a row in which all ants took one way that end the run; 0:
                      ///< never. An ant alone agrees with nobody
  int islands = 1;    ///< 1 .. 1024, each with a share of the ants and a trail of its own; only
                      ///< without own rules, and where no map changes under a colony
  int exchange_every = 10;  ///< iterations after which an island learns by another's best tour:
                            ///< 1 .. 10^9
  Exchange exchange = Exchange::scheduled;  ///< when, and by which

  double unknown_index = 99;  ///< terminal index of a cell without one, on 20 x 20 cells
  double index_spread = 0.8;  ///< q of K'(c) = K(c) - q Kmin (Li, Wang & Ma, eq. 8)
  IndexAnswer index_answer = IndexAnswer::least_way;  ///< of "the largest gradient"

  double reward = 1.2;                     ///< Update::learning, on success
  Reward reward_reading = Reward::factor;  ///< of the formula broken in print
  double penalty = 0.5;  ///< Update::learning, factor on the second half of a dead end

  // The genetic algorithm. An iteration is a generation.
  int population = 50;     ///< paths of a generation
  double crossover = 1;    ///< probability that two parents cross
  double mutation = 0.05;  ///< probability that a child gets a new way to the goal

 private:
  std::string algorithm_;
};

/// One parameter of an algorithm, as `lasius algorithms` lists it.
struct Parameter {
  std::string_view name;                           ///< as set_parameter() takes it
  std::string_view type;                           ///< "integer", "number" or "choice"
  std::string_view summary;                        ///< a line
  std::span<const std::string_view> choices = {};  ///< of a choice: its values
  double least = 0;                                ///< of an integer or number, included
  double most = 0;                                 ///< likewise
  /// Its value in results that were saved before it was there; empty: it always was.
  std::string_view earlier = {};
  /// The settings of others with which it is read, as "update=rank"; empty: with all.
  std::string_view only_with = {};

  /// What it may be, as "1 .. 1000000" or "a|b|c".
  LASIUS_EXPORT std::string range() const;
  /// `least` or `most` as range() tells it.
  LASIUS_EXPORT std::string text_of(double end) const;
};

/// One algorithm: its name, where it comes from, what it reads of Params.
struct Algorithm {
  /// What runs it.
  enum class Kind {
    exact,    ///< no iterations; certifies its gap and proves its answer
    colony,   ///< iterations of ants
    genetic,  ///< iterations of a population
  };
  std::string_view name;                  ///< as Params takes it
  std::string_view summary;               ///< a line
  std::string_view source;                ///< citation
  std::span<const Parameter> parameters;  ///< that it reads
  Kind kind = Kind::colony;               ///< what runs it

  /// Does it read the parameter of this name? "evaporation" is another word for persistence.
  LASIUS_EXPORT bool has(std::string_view parameter) const noexcept;
};
/// The name, as in "colony".
LASIUS_EXPORT std::string_view to_string(Algorithm::Kind kind) noexcept;

/// All algorithms, the default first.
LASIUS_EXPORT std::span<const Algorithm> algorithms() noexcept;

/// One of them. @throws Error(invalid_parameter) for an unknown name, with the nearest known one.
LASIUS_EXPORT const Algorithm& find_algorithm(std::string_view name);

/// The rules of a colony in a line each, with what their symbols mean: weight of a move, choice,
/// update. Other words are parameters. Empty for others.
LASIUS_EXPORT std::vector<std::string> formulas(const Params& params);

/// Has the algorithm numbers of this preset? @throws as find_algorithm().
LASIUS_EXPORT bool has_preset(std::string_view algorithm, Preset preset);

/// Sets or gets one parameter by the name in `algorithms()`; numbers round-trip.
/// @throws Error(invalid_parameter) for an unknown name (with the nearest), value or range.
LASIUS_EXPORT void set_parameter(Params& params, std::string_view name, std::string_view value);
LASIUS_EXPORT std::string get_parameter(const Params& params, std::string_view name);

/// Why a run does not read a parameter, as "it is read only with update=rank" or "exact does not
/// read it"; empty where it does. Own rules may read others: beta, with an own heuristic.
/// @throws Error(invalid_parameter) for an unknown name.
LASIUS_EXPORT std::string why_unread(const Params& params, std::string_view name);

/// Sets every parameter that the algorithm has but its other settings leave unread to the usual
/// preset's value: the run is the same. For those who compare or list runs; not for parameters that
/// own rules read.
LASIUS_EXPORT void reset_unread(Params& params);

/// Checks every field. @throws Error(invalid_parameter) for the first one that is out of range,
/// does not go with another, or was changed although the algorithm does not read it. One that waits
/// for another setting (`ranks`, for Update::rank) may have any value: see why_unread().
LASIUS_EXPORT void validate(const Params& params);

}  // namespace lasius
