// The published rules of colonies on bitmaps: an enumeration a kind, and a table with a row a rule.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace lasius {

/// What the library says of a rule. In its formula i is the cell that an ant leaves, j the one that
/// a move leads to, E the goal, d a straight distance, tau pheromone and L the length of a tour;
/// what else is no parameter, `where` explains.
template <class Value>
struct Rule {
  Value value{};                ///< the rule
  std::string_view name;        ///< as options take it
  std::string_view parameters;  ///< names of those that it reads and some other rule does not,
                                ///< parted by blanks
  std::string_view formula;     ///< as formulas() tells it; empty: the factor 1
  std::string_view where = {};  ///< its own symbols, explained

  /// Is it one of `parameters`? Whether its value counts may depend on other parameters, too: see
  /// why_unread().
  constexpr bool reads(std::string_view parameter) const noexcept {
    for (std::string_view rest = parameters; !rest.empty();) {
      const std::string_view word = rest.substr(0, rest.find(' '));
      if (word == parameter) return true;
      rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    }
    return false;
  }
};

/// The row of a value; an empty one for what is none.
template <class Value, std::size_t kCount>
constexpr Rule<Value> rule_of(Value value, const std::array<Rule<Value>, kCount>& rules) noexcept {
  for (const Rule<Value>& rule : rules) {
    if (rule.value == value) return rule;
  }
  return {};
}

/// The names of rules, in the order of their values.
template <class Value, std::size_t kCount>
constexpr std::array<std::string_view, kCount> rule_names(
    const std::array<Rule<Value>, kCount>& rules) {
  std::array<std::string_view, kCount> names;
  for (const Rule<Value>& rule : rules) names.at(static_cast<std::size_t>(rule.value)) = rule.name;
  return names;
}

/// The part of a move's weight that depends on where it leads.
enum class Heuristic {
  uniform,            ///< 1
  rescaled_distance,  ///< of d(j, E) to the largest around i (Fan et al. 2004, eq. 4)
  inverse_distance,   ///< 1 / d(j, E), d at least half a cell
  distance,           ///< d(j, E), at least half a cell; for rules where larger is worse
  goal_angle,         ///< of the angle between the move and the way to E
  learned,            ///< eta, learned from successful ants (Cong & Ponnambalam 2009)
  distance_field,     ///< 1 / shortest way from j to E on the grid; map-sized work
};
/// Their rows.
inline constexpr std::array kHeuristics{
    Rule<Heuristic>{Heuristic::uniform, "uniform", "", ""},
    Rule<Heuristic>{Heuristic::rescaled_distance, "rescaled-distance", "omega mu lambda",
                    "((Dmax - d(j, E)) omega + mu)^lambda", "Dmax the largest d around i"},
    Rule<Heuristic>{Heuristic::inverse_distance, "inverse-distance", "beta", "(1 / d(j, E))^beta"},
    Rule<Heuristic>{Heuristic::distance, "distance", "beta", "d(j, E)^beta"},
    Rule<Heuristic>{Heuristic::goal_angle, "goal-angle", "beta", "(1 / (1 + h / 45 degrees))^beta",
                    "h between the move and the way to E"},
    Rule<Heuristic>{Heuristic::learned, "learned", "beta", "eta(j)^beta",
                    "eta what ants have learned of a cell"},
    Rule<Heuristic>{Heuristic::distance_field, "distance-field", "beta", "(1 / D(j))^beta",
                    "D the shortest way from j to E"},
};
/// Their names, in the same order.
inline constexpr std::array kHeuristicNames = rule_names(kHeuristics);
/// The name of a value.
constexpr std::string_view to_string(Heuristic v) noexcept { return rule_of(v, kHeuristics).name; }

