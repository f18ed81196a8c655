// The parts of the extension module `_lasius`; module.cpp joins them.
#pragma once

#include <pybind11/pybind11.h>

namespace lasius::python {

void bind_errors(pybind11::module_& module);
void bind_calls(pybind11::module_& module);
void bind_grid(pybind11::module_& module);
void bind_maps(pybind11::module_& module);
void bind_params(pybind11::module_& module);
void bind_own_rules(pybind11::module_& module);
void bind_planner(pybind11::module_& module);
void bind_batch(pybind11::module_& module);
void bind_navigator(pybind11::module_& module);
void bind_drive(pybind11::module_& module);
void bind_tour(pybind11::module_& module);
void bind_costs(pybind11::module_& module);
void bind_vehicle(pybind11::module_& module);
void bind_vehicle_navigator(pybind11::module_& module);
void bind_results(pybind11::module_& module);
void bind_polygon(pybind11::module_& module);  ///< where the component was built
void bind_arm(pybind11::module_& module);      ///< likewise

}  // namespace lasius::python
