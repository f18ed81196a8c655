#include "core/exact/exact_answer.h"

namespace lasius::exact {

void conclude(double lower, double upper, StopCondition::Cause cause, double target_gap,
              ExactAnswer& answer) {
  const bool found = std::isfinite(upper);
  answer.cause = cause;
  answer.stored_legs = false;
  answer.length = found ? path_length(answer.path) : kNaN;
  const bool proven = found && lower >= upper;
  answer.optimal = proven && rounding(upper) <= kRounding;
  answer.lower_bound = answer.optimal         ? answer.length
                       : std::isfinite(lower) ? rounded_down(lower)
                                              : lower;
  if (proven)
    answer.end = ExactEnd::proven;
  else if (found && upper - lower <= target_gap * lower)
    answer.end = ExactEnd::target_gap;
  else if (cause != StopCondition::Cause::none)
    answer.end = ExactEnd::stopped;
  else
    answer.end = ExactEnd::unreachable;
}

}  // namespace lasius::exact