/// The part of a move's weight that depends on the move and the one before it.
enum class Visibility {
  none,            ///< 1
  inverse_step,    ///< 1 / length of the move (Fan et al. 2004, eq. 1)
  heading_change,  ///< of the turn; straight back is closed (the lecture)
};
/// Their rows.
inline constexpr std::array kVisibilities{
    Rule<Visibility>{Visibility::none, "none", "", ""},
    Rule<Visibility>{Visibility::inverse_step, "inverse-step", "beta", "(1 / s)^beta",
                     "s the length of the move"},
    Rule<Visibility>{Visibility::heading_change, "heading-change", "beta",
                     "(1 / (1 + turn / 45 degrees))^beta",
                     "turn the change of heading; straight back the factor is 0"},
};
/// Their names, in the same order.
inline constexpr std::array kVisibilityNames = rule_names(kVisibilities);
/// The name of a value.
constexpr std::string_view to_string(Visibility v) noexcept {
  return rule_of(v, kVisibilities).name;
}

/// How the trail changes after each iteration.
enum class Update {
  ant_system,      ///< every arrived ant deposits
  elitist,         ///< the same, and the best tour so far
  rank,            ///< the `ranks` - 1 best by rank, and the best so far
  max_min,         ///< one best tour, tau kept in [tau_min, tau_max]
  colony_system,   ///< best tour so far only, and every ant erases
  best_share,      ///< the elite_ants best of the iteration, each the same (the lecture)
  terminal_index,  ///< no trail but the best known way from each cell (Li, Wang & Ma)
  learning,        ///< rewards and penalties, ant by ant (Cong & Ponnambalam 2009, eq. 3, 4)
};
/// Their rows.
inline constexpr std::array kUpdates{
    Rule<Update>{Update::ant_system, "ant-system", "persistence initial_pheromone deposit",
                 "tau <- persistence tau + sum over the arrived ants of deposit / L"},
    Rule<Update>{Update::elitist, "elitist", "persistence initial_pheromone deposit elite_weight",
                 "tau <- persistence tau + sum over the arrived ants of deposit / L + elite_weight "
                 "deposit / L of the best so far"},
    Rule<Update>{
        Update::rank, "rank", "persistence initial_pheromone deposit ranks",
        "tau <- persistence tau + sum over the ranks - 1 best of (ranks - r) deposit / L + "
        "ranks deposit / L of the best so far",
        "r = 1 for the iteration's shortest tour, 2 for the next, and so on"},
    Rule<Update>{
        Update::max_min, "max-min",
        "persistence initial_pheromone deposit best_so_far_every best_probability",
        "tau <- persistence tau + deposit / L of the iteration's best, every best_so_far_every-th "
        "time of the best so far; tau within [tau_min, tau_max]",
        "tau_max = deposit / ((1 - persistence) L) of the best so far, tau_min such that at the "
        "bounds that tour is drawn again with probability best_probability"},
    Rule<Update>{
        Update::colony_system, "colony-system",
        "persistence initial_pheromone deposit local_evaporation batch",
        "on the best tour so far tau <- persistence tau + (1 - persistence) deposit / L; after an "
        "ant has passed tau <- (1 - local_evaporation) tau + local_evaporation tau0",
        "tau0 the pheromone at first"},
    Rule<Update>{Update::best_share, "best-share",
                 "persistence initial_pheromone deposit elite_ants",
                 "tau <- persistence tau + deposit / ants on the elite_ants best of the iteration"},
    Rule<Update>{
        Update::terminal_index, "terminal-index", "beta unknown_index index_spread index_answer",
        "backwards along every arrived ant's tour K(c) <- min(K(c), K(next) + step)",
        "K(c) the terminal index of a cell, next the cell after it, step the length of the "
        "move there"},
    Rule<Update>{
        Update::learning, "learning",
        "persistence initial_pheromone deposit reward reward_reading penalty",
        "after every ant tau <- persistence tau; on a tour that arrived tau <- tau (1 + reward "
        "rows / L) (affine: tau reward rows / L + 1), eta <- eta + rows / L; on the second half of "
        "a dead end tau and eta <- penalty times themselves",
        "rows the height of the map, eta that of the heuristic learned"},
};
/// Their names, in the same order.
inline constexpr std::array kUpdateNames = rule_names(kUpdates);
/// The name of a value.
constexpr std::string_view to_string(Update v) noexcept { return rule_of(v, kUpdates).name; }

}  // namespace lasius
