// One call of the library from Python: without the interpreter's lock, with a deadline, stopped by
// Ctrl-C and by what a callback raises.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <utility>

#include "lasius/base/error.h"
#include "lasius/base/stop.h"
#include "python/extension/interrupt.h"

namespace lasius::python {

namespace py = pybind11;

/// An instance of the Python class for this kind of error, with the parts of the message.
py::object exception(const Error& error);

/// Made, used and destroyed with the interpreter's lock. What callbacks and signal handlers raise
/// is kept in it while the library ends with the best that it has. At the interpreter's end those
/// of daemon threads are stopped, and none is made any more: Python ends a thread that asks for its
/// lock then, which C++ does not survive.
class Call {
 public:
  /// Counts the time limit, in seconds, from here. @throws py::value_error for one that is negative
  /// or no number; what a signal handler raises that was due before the call.
  explicit Call(std::optional<double> time_limit = {});
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /// Of the library's call: the deadline, and a token that stop() and SIGINT ask to stop.
  StopCondition condition() {
    return {.token = watch_.source().get_token(), .deadline = deadline_};
  }
  void stop() noexcept { watch_.source().request_stop(); }

  /// work(), without the lock.
  template <class Work>
  auto run(const Work& work) {
    const py::gil_scoped_release released;
    return work();
  }

  /// work() likewise: (error(), what it returned).
  template <class Work>
  py::tuple answer(const Work& work) {
    auto value = run(work);
    return py::make_tuple(error(), std::move(value));
  }

  /// work() likewise; what the library throws is kept as what a callback raises is.
  template <class Work>
  void run_kept(const Work& work) {
    try {
      run(work);
    } catch (const Error& thrown) {
      if (!error_) error_ = exception(thrown);
    }
  }

  /// From within run(): calls back() with the lock, unless something was raised before, and keeps
  /// what it raises. False if the library should stop.
  template <class Back>
  bool call_back(const Back& back) {
    const py::gil_scoped_acquire lock;
    if (error_) return false;
    try {
      back();
    } catch (py::error_already_set& error) {
      keep(error);
      stop();
    } catch (const py::builtin_exception& exception) {
      exception.set_error();
      py::error_already_set error;
      keep(error);
      stop();
    }
    return !error_;
  }

  /// The same of what answers: Go::stop if it raises, too.
  template <class Back>
  Go ask(const Back& back) {
    Go answer = Go::stop;
    return call_back([&] { answer = back(); }) ? answer : Go::stop;
  }

  /// The exception that a callback or a signal handler raised meanwhile, or None.
  py::object error();

 private:
  void keep(py::error_already_set& error);

  Clock::time_point deadline_ = Clock::time_point::max();
  InterruptWatch watch_;
  py::object error_;
};

}  // namespace lasius::python
