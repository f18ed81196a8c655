// Costs: weights of cells, plans over them, proofs as text.
#include "lasius/cost/planner.h"
#include "lasius/io/json.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/names.h"
#include "python/extension/progress.h"
#include "python/extension/results.h"

namespace lasius::python {
namespace {

std::span<const double> span_of(const Rows& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// Rows and columns of an array of cells. @throws py::value_error
std::pair<int, int> size_of(const py::array& cells) {
  if (cells.ndim() != 2) throw py::value_error("costs are an array (height, width)");
  return {static_cast<int>(cells.shape(1)), static_cast<int>(cells.shape(0))};
}

CostField of_weights(const Rows& weights) {
  const auto [width, height] = size_of(weights);
  return CostField(width, height, span_of(weights));
}

void add_layer(CostField& costs, const Rows& values, double factor) {
  const auto [width, height] = size_of(values);
  if (width != costs.width() || height != costs.height())
    throw py::value_error("the layer has " + std::to_string(height) + " rows of " +
                          std::to_string(width) + " values, the costs " +
                          std::to_string(costs.height()) + " of " + std::to_string(costs.width()));
  costs.add(span_of(values), factor);
}

py::array_t<double> weights(const CostField& costs) {
  return py::array_t<double>({costs.height(), costs.width()}, costs.weights().data());
}

using Bytes = py::array_t<std::uint8_t, py::array::c_style>;

py::tuple costmap(const Bytes& values, double weight, bool unknown_is_free) {
  const auto [width, height] = size_of(values);
  Costmap made =
      read_costmap(width, height, {values.data(), static_cast<std::size_t>(values.size())}, weight,
                   unknown_is_free);
  return py::make_tuple(std::move(made.grid), std::move(made.costs));
}

/// (error, (fields of Result), cost, gap, proof as JSON or None)
py::tuple plan_over(const CostPlanner& planner, Cell start, Cell goal, bool eight_moves,
                    const std::string& corners, bool proof, double target_gap,
                    double goal_tolerance, std::optional<double> time_limit,
                    const py::object& callback) {
  Call call(time_limit);
  const CostOptions options{.observer = observer<GridProgress>(call, callback),
                            .eight_moves = eight_moves,
                            .corners = corners_from(corners),
                            .proof = proof};
  std::optional<std::string> proven;
  const CostResult result = call.run([&] {
    CostResult found =
        planner.plan({start, goal, call.condition(), target_gap, goal_tolerance}, options);
    if (found.proof) proven = proof_to_json(*found.proof);
    return found;
  });
  return py::make_tuple(call.error(), lasius::python::fields(result), result.cost, result.gap(),
                        proven);
}

}  // namespace

void bind_costs(py::module_& module) {
  py::class_<CostField>(module, "CostField")
      .def(py::init<int, int>())
      .def_static("of_weights", &of_weights)
      .def("add", &add_layer)
      .def("inflate",
           [](CostField& costs, const Grid& grid, double radius, double scaling, double weight,
              double inscribed) {
             costs.add(
                 grid,
                 {.radius = radius, .scaling = scaling, .weight = weight, .inscribed = inscribed});
           })
      .def("weights", &weights);
  module.def("read_costmap", &costmap);
  module.def("path_cost", [](const Grid& grid, const CostField& costs, const Rows& path) {
    return path_cost(grid, costs, points_from(path, "path"));
  });
  py::class_<CostPlanner>(module, "CostPlanner")
      .def(py::init<Planner, const CostField&>(), py::call_guard<py::gil_scoped_release>())
      .def("plan", &plan_over);
}

}  // namespace lasius::python
