// Ant colonies over stops: the published families in the problem that they were published for.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/export.h"
#include "lasius/params/params.h"

namespace lasius::tour {

/// What improves every ant's tour.
enum class Improvement {
  none,
  two_edges,    ///< exchanges of two edges along candidates, until none is cheaper
  three_edges,  ///< of up to three, as the usual search makes them
  /// Adjacent pieces of it change places (Gambardella & Dorigo 2000), along the 10 cheapest legs
  /// out of and into each stop; of symmetric costs one is also reversed. The start keeps its place.
  /// Of an order that is given in part, too.
  pieces,
};
inline constexpr std::string_view kImprovementNames[] = {"none", "two-edges", "three-edges",
                                                         "pieces"};

/// Where an ant goes with probability q0.
enum class GreedyStep {
  largest_weight,  ///< to the stop of largest weight
  /// On as the best tour so far does, where it can. Then tours of less than 1.2 times the length of
  /// that one alone are improved, and looked at only where they differ from it (Gambardella,
  /// Montemanni & Weyland 2012).
  as_best,
};
inline constexpr std::string_view kGreedyStepNames[] = {"largest-weight", "as-best"};

/// Parameters of a colony over stops. The constructor sets the book's (Dorigo & Stuetzle 2004, box
/// 3.1), without local search; any may be changed.
struct LASIUS_EXPORT AntParams : TrailParams {
  /// Those of `exact`, which stands for the usual search and reads none.
  AntParams() : AntParams("exact") {}
  /// @throws Error(invalid_parameter) for an unknown name, with the nearest known one.
  explicit AntParams(std::string_view algorithm);
  /// Its name. To ask another algorithm, make other parameters.
  const std::string& algorithm() const noexcept { return algorithm_; }
  friend bool operator==(const AntParams&, const AntParams&) = default;

  std::uint64_t seed = 1;  ///< no effect: that of the TourRequest counts
  int threads = 0;         ///< likewise

  int ants = 0;           ///< m; 0: one a stop
  int iterations = 1000;  ///< of all ants
  double alpha = 1;       ///< exponent of pheromone
  double beta = 2;        ///< exponent of 1 / the leg's length
  double greedy = 0;      ///< q0: share of choices that take the largest weight
  double drawn = 0;  ///< steps of a tour that are drawn, s: q0 = 1 - s / n; 0: as `greedy` says
  GreedyStep greedy_step = GreedyStep::largest_weight;  ///< where q0 leads
  /// tau0; 0: the family's own, of a tour that goes to the nearest stop, of length C: `as` m / C,
  /// `eas` (m + e) / (rho C), `ras` w (w - 1) / (2 rho C), `mmas` 1 / (rho C), others 1 / (n C).
  double initial_pheromone = 0;
  int candidates = 0;  ///< nearest stops that are chosen from first; 0: all
  Improvement local_search = Improvement::none;  ///< of every ant's tour

 private:
  std::string algorithm_;
};

/// `exact`, then the families.
LASIUS_EXPORT std::span<const Algorithm> algorithms() noexcept;
/// One of them. @throws Error(invalid_parameter) for an unknown name, with the nearest.
LASIUS_EXPORT const Algorithm& find_algorithm(std::string_view name);
/// Sets a parameter by its name, from text. @throws Error(invalid_parameter) for an unknown name
/// (with the nearest), value or range.
LASIUS_EXPORT void set_parameter(AntParams& params, std::string_view name, std::string_view value);
/// The value as text, which set_parameter reads. @throws Error(invalid_parameter) for an unknown
/// name, with the nearest.
LASIUS_EXPORT std::string get_parameter(const AntParams& params, std::string_view name);
/// The rules of a colony in a line each, see lasius::formulas(); empty for `exact`.
LASIUS_EXPORT std::vector<std::string> formulas(const AntParams& params);
/// @throws Error(invalid_parameter) for the first field that is out of range, or was changed
/// although the algorithm does not read it.
LASIUS_EXPORT void validate(const AntParams& params);

}  // namespace lasius::tour
