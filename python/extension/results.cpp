#include "python/extension/results.h"

#include <type_traits>

#include "lasius/base/status.h"
#include "lasius/path/poses.h"
#include "python/extension/modules.h"

namespace lasius::python {

py::object curves(const Convergence& c) {
  if (c.iterations == 0 && c.best.empty()) return py::none();
  return py::make_tuple(to_array(c.best), to_array(c.mean), to_array(c.arrived),
                        to_array(c.raw_best), to_array(c.cut_mean), to_array(c.cut_best),
                        to_array(c.iteration_best), to_array(c.steps), to_array(c.band),
                        to_array(c.trail_entropy));
}

py::tuple search_fields(const SearchResult& r) {
  return py::make_tuple(text(to_string(r.status)), text(to_string(r.limit)),
                        text(to_string(r.fault)), r.error, r.length, r.lower_bound, r.gap(),
                        r.optimal, r.curves.iterations, curves(r.curves));
}

py::tuple fields(const Result& r) {
  py::list curve;
  for (const CurvePiece& piece : r.curve)
    curve.append(py::make_tuple(piece.from, piece.to, piece.turn,
                                piece.turn == 0 ? py::object(py::none()) : py::cast(piece.centre),
                                piece.radius, piece.angle));
  py::list others;
  for (const Alternative& other : r.alternatives)
    others.append(py::make_tuple(to_array(std::span(other.path)), other.length));
  return py::make_tuple(search_fields(r), to_array(std::span(r.path)), r.way_out, r.goal_reached,
                        r.nearest_free, r.nearest_reachable, r.own_rules, py::tuple(curve),
                        py::tuple(others));
}

namespace {

/// A piece of a curve as fields() gives it.
CurvePiece piece_from(const py::tuple& fields) {
  CurvePiece piece{.from = fields[0].cast<Point>(),
                   .to = fields[1].cast<Point>(),
                   .turn = fields[2].cast<int>(),
                   .angle = fields[5].cast<double>(),
                   .radius = fields[4].cast<double>()};
  if (piece.turn != 0) piece.centre = fields[3].cast<Point>();
  return piece;
}

/// Rows x, y, yaw; in metres of a map of so many rows where it has a frame.
py::array_t<double> poses_of(const Rows& path, const py::tuple& curve, double spacing,
                             const std::optional<WorldFrame>& frame, int height) {
  Result result;
  result.path = points_from(path, "path");
  for (const py::handle piece : curve)
    result.curve.push_back(piece_from(py::reinterpret_borrow<py::tuple>(piece)));
  std::vector<Pose> found = poses(result, spacing);
  if (frame)
    for (Pose& pose : found) pose = to_world(*frame, pose, height);
  static_assert(std::is_standard_layout_v<Pose> && sizeof(Pose) == 3 * sizeof(double));
  return py::array_t<double>({static_cast<py::ssize_t>(found.size()), py::ssize_t{3}},
                             reinterpret_cast<const double*>(found.data()));
}

}  // namespace

void bind_results(py::module_& module) { module.def("poses", &poses_of); }

}  // namespace lasius::python
