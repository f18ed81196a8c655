// Navigator: a robot's planner on a map edited in place, used by one Python thread at a time.
#include "lasius/drive/navigator.h"

#include <mutex>

#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/navigator_class.h"
#include "python/extension/results.h"

namespace lasius::python {

std::optional<Inflation> inflation_from(const std::optional<InflationNumbers>& numbers) {
  if (!numbers) return std::nullopt;
  const auto [reach, scaling, weight, inscribed] = *numbers;
  return Inflation{reach, scaling, weight, inscribed};
}

namespace {

NavigatorOptions navigator_options(const Params& params, double radius, bool prepare,
                                   double target_gap, bool search_on, double goal_tolerance,
                                   int doubt_after, const CostField* costs,
                                   const std::optional<InflationNumbers>& inflation) {
  NavigatorOptions options{.params = params,
                           .radius = radius,
                           .target_gap = target_gap,
                           .search_on = search_on,
                           .goal_tolerance = goal_tolerance,
                           .inflation = inflation_from(inflation),
                           .doubt_after = doubt_after};
  if (prepare) options.prepare.emplace();
  if (costs != nullptr) options.costs = *costs;
  return options;
}

}  // namespace

py::tuple fields(const Way& way) {
  return py::make_tuple(fields(static_cast<const Result&>(way)), way.replanned,
                        to_array(std::span<const Cell>(way.walk)), way.doubted, way.cost);
}

namespace {

/// (error, fields of lasius.Way)
py::tuple step(SharedNavigator& shared, Cell robot, std::optional<double> time_limit) {
  Call call(time_limit);
  const Way way = call.run([&] {
    const std::lock_guard lock(shared.mutex);
    return shared.navigator.step(robot, call.condition());
  });
  return py::make_tuple(call.error(), fields(way));
}

}  // namespace

void bind_navigator(py::module_& module) {
  py::class_<NavigatorOptions>(module, "NavigatorOptions").def(py::init(&navigator_options));
  bind_shared<Navigator>(module, "Navigator")
      .def(py::init([](const Grid& map, Cell goal, const NavigatorOptions& options) {
        const py::gil_scoped_release released;
        return std::make_unique<SharedNavigator>(Navigator(map, goal, options));
      }))
      .def("set_costs",
           [](SharedNavigator& shared, int x, int y, const Rows& weights) {
             if (weights.ndim() != 2) throw py::value_error("costs are an array (height, width)");
             const Rectangle part{x, y, static_cast<int>(weights.shape(1)),
                                  static_cast<int>(weights.shape(0))};
             const std::span<const double> values(weights.data(),
                                                  static_cast<std::size_t>(weights.size()));
             alone(shared, [&](Navigator& n) { n.set_costs(part, values); });
           })
      .def("step", &step)
      .def("goal",
           [](SharedNavigator& s) { return alone(s, [](Navigator& n) { return n.goal(); }); })
      .def("set_goal",
           [](SharedNavigator& s, Cell goal) { alone(s, [&](Navigator& n) { n.set_goal(goal); }); })
      .def("passable",
           [](SharedNavigator& s) {
             return alone(s, [](Navigator& n) { return Grid(n.passable()); });
           })
      .def("connected", [](SharedNavigator& s, Cell a, Cell b) {
        return alone(s, [&](Navigator& n) { return n.connected(a, b); });
      });
}

}  // namespace lasius::python
