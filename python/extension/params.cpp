// Algorithms on bitmaps and their parameters.
#include "lasius/params/params.h"

#include "python/extension/modules.h"
#include "python/extension/names.h"
#include "python/extension/parameter_class.h"

namespace lasius::python {

void bind_params(py::module_& module) {
  bind_parameter_class<Params>(module).def(
      py::init([](const std::string& algorithm, const std::string& preset) {
        return Params(algorithm, value_of<Preset>("preset", kPresetNames, preset));
      }));
  module.def("algorithms", [] { return described(algorithms()); });
}

}  // namespace lasius::python
