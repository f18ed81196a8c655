// Parameters of every algorithm: plain data, one struct, presets named after their papers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lasius/export.h"
#include "lasius/grid.h"

namespace lasius {

/// What is done with a path before it is offered as the answer.
enum class Polish {
  none,      ///< the walk as it is
  straight,  ///< straighten()
  taut,      ///< straighten(), then tauten()
};

/// What an ant does when every way on is closed.
enum class DeadEnd {
  backtrack,  ///< step back; the cell stays tabu for this ant, the tour is what is left
  kill,       ///< the ant dies without a tour
};

/// Which straightened paths of fan2004 get pheromone too (Fan et al. 2004, step 3).
enum class StraightDeposit { none, improving, all };

/// The part of a move's weight that depends on where it leads, and never on the iteration.
enum class Heuristic {
  uniform,            ///< 1
  rescaled_distance,  ///< ((Dmax - d(j, E)) omega + mu)^lambda (Fan et al. 2004, eq. 4)
  inverse_distance,   ///< (1 / d(j, E))^beta, d at least half a cell
};

/// The part of a move's weight that depends on the move alone.
enum class Visibility {
  none,          ///< 1
  inverse_step,  ///< (1 / length of the move)^beta (Fan et al. 2004, eq. 1)
};

/// What carries pheromone.
enum class Trail {
  cells,  ///< tau of a move is that of the cell it leads to
  arcs,   ///< each move out of each cell has its own tau, in the direction walked
};

/// Parameters of one plan. Fields that an algorithm does not use are ignored by it; its own list,
/// with ranges, is in `algorithms()`, its published values in `defaults()`.
struct Params {
  std::string algorithm = "fan2004";
  std::uint64_t seed = 1;  ///< at most 2^53 - 1
  int threads = 0;         ///< 0: as many as OpenMP gives; never changes the answer

  int ants = 10;         ///< m
  int iterations = 120;  ///< T
  int neighbours = 4;    ///< 4 or 8
  Corners corners = Corners::forbid;
  Polish polish = Polish::straight;
  DeadEnd dead_end = DeadEnd::backtrack;

  // Random proportional rule: weight of a move = tau^alpha * visibility * heuristic.
  Trail trail = Trail::cells;
  Heuristic heuristic = Heuristic::rescaled_distance;
  Visibility visibility = Visibility::inverse_step;
  double alpha = 4;   ///< exponent of pheromone
  double beta = 1.5;  ///< exponent of visibility and of inverse_distance
  // Time-varying exponents (Fan et al. 2004, eq. 5, 6): linear from the value at iteration 0 to
  // alpha and beta at iteration `critical_time`, constant after it.
  int critical_time = 10;  ///< mc; 0: constant from the start
  double alpha_first = 0;
  double beta_first = 3;

  // Rescaled distance (Fan et al. 2004, eq. 4).
  double omega = 10;
  double mu = 2;
  double lambda = 2;

  // Roulette between the rules (Fan et al. 2004, note 4): shares at iteration 0 and from
  // `critical_time` on, linear between. Only their ratios count.
  double pheromone_rule_first = 0, pheromone_rule = 0.1;
  double distance_rule_first = 1, distance_rule = 0.1;
  double combined_rule_first = 0, combined_rule = 0.8;

  // Update: tau <- persistence * tau + sum of deposit / L over the arrived ants.
  double persistence = 0.7;      ///< share of pheromone that remains after an iteration
  double initial_pheromone = 1;  ///< tau0
  double deposit = 100;          ///< Q
  StraightDeposit straight_deposit = StraightDeposit::all;

  // The genetic algorithm. An iteration is a generation.
  int population = 50;
  double crossover = 1;    ///< probability that two parents cross
  double mutation = 0.05;  ///< probability that a child gets a new way to the goal
};

/// One parameter of an algorithm, as `lasius algorithms` lists it.
struct Parameter {
  std::string_view name;
  std::string_view type;   ///< "integer", "number" or "choice"
  std::string_view range;  ///< "1 .. 1000000", "a|b|c"
  std::string_view summary;
};

/// One algorithm: its name, where it comes from, what it reads of Params.
struct Algorithm {
  std::string_view name;
  std::string_view summary;
  std::string_view source;  ///< citation
  std::span<const Parameter> parameters;
};

/// All algorithms, the default first.
LASIUS_EXPORT std::span<const Algorithm> algorithms() noexcept;

/// The published defaults of an algorithm. @throws Error(invalid_parameter) for an unknown name,
/// with the nearest known one.
LASIUS_EXPORT Params defaults(std::string_view algorithm);

/// Sets or gets one parameter by the name in `algorithms()`; numbers round-trip.
/// @throws Error(invalid_parameter) for an unknown name (with the nearest), value or range.
LASIUS_EXPORT void set_parameter(Params& params, std::string_view name, std::string_view value);
LASIUS_EXPORT std::string get_parameter(const Params& params, std::string_view name);

/// @throws Error(invalid_parameter) for the first field out of range or that does not compose.
LASIUS_EXPORT void validate(const Params& params);

}  // namespace lasius
