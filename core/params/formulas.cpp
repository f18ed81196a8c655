#include <string>
#include <vector>

#include "core/params/schedule.h"
#include "lasius/params.h"

namespace lasius {
std::vector<std::string> formulas(const Params& params) {
  if (find_algorithm(params.algorithm()).kind != Algorithm::Kind::colony) return {};
  const bool index = params.update == Update::terminal_index;
  const std::string trail = index ? "(K(j) - index_spread Kmin)^alpha" : "tau^alpha";
  std::string weight = trail, where;
  const auto multiply = [&](const auto& rule) {
    if (!rule.formula.empty()) weight.append(" * ").append(rule.formula);
    if (!rule.where.empty()) where.append("; ").append(rule.where);
  };
  multiply(rule_of(params.heuristic, kHeuristics));
  multiply(rule_of(params.visibility, kVisibilities));
  std::vector<std::string> lines{"weight of the move from i to j: " + weight + where};
  const bool learns = params.heuristic == Heuristic::learned || params.update == Update::learning;
  lines.push_back(
      index
          ? "K is the terminal index of a cell, Kmin the least of those beside i; d a distance, E "
            "the goal"
          : "tau is pheromone, tau0 its first value; " +
                std::string(learns ? "eta what ants learned; " : "") +
                "d a distance, E the goal, L the length of a tour");
  lines.emplace_back(index
                         ? "choice: moves are discarded in proportion to their weight until one "
                           "is left"
                         : "choice: in proportion to the weight among cells not yet entered; with "
                           "probability `greedy` the largest");
  if (mixes_rules(params)) {
    std::string alone = trail;
    const auto factor = rule_of(params.visibility, kVisibilities).formula;
    if (!factor.empty()) alone.append(" * ").append(factor);
    lines.push_back("or, drawn by shares: the weight " + alone +
                    ", or that of the heuristic alone");
  }
  lines.push_back("update: " + std::string(rule_of(params.update, kUpdates).formula));
  if (params.polish != Polish::none && params.straight_deposit != StraightDeposit::none)
    lines.emplace_back("and deposit / S on the cells under straightened paths of length S");
  return lines;
}

}  // namespace lasius
