#include <lasius/version.h>

#include "python/extension/modules.h"

namespace py = pybind11;

PYBIND11_MODULE(_lasius, module) {
  using namespace lasius::python;
  module.doc() = "The library lasius, as the package lasius uses it: see there.";
  module.attr("version") = LASIUS_VERSION;
  bind_errors(module);
  bind_calls(module);
  bind_grid(module);
  bind_maps(module);
  bind_params(module);
  bind_own_rules(module);
  bind_planner(module);
  bind_batch(module);
  bind_navigator(module);
  bind_drive(module);
  bind_tour(module);
  bind_costs(module);
  bind_vehicle(module);
  bind_vehicle_navigator(module);
  bind_results(module);
#ifdef LASIUS_PYTHON_POLYGON
  py::module_ polygon = module.def_submodule("polygon");
  bind_polygon(polygon);
#endif
#ifdef LASIUS_PYTHON_ARM
  py::module_ arm = module.def_submodule("arm");
  bind_arm(arm);
#endif
}
