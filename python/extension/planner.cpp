// Planner: made, prepared and edited without the interpreter's lock; plans.
#include "lasius/plan/planner.h"

#include <atomic>
#include <stdexcept>

#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/names.h"
#include "python/extension/own_rules.h"
#include "python/extension/progress.h"
#include "python/extension/results.h"

namespace lasius::python {
namespace {

/// Scratch memory that Python keeps, with the sign that it is in use, by one call at a time.
class SharedWorkspace {
 public:
  /// Uses it for as long as it lives. @throws std::runtime_error if another call does.
  class Use {
   public:
    explicit Use(SharedWorkspace* shared) : shared_(shared) {
      if (shared != nullptr && shared->busy_.exchange(true))
        throw std::runtime_error("the workspace is in use by another call: take one a thread");
    }
    ~Use() {
      if (shared_ != nullptr) shared_->busy_ = false;
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    Workspace* get() const noexcept { return shared_ == nullptr ? nullptr : &shared_->workspace_; }

   private:
    SharedWorkspace* shared_;
  };

 private:
  std::atomic<bool> busy_{false};
  Workspace workspace_;
};

PrepareOptions prepare_options(int threads, std::int64_t max_bytes, bool labels, Call& call) {
  return {.threads = threads, .max_bytes = max_bytes, .stop = call.condition(), .labels = labels};
}

/// (error, Planner or None)
py::tuple made(const Grid& grid, double radius) {
  Call call;
  return call.answer([&] { return Planner::make(Grid(grid), Disc{radius}, call.condition()); });
}

py::tuple prepared(const Planner& planner, int threads, std::int64_t max_bytes, bool labels) {
  Call call;
  return call.answer(
      [&] { return planner.prepared(prepare_options(threads, max_bytes, labels, call)); });
}

py::tuple load_preparation(const Planner& planner, const std::string& file) {
  Call call;
  return call.answer([&] { return planner.load_preparation(file); });
}

py::tuple widest_disc(const Planner& planner, Cell a, Cell b) {
  Call call;
  const auto widest = call.run([&] { return planner.widest_disc(a, b, call.condition()); });
  return py::make_tuple(call.error(), widest);
}

/// A start or goal: two integers are a cell, else two numbers a point.
struct End {
  Cell cell;
  std::optional<Point> point;

