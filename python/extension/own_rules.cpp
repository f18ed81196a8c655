#include "python/extension/own_rules.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "python/extension/modules.h"
#include "python/extension/progress.h"

namespace lasius::python {
namespace {

using Places = py::array_t<TrailPlace, py::array::c_style | py::array::forcecast>;

/// Places as the caller gives them: an array or a list. @throws py::type_error for what are no
/// integers, rather than cut them off.
Places places_from(const py::object& given) {
  const auto array = py::array::ensure(given);
  const char kind = array ? array.dtype().kind() : 'O';
  if (array && array.size() > 0 && kind != 'i' && kind != 'u')
    throw py::type_error(py::str("places are {}: give an array of integers").format(array.dtype()));
  auto places = Places::ensure(given);
  if (!array || !places) throw py::type_error("places: give an array of integers");
  return places;
}

/// The trail, for as long as the update runs.
struct Hand {
  Pheromone& trail;
  py::ssize_t height, width, moves;
};
using TrailView = View<Hand>;
using ToursView = View<IterationTours>;

template <class Value, int kFlags>
std::span<const Value> span_of(const py::array_t<Value, kFlags>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// An array of what a span shows, read-only, not copied: it keeps the memory.
template <class Value>
py::array_t<Value> shown(std::span<const Value> values, const std::shared_ptr<const void>& memory) {
  auto kept = std::make_unique<std::shared_ptr<const void>>(memory);
  const py::capsule owner(
      kept.get(), [](void* held) { delete static_cast<std::shared_ptr<const void>*>(held); });
  kept.release();
  py::array_t<Value> array(static_cast<py::ssize_t>(values.size()), values.data(), owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// A property of the tours that is a span of theirs.
template <auto kSpan>
auto list(const ToursView& view) {
  return shown(view.get().*kSpan, view.get().memory);
}

/// One that is written when it is asked for.
template <class Get>
auto numbered(Get get) {
  return [get](const ToursView& view) { return shown((view.get().*get)(), view.get().memory); };
}

/// A function that takes one of their ants.
template <class Get>
auto of_ant(Get get) {
  return [get](const ToursView& view, int ant) {
    const IterationTours& tours = view.get();
    if (ant < 0 || ant >= tours.ants()) throw py::index_error("there is no such ant");
    return shown((tours.*get)(ant), tours.memory);
  };
}

/// One value a place, or one for all of them.
void set(const TrailView& view, const py::object& given, const Rows& values) {
  const Places places = places_from(given);
  if (values.ndim() > 0) return view.get().trail.set(span_of(places), span_of(values));
  const std::vector<double> same(static_cast<std::size_t>(places.size()), *values.data());
  view.get().trail.set(span_of(places), same);
}

void add(const TrailView& view, const py::object& given, const Rows& values) {
  const Places places = places_from(given);
  if (values.ndim() > 0) return view.get().trail.add(span_of(places), span_of(values));
  view.get().trail.add(span_of(places), *values.data());
}

/// What a function of the trail writes for places.
template <auto kGet>
py::array_t<double> values_at(const TrailView& view, const py::object& given) {
  const Places places = places_from(given);
  py::array_t<double> values(places.size());
  (view.get().trail.*kGet)(span_of(places), {values.mutable_data(), span_of(places).size()});
  return values;
}

/// tau of the whole map.
py::array_t<double> whole(const TrailView& view) {
  const Hand& hand = view.get();
  Places all(static_cast<py::ssize_t>(hand.trail.places()));
  std::iota(all.mutable_data(), all.mutable_data() + all.size(), TrailPlace{0});
  auto values = values_at<&Pheromone::get>(view, all);
  if (hand.trail.trail() == Trail::cells) return values.reshape({hand.height, hand.width});
  return values.reshape({hand.height, hand.width, hand.moves});
}

[[noreturn]] void raise(PyObject* type, const py::str& text) {
  PyErr_SetObject(type, text.ptr());
  throw py::error_already_set();
}

/// The weights with what a schedule returned.
StepWeights changed(StepWeights weights, const py::object& returned) {
  if (!py::isinstance<py::dict>(returned))
    raise(PyExc_TypeError, "a schedule returns a dict, {'alpha': 2.0}, say");
  const std::array<std::pair<const char*, double*>, 6> fields{
      {{"alpha", &weights.alpha},
       {"beta", &weights.beta},
       {"greedy", &weights.greedy},
       {"pheromone_rule", &weights.pheromone_rule},
       {"distance_rule", &weights.distance_rule},
       {"combined_rule", &weights.combined_rule}}};
  for (const auto& [key, value] : returned.cast<py::dict>()) {
    const auto* const field = std::ranges::find_if(
        fields, [&key = key](const auto& f) { return key.equal(py::str(f.first)); });
    if (field == fields.end())
      raise(PyExc_ValueError, py::str("a schedule sets no {!r}").format(key));
    *field->second = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  }
  return weights;
}

}  // namespace

OwnRules own_rules(const Given& given, const Params& params, Call& call) {
  OwnRules own;
  if (given.heuristic) own.heuristic = span_of(*given.heuristic);
  if (!given.update.is_none()) {
    own.update = [&given, &call](Pheromone& trail, const IterationTours& tours) {
      return call.ask([&] {
        const Hand hand{trail, tours.height, tours.width, tours.moves};
        const Lent<Hand> lent(hand);
        const Lent<IterationTours> seen(tours);
        given.update(lent.get(), seen.get());
        return seen.answer();
      });
    };
  }
  if (!given.schedule.is_none()) {
    own.schedule = [&given, &params, &call](int iteration) {
      StepWeights weights = schedule(params, iteration);
      call.call_back([&] { weights = changed(weights, given.schedule(iteration)); });
      return weights;
    };
  }
  return own;
}

void bind_own_rules(py::module_& module) {
  py::class_<TrailView>(module, "Pheromone")
      .def("persist",
           [](const TrailView& v, double persistence) { v.get().trail.persist(persistence); })
      .def("add", &add)
      .def("set", &set)
      .def("clamp",
           [](const TrailView& v, double least, double most) { v.get().trail.clamp(least, most); })
      .def("get", &values_at<&Pheromone::get>)
      .def("get_learned", &values_at<&Pheromone::get_learned>)
      .def("set_learned",
           [](const TrailView& v, const py::object& cells, const Rows& values) {
             v.get().trail.set_learned(span_of(places_from(cells)), span_of(values));
           })
      .def("to_array", &whole);
  using T = IterationTours;
  py::class_<ToursView>(module, "IterationTours")
      .def_property_readonly("iteration", [](const ToursView& v) { return v.get().iteration; })
      .def_property_readonly("width", [](const ToursView& v) { return v.get().width; })
      .def_property_readonly("height", [](const ToursView& v) { return v.get().height; })
      .def_property_readonly("moves", [](const ToursView& v) { return v.get().moves; })
      .def_property_readonly("start", [](const ToursView& v) { return v.get().start; })
      .def_property_readonly("goal", [](const ToursView& v) { return v.get().goal; })
      .def_property_readonly("cells", numbered(&T::cells))
      .def_property_readonly("offsets", &list<&T::offsets>)
      .def_property_readonly("arcs", numbered(&T::arcs))
      .def_property_readonly("lengths", &list<&T::lengths>)
      .def_property_readonly("ranked", &list<&T::ranked>)
      .def_property_readonly("best_cells", numbered(&T::best_cells))
      .def_property_readonly("best_arcs", numbered(&T::best_arcs))
      .def_property_readonly("best_length", [](const ToursView& v) { return v.get().best_length; })
      .def("cells_of", of_ant(&T::cells_of))
      .def("places_of", of_ant(&T::places_of))
      .def("best_places", numbered(&T::best_places))
      .def("stop", &ToursView::stop);
}

}  // namespace lasius::python
