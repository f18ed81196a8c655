// lasius::Error as Python exceptions, which the package's module `errors` defines.
#include "lasius/base/error.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"

namespace lasius::python {

py::object exception(const Error& error) {
  const py::object kinds = py::module_::import("lasius.errors").attr("KINDS");
  py::object made = kinds[text(to_string(error.code()))](words(error.what()));
  made.attr("problem") = words(error.problem());
  made.attr("remedy") = words(error.remedy());
  const Error::Place& place = error.place();
  if (!place.file.empty()) made.attr("file") = words(place.file);
  if (place.line >= 0) made.attr("line") = place.line;
  if (place.offset >= 0) made.attr("offset") = place.offset;
  return made;
}

void bind_errors(py::module_&) {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      const py::object made = exception(error);
      PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
    }
  });
}

}  // namespace lasius::python
