// What a callback sees of a search under way.
#pragma once

#include <stdexcept>

#include "lasius/plan/progress.h"
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
  /// The callback's answer is Go::stop. @throws as get.
  void stop() {
    (void)get();
    answer_ = Go::stop;
  }
  Go answer() const noexcept { return answer_; }
  /// @throws std::runtime_error after the callback.
  const Progress& get() const {
    if (progress_ != nullptr) return *progress_;
    throw std::runtime_error("this progress has ended: keep what you need of it in the callback");
  }

 private:
  const Progress* progress_;
  Go answer_ = Go::on;
};

/// A Python object over something that outlives this; it ends with this.
template <class Seen>
class Lent {
 public:
  explicit Lent(const Seen& seen) : object_(py::cast(View<Seen>(seen))) {}
  ~Lent() { view().end(); }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;
  const py::object& get() const noexcept { return object_; }
  Go answer() const { return view().answer(); }  ///< of who has seen it

 private:
  View<Seen>& view() const { return object_.template cast<View<Seen>&>(); }

  py::object object_;
};

/// An observer that calls `function` with a view, and ends the search or drive where it raises.
/// Empty for None. Both must live as long.
template <class Progress>
Callback<const Progress&> observer(Call& call, const py::object& function) {
  if (function.is_none()) return {};
  return [&call, &function](const Progress& progress) {
    return call.ask([&] {
      const Lent view(progress);
      function(view.get());
      return view.answer();
    });
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
      .def("stop", &Seen::stop);
}

}  // namespace lasius::python
