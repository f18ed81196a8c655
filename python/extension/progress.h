// What a callback sees of a search under way.
#pragma once

#include <functional>
#include <stdexcept>

#include "lasius/progress.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/results.h"

namespace lasius::python {

/// A view of the library's progress that ends with the callback: used later, it raises.
template <class Progress>
class View {
 public:
  explicit View(const Progress& progress) noexcept : progress_(&progress) {}
  void end() noexcept { progress_ = nullptr; }
  /// @throws std::runtime_error after the callback.
  const Progress& get() const {
    if (progress_ != nullptr) return *progress_;
    throw std::runtime_error("this progress has ended: keep what you need of it in the callback");
  }

 private:
  const Progress* progress_;
};

/// A Python object over something that outlives this; it ends with this.
template <class Seen>
class Lent {
 public:
  explicit Lent(const Seen& seen) : object_(py::cast(View<Seen>(seen))) {}
  ~Lent() { object_.template cast<View<Seen>&>().end(); }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;
  const py::object& get() const noexcept { return object_; }

 private:
  py::object object_;
};

/// An observer that calls `function` with a view, and ends the search or drive where it raises.
/// Empty for None. Both must live as long.
template <class Progress>
std::function<void(const Progress&)> observer(Call& call, const py::object& function) {
  if (function.is_none()) return {};
  return [&call, &function](const Progress& progress) {
    const bool go_on = call.call_back([&] {
      const Lent view(progress);
      function(view.get());
    });
    if (!go_on) progress.stop();
  };
}

/// A Python class over View<Progress>, with what all worlds show.
template <class Progress>
py::class_<View<Progress>> bind_progress(py::module_& module, const char* name) {
  using Seen = View<Progress>;
  return py::class_<Seen>(module, name)
      .def_property_readonly("iteration", [](const Seen& v) { return v.get().iteration; })
      .def_property_readonly("best_length", [](const Seen& v) { return v.get().best_length; })
      .def_property_readonly("mean_length", [](const Seen& v) { return v.get().mean_length; })
      .def_property_readonly("arrived", [](const Seen& v) { return v.get().arrived; })
      .def_property_readonly("lower_bound", [](const Seen& v) { return v.get().lower_bound; })
      .def_property_readonly("_curves",
                             [](const Seen& v) -> py::object {
                               const Convergence* const seen = v.get().curves;
                               return seen == nullptr ? py::none() : curves(*seen);
                             })
      .def("stop", [](const Seen& v) { v.get().stop(); });
}

}  // namespace lasius::python
