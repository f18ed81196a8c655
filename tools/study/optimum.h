// The true shortest lengths that every table is measured against.
#pragma once

#include <optional>

#include "lasius/planner.h"
#include "tools/study/study.h"

namespace lasius::study {

/// The question's optimum, or nothing where it is not known: the any-angle one is asked of the
/// library's algorithm `exact`.
std::optional<double> true_optimum(const Planner& planner, const Question& question,
                                   const Truth& truth, const StopCondition& stop);

}  // namespace lasius::study
