// What Navigator and drive share.
#pragma once

#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

#include "lasius/drive/navigator.h"
#include "python/extension/arrays.h"

namespace lasius::python {

/// A Navigator that Python threads take in turns.
template <class Owned>
struct Shared {
  explicit Shared(Owned made) : navigator(std::move(made)) {}
  std::mutex mutex;  ///< of the navigator; never waited for with the interpreter's lock
  Owned navigator;
};
using SharedNavigator = Shared<Navigator>;

/// A member that asks or changes the navigator, when no other thread does.
template <class Owned, class Use>
auto alone(Shared<Owned>& shared, const Use& use) {
  const py::gil_scoped_release released;
  const std::lock_guard lock(shared.mutex);
  return use(shared.navigator);
}

/// The class of a navigator, with what all have.
template <class Owned>
py::class_<Shared<Owned>> bind_shared(py::module_& module, const char* name) {
  py::class_<Shared<Owned>> bound(module, name);
  bound
      .def("observe",
           [](Shared<Owned>& shared, const IntRows& rows, bool blocked) {
             const auto cells = cells_from(rows, "cells");
             alone(shared, [&](Owned& n) { n.observe(cells, blocked); });
           })
      .def("observe_rectangle",
           [](Shared<Owned>& shared, int x, int y, int width, int height, bool blocked) {
             alone(shared, [&](Owned& n) { n.observe({x, y, width, height}, blocked); });
           })
      .def("forget", [](Shared<Owned>& s) { alone(s, [](Owned& n) { n.forget(); }); })
      .def("map",
           [](Shared<Owned>& s) { return alone(s, [](Owned& n) { return Grid(n.map()); }); });
  return bound;
}

/// Radius, scaling, weight, inscribed radius.
using InflationNumbers = std::tuple<double, double, double, double>;

std::optional<Inflation> inflation_from(const std::optional<InflationNumbers>& numbers);

/// The fields of lasius.Way.
py::tuple fields(const Way& way);

}  // namespace lasius::python
