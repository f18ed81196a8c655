// VehicleNavigator: a vehicle's planner on a map that changes; and scans in metres as cells.
#include <array>

#include "lasius/vehicle/navigator.h"
#include "lasius/vehicle/scan.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/navigator_class.h"
#include "python/extension/vehicle_class.h"

namespace lasius::python {
namespace {

using SharedVehicle = Shared<vehicle::Navigator>;

/// (error, fields of lasius.VehicleWay)
py::tuple step(SharedVehicle& shared, const std::array<double, 3>& robot,
               std::optional<double> time_limit) {
  Call call(time_limit);
  const vehicle::Way way = call.run([&] {
    const std::lock_guard lock(shared.mutex);
    return shared.navigator.step({robot[0], robot[1], robot[2]}, call.condition());
  });
  return py::make_tuple(call.error(), py::make_tuple(vehicle_fields(way), way.replanned,
                                                     way.way_out, way.rejoined, way.doubted));
}

vehicle::NavigatorOptions options_from(double goal_tolerance, double heading_tolerance,
                                       double weight, bool smooth, std::int64_t max_states,
                                       int doubt_after, const CostField* costs,
                                       const std::optional<InflationNumbers>& inflation) {
  vehicle::NavigatorOptions options{.goal_tolerance = goal_tolerance,
                                    .heading_tolerance = heading_tolerance,
                                    .weight = weight,
                                    .smooth = smooth,
                                    .max_states = max_states,
                                    .inflation = inflation_from(inflation),
                                    .doubt_after = doubt_after};
  if (costs != nullptr) options.costs = *costs;
  return options;
}

py::tuple cells_of(const vehicle::SeenCells& seen) {
  return py::make_tuple(to_array(std::span<const Cell>(seen.free)),
                        to_array(std::span<const Cell>(seen.blocked)));
}

}  // namespace

void bind_vehicle_navigator(py::module_& module) {
  py::class_<vehicle::NavigatorOptions>(module, "VehicleNavigatorOptions")
      .def(py::init(&options_from));
  bind_shared<vehicle::Navigator>(module, "VehicleNavigator")
      .def(py::init([](const Grid& map, const vehicle::Vehicle& vehicle, const Rows& goals,
                       const vehicle::NavigatorOptions& options) {
        auto poses = poses_from(goals, "goal");
        const py::gil_scoped_release released;
        return std::make_unique<SharedVehicle>(
            vehicle::Navigator(map, vehicle, std::move(poses), options));
      }))
      .def("set_costs",
           [](SharedVehicle& shared, const CostField& costs) {
             alone(shared, [&](auto& n) { n.set_costs(costs); });
           })
      .def("step", &step)
      .def("set_goals", [](SharedVehicle& shared, const Rows& goals) {
        auto poses = poses_from(goals, "goal");
        alone(shared, [&](auto& n) { n.set_goals(std::move(poses)); });
      });
  module.def("cells_of_scan", [](const std::array<double, 3>& sensor, const Rows& ranges,
                                 double first_angle, double step_angle, double least, double most,
                                 const WorldFrame& frame, int width, int height) {
    const std::span<const double> values(ranges.data(), static_cast<std::size_t>(ranges.size()));
    return cells_of(vehicle::seen_cells({.sensor = {sensor[0], sensor[1], sensor[2]},
                                         .first_angle = first_angle,
                                         .step = step_angle,
                                         .least = least,
                                         .most = most,
                                         .ranges = values},
                                        frame, width, height));
  });
  module.def("cells_of_points", [](const std::array<double, 2>& sensor, const Rows& points,
                                   double most, const WorldFrame& frame, int width, int height) {
    return cells_of(vehicle::seen_cells(Point{sensor[0], sensor[1]}, points_from(points, "points"),
                                        most, frame, width, height));
  });
}

}  // namespace lasius::python
