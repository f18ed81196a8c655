// Parameters of any world as a Python class: by name, as text. The package makes numbers of them.
#pragma once

#include <string>
#include <string_view>

#include "lasius/params/params.h"
#include "python/extension/arrays.h"

namespace lasius::python {

/// (name, summary, source, kind, parameters) of each algorithm; of each parameter (name, type,
/// range, summary, only_with, choices, least, most).
inline py::list described(std::span<const Algorithm> algorithms) {
  py::list all;
  for (const Algorithm& algorithm : algorithms) {
    py::list parameters;
    for (const Parameter& p : algorithm.parameters) {
      py::list choices;
      for (const std::string_view choice : p.choices) choices.append(text(choice));
      parameters.append(py::make_tuple(text(p.name), text(p.type), p.range(), text(p.summary),
                                       text(p.only_with), py::tuple(choices), p.least, p.most));
    }
    all.append(py::make_tuple(text(algorithm.name), text(algorithm.summary), text(algorithm.source),
                              text(to_string(algorithm.kind)), py::tuple(parameters)));
  }
  return all;
}

/// The class `Params` over the parameters of one world. Its functions are found beside P.
template <class P>
py::class_<P> bind_parameter_class(py::module_& module) {
  auto bound = py::class_<P>(module, "Params");
  if constexpr (requires(P & p) { why_unread(p, ""); })
    bound.def("why_unread",
              [](const P& p, const std::string& name) { return why_unread(p, name); });
  return bound.def_property_readonly("algorithm", &P::algorithm)
      .def_readwrite("seed", &P::seed)
      .def_readwrite("threads", &P::threads)
      .def("get", [](const P& p, const std::string& name) { return get_parameter(p, name); })
      .def("set", [](P& p, const std::string& name,
                     const std::string& value) { set_parameter(p, name, value); })
      .def("validate", [](const P& p) { validate(p); })
      .def("formulas", [](const P& p) { return formulas(p); })
      .def("copy", [](const P& p) { return p; });
}

}  // namespace lasius::python
