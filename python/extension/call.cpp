#include "python/extension/call.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "python/extension/modules.h"

namespace lasius::python {
namespace {

/// Those under way, each with its process: a fork copies no threads. Used with the lock only.
std::vector<std::pair<Call*, pid_t>> calls;
bool closed = false;

/// Stops the calls of other threads and waits for them, for some seconds at most.
void close() {
  closed = true;
  const auto give_up = Clock::now() + std::chrono::seconds(5);
  const auto is_here = [](const auto& call) { return call.second == ::getpid(); };
  while (std::ranges::any_of(calls, is_here) && Clock::now() < give_up) {
    for (const auto& [call, process] : calls) call->stop();
    const py::gil_scoped_release released;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

void bind_calls(py::module_&) {
  py::module_::import("atexit").attr("register")(py::cpp_function(&close));
}

Call::Call(std::optional<double> time_limit) {
  if (closed) throw std::runtime_error("the interpreter is ending: nothing is planned any more");
  if (time_limit) {
    if (!(*time_limit >= 0))
      throw py::value_error("time_limit is " + std::string(py::repr(py::float_(*time_limit))) +
                            " s: it must be 0 or more, or None");
    deadline_ = deadline_in(std::chrono::duration<double>(*time_limit));
  }
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  calls.emplace_back(this, ::getpid());
}

Call::~Call() {
  std::erase_if(calls, [this](const auto& call) { return call.first == this; });
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
