// The true shortest lengths that every table is measured against.
#pragma once

#include <optional>

#include "lasius/planner.h"
#include "study/study.h"

namespace lasius::study {

/// Length of the shortest path from cell to cell by the moves of a neighbourhood named as the
/// parameter has it, or nothing where there is none. Dijkstra's algorithm; memory grows with the
/// map.
std::optional<double> shortest_by_moves(const Grid& grid, Cell start, Cell goal,
                                        std::string_view neighbours, Corners corners);

/// The question's optimum, or nothing where it is not known: the any-angle one is asked of the
/// library's algorithm `exact`.
std::optional<double> true_optimum(const Planner& planner, const Question& question,
                                   const Truth& truth, const StopCondition& stop);

}  // namespace lasius::study
