#include "tools/study/optimum.h"

#include "lasius/shortest_walk.h"

namespace lasius::study {
namespace {

constexpr std::string_view kExact = "exact";

}  // namespace

std::optional<double> true_optimum(const Planner& planner, const Question& question,
                                   const Truth& truth, const StopCondition& stop) {
  if (truth.kind == Truth::Kind::moves)
    return shortest_walk(planner.grid(), question.start, question.goal, truth.neighbours,
                         truth.corners, stop);
  const Result result = planner.plan({question.start, question.goal, stop}, defaults(kExact));
  if (!result.optimal) return std::nullopt;
  return result.length;
}

}  // namespace lasius::study
