#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/params/grid_parameters.h"
#include "lasius/params/params.h"

namespace lasius {
namespace {

// Is the number that of an enumerator? Compilers write others as casts: "= (lasius::Update)8".
template <auto kValue>
constexpr bool is_enumerator() {
  return std::string_view(__PRETTY_FUNCTION__).find("= (") == std::string_view::npos;
}
// Has each enumerator one row, with a name? Others' numbers rule_names() refuses.
template <class Value, std::size_t kCount>
constexpr bool complete(const std::array<Rule<Value>, kCount>& rules) {
  return std::ranges::none_of(rule_names(rules), &std::string_view::empty) &&
         !is_enumerator<static_cast<Value>(kCount)>();
}
static_assert(complete(kHeuristics) && complete(kVisibilities) && complete(kUpdates));

}  // namespace

std::vector<std::string> formulas(const Params& params) {
  if (find_algorithm(params.algorithm()).kind != Algorithm::Kind::colony) return {};
  const bool index = params.update == Update::terminal_index;
  const std::string trail = index ? "(K(j) - index_spread Kmin)^alpha" : "tau^alpha";
  const auto heuristic = rule_of(params.heuristic, kHeuristics);
  const auto visibility = rule_of(params.visibility, kVisibilities);
  const auto update = rule_of(params.update, kUpdates);
  const auto times = [](const std::string& weight, const auto& rule) {
    return rule.formula.empty() ? weight : weight + " * " + std::string(rule.formula);
  };
  const auto explain = [](std::string& line, const auto& rule) {
    if (!rule.where.empty()) line.append("; ").append(rule.where);
  };
  std::vector<std::string> lines{"weight of the move from i to j: " +
                                 times(times(trail, heuristic), visibility)};
  explain(lines.back(), heuristic);
  explain(lines.back(), visibility);
  lines.emplace_back(
      index
          ? "K is the terminal index of a cell, Kmin the least of those beside i; d a distance, E "
            "the goal"
          : "tau is pheromone; d a distance, E the goal, L the length of a tour");
  lines.emplace_back(index
                         ? "choice: moves are discarded in proportion to their weight until one "
                           "is left"
                         : "choice: in proportion to the weight among cells not yet entered; with "
                           "probability `greedy` the largest");
  if (mixes_rules(params))
    lines.push_back("or, drawn by shares: the weight " + times(trail, visibility) +
                    ", or that of the heuristic alone");
  explain(lines.emplace_back("update: ").append(update.formula), update);
  if (params.polish != Polish::none && params.straight_deposit != StraightDeposit::none)
    lines.emplace_back("and deposit / S on the cells under straightened paths of length S");
  return lines;
}

}  // namespace lasius
