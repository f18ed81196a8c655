#include "python/extension/call.h"

#include <chrono>
#include <string>

namespace lasius::python {

Call::Call(std::optional<double> time_limit) {
  if (time_limit) {
    if (!(*time_limit >= 0))
      throw py::value_error("time_limit is " + std::to_string(*time_limit) +
                            " s: it must be 0 or more, or None");
    deadline_ = deadline_in(std::chrono::duration<double>(*time_limit));
  }
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

py::object Call::error() {
  if (!error_ && PyErr_CheckSignals() != 0) {
    py::error_already_set error;
    keep(error);
  }
  return error_ ? error_ : py::none();
}

void Call::keep(py::error_already_set& error) {
  error_ = error.value();
  if (error.trace()) PyException_SetTraceback(error_.ptr(), error.trace().ptr());
}

}  // namespace lasius::python