  explicit End(const py::object& source) {
    const auto is_real = [](const py::handle part) {
      return PyNumber_Check(part.ptr()) != 0 && PyIndex_Check(part.ptr()) == 0;
    };
    const bool pair = PySequence_Check(source.ptr()) != 0 && PySequence_Size(source.ptr()) == 2;
    PyErr_Clear();
    if (pair && (is_real(source[py::int_(0)]) || is_real(source[py::int_(1)])))
      point = point_from(source);
    else
      cell = cell_from(source);
  }
};

py::tuple plan(const Planner& planner, const py::object& start, const py::object& goal,
               const Params& params, double target_gap, double goal_tolerance,
               std::optional<double> time_limit, SharedWorkspace* workspace,
               const py::object& callback, const OwnTable& heuristic, const py::object& update,
               const py::object& schedule, const py::tuple& via, int alternatives) {
  Call call(time_limit);
  const SharedWorkspace::Use use(workspace);
  const Observer observe = observer<GridProgress>(call, callback);
  const Given given{heuristic, update, schedule};
  const OwnRules own = own_rules(given, params, call);
  const End from(start), to(goal);
  Request request{.start = from.cell,
                  .goal = to.cell,
                  .stop = call.condition(),
                  .target_gap = target_gap,
                  .goal_tolerance = goal_tolerance,
                  .start_point = from.point,
                  .goal_point = to.point,
                  .alternatives = alternatives};
  for (const py::handle place : via) {
    const End on_the_way(py::reinterpret_borrow<py::object>(place));
    request.via.push_back(on_the_way.point.value_or(centre(on_the_way.cell)));
  }
  const Result result = call.run([&] {
    return planner.plan(request, params,
                        {.workspace = use.get(), .observer = observe, .own_rules = own});
  });
  return py::make_tuple(call.error(), fields(result));
}

py::tuple edited(const Planner& planner, const IntRows& cells, const py::array_t<bool>& blocked) {
  Call call;
  std::vector<Planner::Edit> edits;
  const auto flags = blocked.unchecked<1>();
  for (const Cell c : cells_from(cells, "cells"))
    edits.push_back({c, flags(static_cast<py::ssize_t>(edits.size()))});
  return call.answer([&] { return planner.edited(edits, call.condition()); });
}

std::vector<Planner::Direction> directions_from(const IntRows& rows) {
  const py::ssize_t count = row_count(rows, 4, "directions");
  std::vector<Planner::Direction> directions;
  for (py::ssize_t i = 0; i < count; ++i) {
    const std::int32_t* const r = rows.data() + 4 * i;
    directions.push_back({{r[0], r[1]}, r[2], r[3]});
  }
  return directions;
}

using Change = std::optional<Planner> (Planner::*)(std::span<const Planner::Direction>,
                                                   const StopCondition&) const;
template <Change kChange>
py::tuple changed(const Planner& planner, const IntRows& rows) {
  Call call;
  const auto directions = directions_from(rows);
  return call.answer([&] { return (planner.*kChange)(directions, call.condition()); });
}

py::array_t<std::int32_t> excluded(const Planner& planner) {
  std::vector<std::int32_t> numbers;
  for (const auto& d : planner.excluded())
    numbers.insert(numbers.end(), {d.from.x, d.from.y, d.dx, d.dy});
  return to_array(numbers).reshape({-1, 4});
}

py::tuple preparation(const Preparation& p) {
  return py::make_tuple(text(to_string(p.state)), p.vertices, p.edges, p.bytes, p.seconds,
                        text(to_string(p.labels.state)), p.labels.entries, p.labels.bytes,
                        p.labels.seconds);
}

/// Of all cells, [y, x].
py::array_t<double> pheromone(const View<GridProgress>& view, const Grid& grid) {
  const int width = grid.width(), height = grid.height();
  py::array_t<double> trail({height, width});
  auto cells = trail.mutable_unchecked<2>();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) cells(y, x) = view.get().pheromone({x, y});
  return trail;
}

void bind_grid_progress(py::module_& module) {
  using Seen = View<GridProgress>;
  bind_progress<GridProgress>(module, "Progress")
      .def_property_readonly("ants", [](const Seen& v) { return v.get().ants(); })
      .def("path", [](const Seen& v) { return to_array(std::span<const Point>(v.get().path())); })
      .def("tour", [](const Seen& v,
                      int ant) { return to_array(std::span<const Cell>(v.get().tour(ant))); })
      .def("walk", [](const Seen& v,
                      int ant) { return to_array(std::span<const Cell>(v.get().walk(ant))); })
      .def("pheromone_at", [](const Seen& v, Cell c) { return v.get().pheromone(c); })
      .def("pheromone", &pheromone);
}

}  // namespace

void bind_planner(py::module_& module) {
  bind_grid_progress(module);
  py::class_<SharedWorkspace>(module, "Workspace",
                              "Scratch memory of one call at a time: with it a second call of the "
                              "same size allocates nothing but its answer.")
      .def(py::init<>());
  module.def("make_planner", &made);
  py::class_<Planner>(module, "Planner")
      .def_property_readonly("grid", &Planner::grid, py::return_value_policy::reference_internal)
      .def_property_readonly("passable", &Planner::passable,
                             py::return_value_policy::reference_internal)
      .def_property_readonly("radius", [](const Planner& p) { return p.robot().radius; })
      .def("clear", &Planner::clear)
      .def("widest_disc", &widest_disc)
      .def("prepared", &prepared)
      .def("limit_own_graph", &Planner::limit_own_graph)
      .def("load_preparation", &load_preparation)
      .def("save_preparation",
           [](const Planner& planner, const std::string& file) {
             const py::gil_scoped_release released;
             planner.save_preparation(file);
           })
      .def("plan", &plan)
      .def("edited", &edited)
      .def("exclude", &changed<static_cast<Change>(&Planner::exclude)>)
      .def("allow", &changed<static_cast<Change>(&Planner::allow)>)
      .def("excluded", &excluded)
      .def("connected",
           [](const Planner& planner, Cell a, Cell b, const std::string& corners) {
             const Corners rule = corners_from(corners);
             const py::gil_scoped_release released;
             return planner.connected(a, b, rule);
           })
      .def("nearest_free", &Planner::nearest_free)
      .def("components",
           [](const Planner& planner, const std::string& corners) {
             const Corners rule = corners_from(corners);
             const py::gil_scoped_release released;
             return planner.components(rule);
           })
      .def("preparation", [](const Planner& p) { return preparation(p.preparation()); })
      .def("footprint", [](const Planner& p) {
        const auto bytes = p.footprint();
        return py::make_tuple(bytes.bitmap, bytes.components, bytes.visibility_graph);
      });
}

}  // namespace lasius::python
