// Rules of a caller's own in a colony: a table, and functions of Python.
#pragma once

#include <optional>

#include "lasius/params/own_rules.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"

namespace lasius::python {

/// The table of an own heuristic.
using OwnTable = std::optional<py::array_t<double, py::array::c_style>>;

/// What Planner.plan or batch was given of them; None for what is the library's.
struct Given {
  const OwnTable& heuristic;
  const py::object& update;    ///< called with (trail, tours)
  const py::object& schedule;  ///< called with the iteration, returns a dict of what differs
};

/// The library's form of it. All outlive it. What the functions raise is kept in `call`, and ends
/// the search.
OwnRules own_rules(const Given& given, const Params& params, Call& call);

}  // namespace lasius::python
