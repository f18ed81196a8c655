// What Navigator and drive share.
#pragma once

#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

#include "lasius/navigator.h"
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

/// Radius, scaling, weight, inscribed radius.
using InflationNumbers = std::tuple<double, double, double, double>;

std::optional<Inflation> inflation_from(const std::optional<InflationNumbers>& numbers);

NavigatorOptions navigator_options(const Params& params, double radius, bool prepare,
                                   double target_gap, bool search_on, double goal_tolerance,
                                   int doubt_after, const CostField* costs,
                                   const std::optional<InflationNumbers>& inflation);

/// The fields of lasius.Way.
py::tuple fields(const Way& way);

}  // namespace lasius::python
