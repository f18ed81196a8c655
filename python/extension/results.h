// Answers as tuples of plain values and arrays, in the order of the fields of the dataclasses that
// lasius/results.py makes of them.
#pragma once

#include "lasius/plan/result.h"
#include "python/extension/arrays.h"

namespace lasius::python {

/// (iterations, best, mean, arrived, ...) as in lasius.Curves, or None for an algorithm without
/// iterations.
py::object curves(const Convergence& convergence);

/// The fields of lasius.SearchResult.
py::tuple search_fields(const SearchResult& result);

/// (fields of lasius.SearchResult, path, way_out, goal_reached, nearest_free, nearest_reachable,
/// own_rules, curve).
py::tuple fields(const Result& result);

}  // namespace lasius::python
