#include <array>
#include <string>
#include <vector>

#include "core/params/schedule.h"
#include "lasius/params.h"

namespace lasius {
namespace {

struct Factor {
  std::string_view formula;
  std::string_view where = {};
};

constexpr std::array<Factor, kHeuristicNames.size()> kHeuristics{{
    {""},
    {"((Dmax - d(j, E)) omega + mu)^lambda", "Dmax the largest d around i"},
    {"(1 / d(j, E))^beta"},
    {"d(j, E)^beta"},
    {"(1 / (1 + h / 45 degrees))^beta", "h between the move and the way to E"},
    {"eta(j)^beta"},
    {"(1 / D(j))^beta", "D the shortest way from j to E"},
}};
constexpr std::array<Factor, kVisibilityNames.size()> kVisibilities{{
    {""},
    {"(1 / s)^beta", "s the length of the move"},
    {"(1 / (1 + turn / 45 degrees))^beta", "0 straight back"},
}};
constexpr std::array<std::string_view, kUpdateNames.size()> kUpdateFormulas{
    "tau <- persistence tau + sum over the arrived ants of deposit / L",
    "tau <- persistence tau + sum over the arrived ants of deposit / L + elite_weight deposit / L "
    "of the best so far",
    "tau <- persistence tau + sum over the ranks - 1 best, r = 1 .., of (ranks - r) deposit / L + "
    "ranks deposit / L of the best so far",
    "tau <- persistence tau + deposit / L of the iteration's best, every best_so_far_every-th time "
    "of the best so far; tau within [tau_min, tau_max] by best_probability",
    "on the best tour so far tau <- persistence tau + (1 - persistence) deposit / L; after an ant "
    "has passed tau <- (1 - local_evaporation) tau + local_evaporation tau0",
    "tau <- persistence tau + deposit / ants on the elite_ants best of the iteration",
    "backwards along every arrived ant's tour K(c) <- min(K(c), K(next) + step)",
    "after every ant tau <- persistence tau; on a tour that arrived tau <- tau (1 + reward rows / "
    "L) (affine: tau reward rows / L + 1), eta <- eta + rows / L; on the second half of a dead end "
    "tau and eta <- penalty times themselves",
};

// Each case has its own.
static_assert(!kHeuristics.back().formula.empty() && !kVisibilities.back().formula.empty() &&
              !kUpdateFormulas.back().empty());

}  // namespace

std::vector<std::string> formulas(const Params& params) {
  if (find_algorithm(params.algorithm()).kind != Algorithm::Kind::colony) return {};
  const bool index = params.update == Update::terminal_index;
  std::string weight = index ? "(K(j) - index_spread Kmin)^alpha" : "tau^alpha", where;
  for (const Factor& factor : {kHeuristics[static_cast<std::size_t>(params.heuristic)],
                               kVisibilities[static_cast<std::size_t>(params.visibility)]}) {
    if (!factor.formula.empty()) weight.append(" * ").append(factor.formula);
    if (!factor.where.empty()) where.append("; ").append(factor.where);
  }
  std::vector<std::string> lines{"weight of the move from i to j: " + weight + where};
  lines.emplace_back(
      index
          ? "K is the terminal index of a cell, Kmin the least of those beside i; d a distance, E "
            "the goal"
          : "tau is pheromone, tau0 its first value; eta what ants learned; d a distance, E the "
            "goal, L the length of a tour");
  lines.emplace_back(index
                         ? "choice: moves are discarded in proportion to their weight until one "
                           "is left"
                         : "choice: in proportion to the weight among cells not yet entered; with "
                           "probability `greedy` the largest");
  if (mixes_rules(params))
    lines.emplace_back("or, drawn by shares, by pheromone alone (tau^alpha) or by distance alone");
  lines.push_back("update: " +
                  std::string(kUpdateFormulas[static_cast<std::size_t>(params.update)]));
  if (params.polish != Polish::none && params.straight_deposit != StraightDeposit::none)
    lines.emplace_back("and deposit / S on the cells under straightened paths of length S");
  return lines;
}

}  // namespace lasius
