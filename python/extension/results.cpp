#include "python/extension/results.h"

#include "lasius/status.h"

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
                        r.optimal, r.iterations, curves(r));
}

py::tuple fields(const Result& r) {
  py::list curve;
  for (const CurvePiece& piece : r.curve)
    curve.append(py::make_tuple(piece.from, piece.to, piece.turn,
                                piece.turn == 0 ? py::object(py::none()) : py::cast(piece.centre),
                                piece.radius, piece.angle));
  return py::make_tuple(search_fields(r), to_array(std::span(r.path)), r.way_out, r.goal_reached,
                        r.nearest_free, r.nearest_reachable, r.own_rules, py::tuple(curve));
}

}  // namespace lasius::python
