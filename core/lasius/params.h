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

/// How the visibility eta(j) of a move to cell j is made.
enum class Visibility {
  step,          ///< 1 / length of the move (Fan et al. 2004, eq. 1)
  inverse_goal,  ///< 1 / Euclidean distance from j to the goal
};

/// Which pheromone update follows an iteration.
enum class UpdateRule {
  ant_system,  ///< all evaporate, every arrived ant deposits Q / L (Dorigo et al. 1996)
};

/// Parameters of one plan. Fields that an algorithm does not use are ignored by it; its own list,
/// with ranges, is in `algorithms()`.
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

  // Random proportional rule: tau^alpha eta^beta.
  Visibility visibility = Visibility::step;
  double alpha = 1;
  double beta = 0;
  // Time-varying weights (Fan et al. 2004, eq. 5, 6): from the first value at iteration 0 linearly
  // to the last at `critical_time`, constant after it.
  double alpha_first = 0;
  double beta_first = 0;
  int critical_time = 0;  ///< mc; 0: constant weights

  // Distance rule (Fan et al. 2004, eq. 4): ((Dmax - d) omega + mu)^lambda.
  double omega = 10;
  double mu = 2;
  double lambda = 2;

  // Roulette between the rules, with a = min(1, q / mc): weight = first + (last - first) a.
  double pheromone_rule_first = 0, pheromone_rule_last = 0;
  double distance_rule_first = 0, distance_rule_last = 0;
  double combined_rule_first = 1, combined_rule_last = 1;

  // Update.
  UpdateRule update = UpdateRule::ant_system;
  double persistence = 0.7;      ///< share of pheromone that remains after an iteration
  double initial_pheromone = 1;  ///< tau0
  double deposit = 100;          ///< Q
  StraightDeposit straight_deposit = StraightDeposit::all;
};

/// One parameter of an algorithm, as `lasius algorithms` lists it.
struct Parameter {
  std::string_view name;
  std::string_view summary;
  std::string_view range;  ///< for people: "1 .. 1000000", "a|b|c"
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
